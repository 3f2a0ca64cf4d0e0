"""The complete theory: the elastic half-space on the true gap. Python only; the models of the kernel
are measured against it."""
