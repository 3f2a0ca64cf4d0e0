"""How the wheelset moves, how fast each patch slides and turns on its rail, and the creep force that follows."""
