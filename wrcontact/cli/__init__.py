"""The command line ``wrcontact``.  It calls the package and computes nothing itself."""

from .commands import main

__all__ = ["main"]
