"""Tests of contact patches and their outlines."""
