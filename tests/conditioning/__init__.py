"""Tests of the check of a pair of profiles."""
