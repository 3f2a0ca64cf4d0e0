"""A wheelset as a body of Drake and of MuJoCo: docs/guides/solvers.md."""
