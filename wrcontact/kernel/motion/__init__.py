"""How the wheelset moves, and how fast each patch of a wheel slides and turns on its rail."""
