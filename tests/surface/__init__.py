"""Tests of what a surface is."""
