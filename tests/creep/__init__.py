"""Creep forces of a single patch."""
