"""How iterations are differentiated."""
