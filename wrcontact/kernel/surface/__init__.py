"""What a surface is: profile table, contact locus, gap, lateral curvature."""
