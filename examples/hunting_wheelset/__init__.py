"""A wheelset on its primary suspension runs on the contact FMU: docs/closed_loop.md."""
