"""A bogie and a railway vehicle in exudyn, a multibody program, on wrcontact (docs/guides/vehicle.md)."""
