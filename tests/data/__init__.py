"""Programs of data/ against each other, Hertz and CONTACT."""
