"""Studies that decided something and are kept."""
