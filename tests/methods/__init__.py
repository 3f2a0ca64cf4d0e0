"""Tests of the choice of methods and resolution."""
