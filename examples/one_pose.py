"""One pose, 1 mm to the right.  Prints the right contact and draws both wheels on their rails:
one_pose.png."""

import wrcontact
from wrcontact.plots import pose_figure, save

system = wrcontact.ContactSystem(wheel="S1002", rail="UIC60", rail_inclination=1 / 40)
state = system.evaluate(lateral_shift=1e-3, yaw=0.0, normal_force=78.5e3)
right = state.right

print(f"roll {state.roll * 1e6:.3f} microrad, status {state.status.name}")
print(
    f"contact on the right wheel at y = {right.contact.y_wheel * 1e3:.4f} mm, angle "
    f"{right.contact_angle:.5f} rad"
)
print(f"patch {right.area * 1e6:.1f} mm2, largest pressure {right.max_pressure / 1e6:.0f} MPa")
save(pose_figure(system, state), "one_pose.png")

# an independent brute-force search finds the same position (data/rigid_positions.csv)
assert abs(right.contact.y_wheel - -9.3566677e-3) < 1e-9  # [m]
