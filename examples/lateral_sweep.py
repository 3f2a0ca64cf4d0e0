"""A wheelset moves across the track: contact position and largest pressure of the right wheel.  Draws
lateral_sweep.png."""

import matplotlib.pyplot as plt
import numpy as np

import wrcontact

shift = np.linspace(-8e-3, 8e-3, 3201)  # [m]
table = wrcontact.ContactSystem().evaluate_many(lateral_shift=shift, yaw=0.0, normal_force=78.5e3)
place = table.right.contact.y_wheel

# the contact jumps from the tread to the flange root where two minima of the gap are equal
first = int(np.argmax(place < -26e-3))  # the flange root of the S1002 begins at y = -26 mm
print(
    f"tread to flange root at {shift[first] * 1e3:.3f} mm: y_wheel {place[first - 1] * 1e3:.1f} -> "
    f"{place[first] * 1e3:.1f} mm"
)

figure, (above, below) = plt.subplots(2, 1, sharex=True, layout="constrained")
above.plot(shift * 1e3, place * 1e3, ".", markersize=1.5)
above.set(ylabel="right contact at [mm]")
below.plot(shift * 1e3, table.right.max_pressure / 1e6, ".", markersize=1.5)
below.set(xlabel="lateral shift, to the right + [mm]", ylabel="largest pressure [MPa]")
figure.savefig("lateral_sweep.png", dpi=150)

assert abs(shift[first] - 4.8479e-3) < 5e-6  # [m], the step of the sweep
