"""A wheelset with a flat on its right wheel turns over it: how far it falls, where it touches, and its load at one height.
Draws wheel_flat.png."""

import numpy as np

import wrcontact
from wrcontact import plots

length, radius = 0.05, 0.46  # [m]
flat = wrcontact.WheelSections.flat("S1002", length)  # rounded, as after some way

system = wrcontact.ContactSystem(wheel=("S1002", flat), nominal_radius=radius)
turn = np.radians(np.linspace(-6.0, 6.0, 241))
table = system.evaluate_many(wheel_rotation=turn)
fallen = (table.vertical_shift - system.evaluate(wheel_rotation=np.pi).vertical_shift) * 1e3
print(f"on the flat the wheelset is up to {np.nanmax(fallen):.3f} mm lower")
print(f"{(table.status == 3).sum()} of {len(turn)} poses stand on both ends of the flat and have no result")

figure = plots.around_wheel_figure(system, turn)
plots.save(figure, "wheel_flat.png")

# one wheel of two falls by half of what its lowest place is higher: the greatest r cos(phi), 1 degree off the flat's middle
phi, depth = np.linspace(-0.1, 0.1, 100_001), radius - np.sqrt(radius**2 - length**2 / 4)
share = (phi + np.radians(1.0)) * radius / length
lowest = radius - np.where(np.abs(share) < 0.5, depth / 2 * (1 + np.cos(2 * np.pi * share)), 0.0)
expected = radius - (lowest * np.cos(phi)).max()  # [m]
assert abs(np.interp(np.radians(1.0), turn, fallen) * 1e-3 - expected / 2) < 2e-6
