"""Tests of the equilibrium of the wheelset and what a step computes."""
