"""The tables that are made once, from profiles and parameters."""
