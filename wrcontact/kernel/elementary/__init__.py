"""Elementary functions with the same bits on every machine, from sums, products, quotients and roots."""
