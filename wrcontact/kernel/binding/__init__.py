"""How ordinary Python reaches the kernel: its files, its compiled library, its tables."""
