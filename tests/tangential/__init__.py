"""Models of creep forces in the kernel."""
