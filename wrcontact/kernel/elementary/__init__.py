"""Elementary functions that give the same bits on every machine, from sums, products, quotients and roots alone."""
