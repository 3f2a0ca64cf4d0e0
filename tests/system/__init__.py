"""Tests of the whole component."""
