"""The complete theory: elastic bodies on the true gap, along normals that turn with the surfaces. Python
only; the models of the kernel are measured against it."""
