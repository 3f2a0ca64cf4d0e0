"""A wheelset on its primary suspension runs on the contact FMU: docs/guides/closed_loop.md."""
