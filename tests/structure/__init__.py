"""Tests of the structure of the code, and tests of the tests."""
