"""Rails whose section changes along the track: their surface, and the smallest gap of a wheel over it, found with proof."""
