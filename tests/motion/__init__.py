"""Tests of how the wheelset moves, and of the creepages of its patches."""
