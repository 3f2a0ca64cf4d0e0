"""Tests of the search for the rigid contact."""
