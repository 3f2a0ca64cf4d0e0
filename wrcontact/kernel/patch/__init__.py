"""The solved contact patches, their totals and their outline."""
