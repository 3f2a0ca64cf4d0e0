"""What several test files use: named cases, witnesses, and programs that run in processes of their own."""
