"""Tables of contacts over a grid of inputs: computed in blocks, kept in a Zarr store, interpolated."""
