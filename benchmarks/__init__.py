"""Run time and error; ``python -m benchmarks --readme`` prints the table in the README."""
