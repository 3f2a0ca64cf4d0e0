"""The command line ``wrcontact``: a door for people, without a formula of its own."""

from .commands import main

__all__ = ["main"]
