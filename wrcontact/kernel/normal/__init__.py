"""Models of the normal contact: Hertz, ANALYN, strip correction."""
