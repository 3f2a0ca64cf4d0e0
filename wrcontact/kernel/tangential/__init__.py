"""Creep forces of a solved patch."""
