"""How the kernel's stored tables are made, and what they are made of; tools/make_fixed_tables.py and
tools/make_rolling_*.py are the commands."""
