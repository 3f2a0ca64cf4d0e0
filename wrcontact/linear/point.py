"""Linearisation of a wheelset on its track, from the exact derivatives of its contact."""

import math

import numpy as np

from ..creep.linear import LEAST, MOST, kalker_coefficients
from ..status import Status, explain
from .record import COORDINATES, Linearization, PatchCoefficients

#: Inputs of a compliant wheelset for the coordinates, and for how fast they change.
PLACES = ("lateral_shift", "vertical_shift_input", "roll_input", "yaw")
RATES = ("lateral_velocity", "vertical_velocity", "roll_rate", "yaw_rate")
#: What the generalised forces are made of; the pressures alone have the same names behind "normal.".
FORCES = ("force.y", "force.z", "moment.x", "moment.y", "moment.z")
WHOLE, PRESSURES = FORCES, tuple(f"normal.{name}" for name in FORCES)
#: Newton's steps for height and roll, and how well the loads are met [of the load; of the load times 1 m].
STEPS, MET = 100, 1e-9
#: Beside a jump of a load, as where a patch gets another part, the place is known to this [m, rad], if it is a
#: small one [of the load].
SHARP, JUMP = 1e-9, 2e-2
#: Largest step of height [m] and roll [rad], within which Hertz's stiffness is of use.
LONGEST = np.array([1e-4, 1e-4])
#: Inputs that this function determines itself.
OWN = frozenset(PLACES[1:3] + RATES)
#: Phases of the motion for quasi-linear matrices.
PHASES = 64
#: I w yaw' in the equation of the roll, and -I w roll' in that of the yaw.
ROTATION = np.zeros((4, 4))
ROTATION[2, 3], ROTATION[3, 2] = 1.0, -1.0


def linearize(system, *, amplitude=0.0, yaw_amplitude=0.0, frequency=0.0, phases=PHASES, **inputs):
    """The :class:`Linearization` of a compliant ``system``; see :meth:`ContactSystem.linearize`."""
    _check(system, amplitude, yaw_amplitude, frequency, phases, inputs)
    if not amplitude:
        return _at(system, inputs)[0]
    middle, held = _at(system, inputs)
    pair = middle.condensed()
    sums = {name: np.zeros((2, 2)) for name in MATRICES}
    forces = np.zeros(2)
    for phase in 2.0 * np.pi * (np.arange(phases) + 0.5) / phases:
        one, held = _at(system, *_swung(inputs, held, amplitude, yaw_amplitude, frequency, phase))
        one = one.condensed()
        # lateral shift and yaw rate swing with the sine of the phase, yaw and lateral velocity with its cosine
        with_sine, with_cosine = 2.0 * math.cos(phase) ** 2, 2.0 * math.sin(phase) ** 2
        for name, total in sums.items():
            fast = name in ("normal_damping", "creep_damping", "rotation")
            weights = (with_cosine, with_sine) if fast else (with_sine, with_cosine)
            total += getattr(one, name) * weights / phases
        forces += one.forces / phases
    return Linearization(
        coordinates=pair.coordinates,
        forces=forces,
        speed=middle.speed,
        wheel_rate=middle.wheel_rate,
        place=middle.place,
        amplitude=float(amplitude),
        patches=middle.patches,
        **sums,
    )


MATRICES = ("normal_stiffness", "creep_stiffness", "normal_damping", "creep_damping", "rotation")


def _check(system, amplitude, yaw_amplitude, frequency, phases, inputs):
    """Refuse what has no linear motion, in a sentence."""
    for name in OWN & set(inputs):
        raise ValueError(
            f"{name} is given; linearize finds the height and the roll itself, and all rates are 0"
        )
    numbers = {
        "amplitude": (amplitude, "m"),
        "yaw_amplitude": (yaw_amplitude, "rad"),
        "frequency": (frequency, "rad/s"),
    }
    for name, (value, unit) in numbers.items():
        if not 0.0 <= value < math.inf:
            raise ValueError(f"{name} is {value!r}; permitted are 0 and numbers above, in {unit}")
    if not isinstance(phases, int) or phases < 4:
        raise ValueError(f"phases is {phases!r}; permitted are whole numbers from 4")
    if not amplitude and (yaw_amplitude or frequency):
        raise ValueError(
            "yaw_amplitude or frequency is given; it is permitted only with an amplitude above 0"
        )
    if system.parameters["tangential_model"] != "none" and not inputs.get("speed"):
        raise ValueError(
            "speed is 0; permitted with a tangential_model is another speed, in m/s: creep forces have no "
            "derivatives at standstill"
        )


def _swung(inputs, held, amplitude, yaw_amplitude, frequency, phase):
    """Inputs at a ``phase`` of the motion, and the height, the roll and their slopes where the search begins."""
    sine, cosine = math.sin(phase), math.cos(phase)
    given = dict(inputs)
    given["lateral_shift"] = inputs.get("lateral_shift", 0.0) + amplitude * sine
    given["yaw"] = inputs.get("yaw", 0.0) + yaw_amplitude * cosine
    given["lateral_velocity"] = frequency * amplitude * cosine
    given["yaw_rate"] = -frequency * yaw_amplitude * sine
    return given, held


