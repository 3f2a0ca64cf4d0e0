"""Tests of the tables that are prepared once."""
