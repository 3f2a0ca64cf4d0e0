"""The neighbourhood of a contact: frame, point, regions, planes, undeformed distance, overlap of a pressed wheel."""
