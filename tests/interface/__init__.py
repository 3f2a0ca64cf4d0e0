"""Tests of the table of inputs, parameters and outputs."""
