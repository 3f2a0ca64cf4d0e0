"""Translation of the kernel's modules to C; tools/transpile_kernel.py is the command."""
