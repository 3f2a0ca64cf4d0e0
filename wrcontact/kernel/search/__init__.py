"""Where wheel and rail touch: the smallest gap of a side, and the roll at which both sides touch."""