def _at(system, inputs, held=None):
    """The record at one place with the ``inputs``, and (height, roll, their slopes (2, 2)) there.

    ``held`` is where the search begins, else at the equilibrium of the elastic wheelset.  Height and roll follow
    the lateral and the yaw rate among the inputs, with the slopes where the search begins.
    """
    start = system.evaluate(**inputs)
    load = 2.0 * start.inputs.normal_force
    arm = 0.5 * system.parameters["running_circle_distance"]
    wanted = np.array([-load, -load * start.inputs.load_transfer * arm])
    moving = np.array([start.inputs.lateral_velocity, start.inputs.yaw_rate])
    unknown, slopes = held or _balanced(start, inputs)
    before, least, moves = None, math.inf, bool(moving.any())
    for _ in range(STEPS):
        follow = dict(zip(PLACES[1:3], unknown)) | dict(zip(RATES[1:3], slopes @ moving))
        state = system.evaluate(**{**inputs, **follow})
        if state.status != Status.VALID:
            if before is not None:
                unknown = 0.5 * (before + unknown)
            elif held:
                held, (unknown, slopes) = None, _balanced(start, inputs)
            else:
                _refuse(state.status, state, inputs)
            continue
        forces, by = _generalised(system, {**inputs, **follow}, state)
        if moves:  # once: slopes that jump beside a jump of the load would keep the search from ending
            slopes, moves = _slopes(by), False
            continue
        missing = forces[WHOLE][1:3] - wanted
        stiff = by[WHOLE][1:3]
        if abs(missing).max() <= MET * load:
            break
        if before is not None and abs(missing).max() > least:  # beside a kink or a jump: half the step
            if abs(unknown - before).max() <= SHARP and abs(missing).max() <= JUMP * load:
                break
            unknown = 0.5 * (before + unknown)
            continue
        least = abs(missing).max()
        step = np.linalg.solve(stiff[:, 1:3], -missing)
        before = unknown
        unknown = unknown + step * min(1.0, (LONGEST / np.maximum(abs(step), 1e-300)).min())
    else:
        if held:  # from elsewhere
            return _at(system, inputs)
        raise RuntimeError(
            f"no height and roll carry the load {_words(inputs)}: a wheelset with this force "
            "on its flange tips"
        )
    slopes = _slopes(by)
    normal = by[PRESSURES]
    creep = by[WHOLE] - normal
    found = Linearization(
        coordinates=COORDINATES,
        normal_stiffness=-normal[:, :4],
        creep_stiffness=-creep[:, :4],
        normal_damping=-normal[:, 4:],
        creep_damping=-creep[:, 4:],
        rotation=ROTATION,
        forces=forces[WHOLE],
        speed=float(state.inputs.speed),
        wheel_rate=float(state.right.wheel_rate_found),
        place=(float(state.inputs.lateral_shift), *map(float, unknown), float(state.inputs.yaw)),
        amplitude=0.0,
        patches=tuple(_patches(system, state)),
    )
    return found, (unknown, slopes)


def _slopes(by):
    """How height and roll follow lateral shift and yaw (2, 2) while both wheels keep their loads: by the pressures
    alone, which is kinematics."""
    held = by[PRESSURES][1:3]
    return -np.linalg.solve(held[:, 1:3], held[:, [0, 3]])


def _balanced(state, inputs):
    """Height and roll of the elastic wheelset, and slopes that are not known yet."""
    balanced = state.equilibrium
    _refuse(balanced.status, state, inputs)
    return np.array([balanced.vertical_shift, balanced.roll]), np.zeros((2, 2))


def _generalised(system, inputs, state):
    """Generalised forces (4,) of all and of the pressures alone, and their derivatives (4, 8) by places and
    rates, by the names of their parts."""
    by = system.derivatives(WHOLE + PRESSURES, PLACES + RATES, **inputs)
    yaw = state.inputs.yaw
    cosine, sine = math.cos(yaw), math.sin(yaw)
    forces, rates = {}, {}
    for names, rows, part in ((WHOLE, by[:5], state), (PRESSURES, by[5:], state.normal)):
        y, z, about_x, about_y, about_z = (
            part.force.y,
            part.force.z,
            part.moment.x,
            part.moment.y,
            part.moment.z,
        )
        forces[names] = np.array([y, z, about_x * cosine + about_y * sine, about_z])
        rolling = rows[2] * cosine + rows[3] * sine
        rolling[3] += -about_x * sine + about_y * cosine
        rates[names] = np.array([rows[0], rows[1], rolling, rows[4]])
    return forces, rates


def _patches(system, state):
    """:class:`PatchCoefficients` of the loaded patches."""
    ratio = system.parameters["poisson_ratio"]
    shear = system.parameters["youngs_modulus"] / (2.0 * (1.0 + ratio))
    for side in ("left", "right"):
        for number, patch in enumerate(getattr(state, side).patches, 1):
            if not patch.normal_force > 0.0:
                continue
            shape = patch.length / patch.width
            product = patch.area / math.pi
            found = kalker_coefficients(min(max(shape, LEAST), MOST), ratio)
            c11, c22, c23, c33 = (float(value) for value in found)
            yield PatchCoefficients(
                side,
                number,
                float(patch.normal_force),
                float(patch.contact_angle),
                math.sqrt(product * shape),
                math.sqrt(product / shape),
                c11,
                c22,
                c23,
                c33,
                shear * product * c11,
                shear * product * c22,
                shear * product**1.5 * c23,
                shear * product**2 * c33,
            )


def _refuse(status, state, inputs):
    """No steady motion where the step has no answer, or a wheel has lifted."""
    if status != Status.VALID:
        raise RuntimeError(f"there is no steady motion {_words(inputs)}: {explain(status, state.inputs)}")


def _words(inputs):
    return f"at a lateral_shift of {inputs.get('lateral_shift', 0.0):g} m and a yaw of {inputs.get('yaw', 0.0):g} rad"
