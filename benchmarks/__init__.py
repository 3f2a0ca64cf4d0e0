"""Run time and error; ``python -m benchmarks --write`` writes the tables of README and docs."""
