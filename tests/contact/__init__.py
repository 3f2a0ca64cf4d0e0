"""Tests of the neighbourhood of a contact."""
