"""Two different worn wheels run on rails that move: fmpy steps the native FMU, and this program integrates
the motion of the wheelset under the forces of its contacts.  Draws irregular_track.png.

    python examples/irregular_track.py [LEFT_WHEEL_FILE RIGHT_WHEEL_FILE]

Without files it writes two that look like measurements: wheels that are worn to different depths, with noise.
"""

import sys

import fmpy
import matplotlib.pyplot as plt
import numpy as np
from fmpy.fmi2 import FMU2Slave

from wrcontact.fmu.native import build_native_fmus
from wrcontact.profiles import standard_profile

MASS, INERTIA, LOAD = 1500.0, 900.0, 157e3  # [kg], [kg.m2] about x, [N] on both rails: weight and bogie
GUIDE, DAMPER = 5e6, 2e4  # [N/m], [N.s/m] between wheelset and bogie, across the track
SPEED, STEP = 25.0, 1e-4  # [m/s], [s]
WAVELENGTHS = np.array([1.7, 3.1, 6.3, 11.0])  # [m]
AMPLITUDES = {"lateral": 8e-5, "vertical": 5e-5, "roll": 1e-4}  # [m], [m], [rad] for each metre of wave
RAILS = [f"{side}.rail_{part}" for side in ("left", "right") for part in AMPLITUDES]
OUTPUTS = [f"{part}{name}" for part in ("", "left.", "right.") for name in ("force.y", "force.z", "moment.x")]


def worn_wheel(file, depth, seed):
    """A file of points [mm] on an S1002 that is hollow by ``depth`` [m], with 3 um of noise."""
    y = np.arange(-69e-3, 59e-3, 0.2e-3)
    z = standard_profile("S1002").height(y) - depth * np.exp(-((y / 15e-3) ** 2))
    z += 3e-6 * np.random.default_rng(seed).standard_normal(len(y))
    np.savetxt(file, 1e3 * np.column_stack([y, z]), fmt="%.4f")
    return file


def moving_rails(time, seed=1):
    """Displacements and velocities (n, 6) of the rails below a wheelset that has run for ``time`` [s]."""
    sizes = np.tile(list(AMPLITUDES.values()), 2)[:, None] * WAVELENGTHS
    phases = np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi, sizes.shape)
    rates = 2.0 * np.pi * SPEED / WAVELENGTHS
    angles = rates * np.asarray(time)[:, None, None] + phases
    return (sizes * np.sin(angles)).sum(axis=-1), (sizes * rates * np.cos(angles)).sum(axis=-1)


def instance(archive, **parameters):
    """A running instance of the FMU, and value references by name."""
    folder = fmpy.extract(str(archive))
    description = fmpy.read_model_description(folder)
    reference = {variable.name: variable.valueReference for variable in description.modelVariables}
    slave = FMU2Slave(
        guid=description.guid,
        unzipDirectory=folder,
        instanceName="wheelset",
        modelIdentifier=description.coSimulation.modelIdentifier,
    )
    slave.instantiate()
    slave.setupExperiment(startTime=0.0)
    for name, value in parameters.items():
        write = slave.setString if isinstance(value, str) else slave.setReal
        write([reference[name]], [value])
    slave.enterInitializationMode()
    slave.exitInitializationMode()
    return slave, reference


def ride(archive, duration, damping=0.5, outputs=OUTPUTS):
    """Times (n,), rails (n, 6), place and velocity (n, 3) of lateral shift, vertical shift and roll, and
    outputs (n, m).

    It begins at rest, in equilibrium with its load."""
    slave, reference = instance(archive, contact_mode="compliant", contact_damping=damping)
    names = [
        "lateral_shift",
        "vertical_shift_input",
        "roll_input",
        "lateral_velocity",
        "vertical_velocity",
        "roll_rate",
        *RAILS,
        *(f"{name}_velocity" for name in RAILS),
    ]
    inputs, wanted = [reference[name] for name in names], [reference[name] for name in outputs]
    forces = [reference[name] for name in ("force.y", "force.z", "moment.x")]
    time = np.arange(0.0, duration, STEP)
    rails, moving = moving_rails(time)
    slave.setReal(
        [reference["normal_force"], reference["speed"], *inputs[6:12]], [LOAD / 2, SPEED, *rails[0]]
    )
    place = np.array(
        [0.0, *slave.getReal([reference["equilibrium.vertical_shift"], reference["equilibrium.roll"]])]
    )
    velocity, seen = np.zeros(3), []
    for now, rail, motion in zip(time, rails, moving):
        slave.setReal(inputs, [*place, *velocity, *rail, *motion])
        slave.doStep(now, STEP)
        across, down, turning = slave.getReal(forces)
        seen.append([*place, *velocity, *slave.getReal(wanted)])
        across -= GUIDE * place[0] + DAMPER * velocity[0]
        velocity += STEP * np.array([across / MASS, (down + LOAD) / MASS, turning / INERTIA])
        place += STEP * velocity  # with the new velocity: Euler's symplectic method keeps energy
    slave.terminate()
    slave.freeInstance()
    return time, rails, *np.split(np.array(seen), [3, 6], axis=1)


if __name__ == "__main__":
    left, right = sys.argv[1:] or (worn_wheel("left.csv", 0.2e-3, 1), worn_wheel("right.csv", 0.6e-3, 2))
    archive = build_native_fmus("out", wheel=(left, right))[0]
    time, rails, place, velocity, seen = ride(archive, duration=1.0)
    figure, axes = plt.subplots(3, sharex=True, figsize=(8, 7), layout="constrained")
    for column, (side, name) in zip((0, 3), (("left", "left rail"), ("right", "right rail"))):
        axes[0].plot(time, 1e3 * rails[:, column + 1], label=name)
        axes[2].plot(time, -1e-3 * seen[:, OUTPUTS.index(f"{side}.force.z")], label=f"{side} wheel")
    axes[1].plot(time, 1e3 * place[:, 0])
    for axis, label in zip(axes, ("rail, down [mm]", "lateral shift [mm]", "vertical force [kN]")):
        axis.set_ylabel(label)
    axes[0].legend(), axes[2].legend(), axes[2].set_xlabel("time [s]")
    figure.savefig("irregular_track.png", dpi=150)

    # the mean force of the rails is the load and what moves the wheelset at the end faster than at the start
    mean, gain = seen[:, OUTPUTS.index("force.z")].mean(), MASS * velocity[-1, 1] / time[-1]
    print(f"mean vertical force {-mean:.1f} N, load {LOAD:.1f} N, change of momentum {gain:.1f} N")
    assert abs(mean + LOAD - gain) < 1e-4 * LOAD
