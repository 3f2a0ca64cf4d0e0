"""A bogie and a railway vehicle in exudyn, a multibody program, on contacts by wrcontact (docs/vehicle.md)."""
