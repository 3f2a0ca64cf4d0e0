"""Tests of what happens when something around the program fails."""
