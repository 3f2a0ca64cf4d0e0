"""Run time beside error; ``python -m benchmarks`` prints the table that the README shows."""
