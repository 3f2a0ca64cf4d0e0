"""Models of the normal contact: Hertz, ANALYN, strips."""
