"""Tests of the life cycle of a simulated wheelset."""
