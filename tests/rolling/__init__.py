"""Tests of the reference for creep forces."""
