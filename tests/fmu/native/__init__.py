"""Tests of the native FMUs."""
