"""The neighbourhood of a contact: frame, regions, planes, undeformed distance, overlap of a pressed wheel."""
