"""The version of the package, in one place; pyproject.toml reads it without importing the package."""

__version__ = "1.0.0"
