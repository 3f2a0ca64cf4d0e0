"""Tests of the FMUs."""
