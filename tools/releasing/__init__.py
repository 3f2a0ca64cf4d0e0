"""What a release consists of, for tools/release.py."""
