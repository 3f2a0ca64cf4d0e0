"""Tests of profiles and their files."""
