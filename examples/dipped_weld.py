"""A wheelset runs over a dipped weld in the right rail: how far it sinks and rolls, where it touches, and its forces along
the track.  Draws dipped_weld.png."""

import numpy as np

import wrcontact
from wrcontact import plots

depth, length = 0.3e-3, 0.2  # [m]
u = np.linspace(-0.25, 0.25, 51)  # [m] positions of the slices
down = np.where(np.abs(u) < length / 2, depth / 2 * (1 + np.cos(2 * np.pi * u / length)), 0.0)
rail = wrcontact.profiles.standard_profile("UIC60")
weld = wrcontact.RailSections(u, [rail] * len(u), places=np.column_stack([0 * u, down]), name="dipped weld")

system = wrcontact.ContactSystem(rail=("UIC60", weld), rail_inclination=0.0)
table = system.evaluate_many(track_position=[-0.2, 0.0], lateral_shift=1e-3)
sunk, rolled = np.diff(table.vertical_shift)[0], np.diff(table.roll)[0]
print(
    f"on the bottom of the weld the wheelset is {sunk * 1e3:.4f} mm lower and rolled by {rolled * 1e3:.4f} mrad"
)
pushed = system.evaluate(track_position=0.04, lateral_shift=1e-3).right
print(
    f"behind it the rail pushes back with {-pushed.force.x:.0f} N, and touches {pushed.contact.x_track * 1e3:.2f} mm ahead"
)

figure = plots.along_track_figure(system, np.linspace(-0.2, 0.2, 161), lateral_shift=1e-3)
plots.save(figure, "dipped_weld.png")

# one wheel of two sinks by about the depth, since the wheel is rounder than the weld is hollow
assert abs(sunk - depth / 2) < 3e-6  # [m]
