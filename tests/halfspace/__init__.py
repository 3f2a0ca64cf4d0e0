"""Tests of the half-space solver."""
