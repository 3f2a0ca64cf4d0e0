"""The pure table of inputs, parameters and outputs; nothing here imports the kernel."""
