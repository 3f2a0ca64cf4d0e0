"""Tests of the study of the source."""
