"""How the wheelset moves, how its patches slide and turn on the rails, and their creep forces."""
