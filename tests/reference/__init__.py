"""Stored results of other programs, and reference programs that do not import wrcontact."""
