"""Tests of the table of variables and the session."""
