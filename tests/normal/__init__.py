"""Tests of normal contact."""
