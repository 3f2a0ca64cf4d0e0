"""The wheels of a wheelset wear over 200 000 km of a route; draws OUT/wear_of_a_wheel.png.

    python -m examples.wear_of_a_wheel [OUT] [KILOMETRES]

The route has straight track and curves of 1000, 500 and 300 m.  On each of them the wheelset on its primary
suspension runs on the forces of the native contact FMU (examples/hunting_wheelset), as the leading and as the
trailing one of its bogie, on rails that are not quite straight.  The motion is the wheelset's own.  What it
does then wears its wheels by 0.15 mm at most, an FMU is packed with the worn ones, and it runs again.

It takes eight minutes on two cores.  A run is kept in OUT/wear_run and goes on from there when the program is
started again.
"""

import json
import sys
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np

import wrcontact
from examples.hunting_wheelset.coupling import CONTACT, Loop, build_wheelset, unpacked
from examples.hunting_wheelset.wheelset import CONTACT_INPUTS
from wrcontact.fmu.native import build_native_fmus
from wrcontact.plots import save, wear_figure
from wrcontact.profiles.files import prepared_text

#: Radius of the curve [m], share of the distance, speed [m/s].
ROUTE = ((np.inf, 0.70, 30.0), (1000.0, 0.15, 25.0), (500.0, 0.10, 20.0), (300.0, 0.05, 15.0))
SUSPENSION = {
    "longitudinal_stiffness": 8e6,
    "lateral_stiffness": 1e6,
    "lateral_damping": 2e4,
    "longitudinal_damping": 2e4,
    "transition_length": 8.0,
    "canted": 1.0,
}
HALF_WHEELBASE = 1.25  # [m]
FRICTION = 0.3
DURATION, SETTLED, STEP, EVERY = 2.4, 1.2, 1e-4, 100  # [s], [s], [s], steps between poses
WAVELENGTHS = np.array([3.1, 6.3, 11.0, 23.0])  # [m]
AMPLITUDES = {"lateral": 5e-5, "vertical": 3e-5}  # [m] for each metre of wave
RAILS = [f"{side}.rail_{part}" for side in ("left", "right") for part in AMPLITUDES]
MOVING = [f"{name}_velocity" for name in RAILS]
#: Share of the laboratory's dry wear, so that the deepest wear is about 1 mm in 100 000 km.
CALIBRATION = 0.04
DEPTH_STEP, MILEAGE = 1.5e-4, 200e6  # [m]


class OnRails(Loop):
    """The closed loop on rails that move below it."""

    def ride(self, speed, seed):
        """Rows (n, 9 + 8) of the motion and the rails, once it has settled, and the largest status."""
        sizes = np.tile(list(AMPLITUDES.values()), 2)[:, None] * WAVELENGTHS
        phases = np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, sizes.shape)
        rates = 2.0 * np.pi * speed / WAVELENGTHS
        rails, rows, worst = self.contact.ports(RAILS + MOVING), [], 0
        for k in range(round(DURATION / STEP)):
            angles = rates * (k * STEP) + phases
            grown = min(k * STEP / 0.3, 1.0)  # the rails begin to move
            moved = [
                *(grown * (sizes * np.sin(angles)).sum(axis=1)),
                *(grown * (sizes * rates * np.cos(angles)).sum(axis=1)),
            ]
            motion = self.motion.read()
            self.moved.write(motion)
            rails.write(moved)
            self.contact.step(k * STEP, STEP)
            self.taken.write(self.given.read())
            self.wheelset.step(k * STEP, STEP)
            if k * STEP >= SETTLED and k % EVERY == 0:
                worst = max(worst, self.contact.status())
                rows.append([*motion[: len(CONTACT_INPUTS)], *moved])
        return np.array(rows), worst


def section(archives, radius, speed, ahead):
    """What a wheelset does on one section, ``ahead`` of the middle of its bogie by [m]."""
    given = SUSPENSION | {"frame_speed": speed, "curve_curvature": 1.0 / radius, "half_wheelbase": ahead}
    with OnRails(archives, given, friction=FRICTION) as loop:
        return loop.ride(speed, seed=round(min(radius, 1e4)))


def sections():
    """(radius, speed, ahead, share of the distance) of every run; on straight track the wheelsets of a bogie
    do the same."""
    return [
        (radius, speed, sign * HALF_WHEELBASE, share / (1 if np.isinf(radius) else 2))
        for radius, share, speed in ROUTE
        for sign in ((1.0,) if np.isinf(radius) else (1.0, -1.0))
    ]


def simulate(system, folder, pool, wheelset):
    """Tables of states of all sections, and the share of the distance of each row."""
    wheel = folder / "worn.json"
    wheel.write_text(prepared_text(system.wheel))
    archives = build_native_fmus(folder, wheel=wheel, cache=folder / "cache")[0], wheelset
    unpacked(archives[0])
    runs = sections()
    found = pool.map(partial(section, archives), *list(zip(*runs))[:3])
    tables = []
    for (radius, speed, _, share), (rows, worst) in zip(runs, found):
        names = [name.replace(".", "_") for name in (*CONTACT_INPUTS, *RAILS, *MOVING)]
        table = system.evaluate_many(
            **dict(zip(names, rows.T)),
            speed=speed,
            track_curvature=1.0 / radius,
            left_friction=FRICTION,
            right_friction=FRICTION,
        )
        tables.append((table, share / len(rows)))
    return tables


def wear_out(folder, mileage=MILEAGE, law=None):
    """The :class:`wrcontact.WearRun` of the route."""
    folder.mkdir(parents=True, exist_ok=True)
    system = wrcontact.ContactSystem(**CONTACT, wear_outputs=True)
    wheelset = build_wheelset(folder)
    unpacked(wheelset)
    with ProcessPoolExecutor(2) as pool:
        return wrcontact.wear_run(
            partial(simulate, folder=folder, pool=pool, wheelset=wheelset),
            system,
            law or wrcontact.Usfd(calibration=CALIBRATION),
            mileage,
            DEPTH_STEP,
            mirrored=True,
            store=folder / "wear_run",
        )


def laboratory(folder):
    """Deepest wear in the first step by the law without calibration [m per m]."""
    step = json.loads((folder / "wear_run" / "step_00000.json").read_text())
    return max(step["depth"]["right"][1]) / step["length"] / CALIBRATION


if __name__ == "__main__":
    out = Path((sys.argv[1:] or ["out"])[0])
    run = wear_out(out, *(1e3 * float(text) for text in sys.argv[2:3]))
    for step in run.steps:
        shape = step.shapes["right"]
        print(
            f"{step.distance / 1e3:9.0f} km: flange {1e3 * shape.flange_thickness:.3f} mm thick, "
            f"{1e3 * shape.flange_height:.3f} mm high, qR {1e3 * shape.flange_steepness:.3f} mm, "
            f"hollow {1e3 * shape.hollow:.3f} mm, worn {1e6 * shape.worn_area:.1f} mm2, "
            f"conicity {step.conicity:.3f}"
        )
    print(f"laboratory: 1 mm in {1e-3 / laboratory(out) / 1e3:.0f} km; used here: {CALIBRATION:g} of it")
    save(wear_figure(run), out / "wear_of_a_wheel.png")
