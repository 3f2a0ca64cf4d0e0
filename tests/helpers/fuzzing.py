"""Scenes and poses drawn at random, for tests that try very many of them.

A scene is what stays fixed, a pair of profiles on a track with its methods; it is prepared once and serves a
batch of poses. Half of the poses are drawn evenly over the range, the others beside the shifts at which the
contact jumps from one place of the wheel to another, or reaches the end of a profile::

    for scene, poses in batches(seed=1, scenes=20, poses=500):
        table = scene.system().evaluate_many(**poses.arguments)
        ...
        assert not bad.any(), scene.line(poses, np.flatnonzero(bad)[0]) # a line of Python that is this pose

The same seed gives the same scenes and poses, each scene independently of how many are drawn.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from inspect import signature

import numpy as np

import wrcontact
from wrcontact.methods import CHOICES
from wrcontact.profiles import Profile, standard_profile

RAILS = ("UIC60", "60E1", "54E1")
INCLINATIONS = (0.0, 1 / 40, 1 / 30, 1 / 20)
GAUGES = (1.425, 1.450)  # [m]
RADII = (0.3, 0.7)  # [m]
DEPTHS = (0.008, 0.0135)  # [m] on the rail's corner: its side may lean backwards when inclined
SHIFTS = (-12e-3, 12e-3)  # [m]
YAWS = tuple(np.radians((-6.0, 6.0)))
FORCES = (1e-3, 1e6)  # [N]
GUESSES = (-0.1, 0.1)  # [rad]
OFFSETS = (1e-12, 1e-4)  # [m] from a jump or an end

#: The cheapest system of a scene: where wheels and rails touch, and no normal contact.
GEOMETRY = {"contact_mode": "rigid", "load": "normal", "normal_model": "hertz"}

#: Where a profile is cut off in a share of the scenes, and which of its ends [mm]: wherever they
#: touch, but that the running circle, the highest point of the rail and its inner side, where the
#: gauge is measured, are left.
CUTS = (("wheel", "start", -45.0, -0.5), ("wheel", "stop", 0.5, 30.0), ("rail", "stop", 16.0, 30.0))

GRID = 241  # shifts between which jumps are looked for
ROWS = 4  # yaws of a scene at which they are
# [m] a contact that moves farther from one grid shift to the next may jump between them
MOVED = 3e-4
JUMPED = 2e-5  # [m] and has jumped if it moves this far within SHARP
SHARP = 1e-12  # [m]
COLUMNS = (
    "lateral_shift",
    "yaw",
    "roll_guess",
    "normal_force",
    "load_transfer",
    "vertical_shift_input",
    "roll_input",
)


@dataclass(frozen=True)
class Cut:
    """A standard profile without what lies before ``start`` or behind ``stop`` [mm]."""

    name: str
    start: float = -np.inf
    stop: float = np.inf

    def profile(self):
        whole = standard_profile(self.name)
        kept = [
            replace(zone, start=max(zone.start, self.start), stop=min(zone.stop, self.stop))
            for zone in whole.zones
            if zone.stop > self.start and zone.start < self.stop
        ]
        return Profile(self.name, whole.kind, tuple(kept))

    def __repr__(self):
        ends = [
            f"{name}={float(value)!r}"
            for name, value in (("start", self.start), ("stop", self.stop))
            if np.isfinite(value)
        ]
        return f"cut({', '.join([repr(self.name), *ends])})"


def cut(name, start=-np.inf, stop=np.inf):
    """The standard profile ``name`` without what lies before ``start`` or behind ``stop`` [mm]."""
    return Cut(name, start, stop).profile()


@dataclass(frozen=True)
class Poses:
    """Poses of a batch: the seven inputs of each, (n, 7), in the order of COLUMNS."""

    inputs: np.ndarray

    def __len__(self):
        return len(self.inputs)

    def __getitem__(self, rows):
        """A share of the poses, by a slice, indices or a mask."""
        return Poses(self.inputs[rows].reshape(-1, len(COLUMNS)))

    def __getattr__(self, name):
        if name in COLUMNS:
            return self.inputs[:, COLUMNS.index(name)]
        raise AttributeError(name)

    @property
    def arguments(self):
        """Those of ``evaluate_many``."""
        return {name: np.ascontiguousarray(self.inputs[:, k]) for k, name in enumerate(COLUMNS)}

    def changed(self, **columns):
        """The same poses with other columns."""
        inputs = self.inputs.copy()
        for name, values in columns.items():
            inputs[:, COLUMNS.index(name)] = values
        return Poses(inputs)

    def mirrored(self):
        """The same poses seen in a mirror along the track."""
        signs = [
            -1.0 if name in ("lateral_shift", "yaw", "roll_guess", "load_transfer", "roll_input") else 1.0
            for name in COLUMNS
        ]
        return Poses(self.inputs * signs)

    def call(self, row):
        """``evaluate(...)`` at one pose."""
        given = [
            f"{name}={float(value)!r}"
            for name, value in zip(COLUMNS, self.inputs[row])
            if value != 0.0 or name == "normal_force"
        ]
        return f"evaluate({', '.join(given)})"


@dataclass(frozen=True)
class Scene:
    """A pair of profiles on a track, and methods: the arguments of ContactSystem;
    profiles are names or Cuts."""

    arguments: dict

    def system(self, **changes):
        """The ContactSystem, with ``changes`` to its arguments."""
        arguments = {**self.arguments, **changes}
        for name, value in arguments.items():
            if isinstance(value, Cut):
                arguments[name] = value.profile()
        return wrcontact.ContactSystem(**arguments)

    @property
    def is_cut(self):
        """Whether a profile is cut off where contacts may be, so that status 2 is to be expected."""
        return any(isinstance(value, Cut) for value in self.arguments.values())

    @cached_property
    def geometry(self):
        """The cheapest system: where wheels and rails touch."""
        return self.system(**GEOMETRY)

    def locate(self, shift, yaw):
        """Wheel abscissae [m] of both contacts (n, 2) at these shifts [m] and yaws [rad]; NaN
        where there are none."""
        table = self.geometry.evaluate_many(shift, yaw, outputs="geometry")
        return np.stack([table.left.contact.y_wheel, table.right.contact.y_wheel], axis=1)

    def line(self, poses, row, **changes):
        """One line of Python that evaluates this pose."""
        default = signature(wrcontact.ContactSystem).parameters
        arguments = {**self.arguments, **changes}
        given = ", ".join(
            f"{name}={value!r}" for name, value in arguments.items() if value != default[name].default
        )
        return f"ContactSystem({given}).{poses.call(row)}"


def log_uniform(rng, low, high, count):
    """Numbers whose logarithms are drawn evenly."""
    return np.exp(rng.uniform(np.log(low), np.log(high), count))


def draw_scene(rng, cuts=0.2, **fixed):
    """A scene; ``cuts`` is the share of scenes with a profile that is cut off, ``fixed``
    arguments are not drawn."""
    arguments = {
        "wheel": "S1002",
        "rail": str(rng.choice(RAILS)),
        "rail_inclination": float(rng.choice(INCLINATIONS) if rng.random() < 0.8 else rng.uniform(0.0, 0.1)),
        "gauge": float(1.435 if rng.random() < 0.3 else rng.uniform(*GAUGES)),
        "gauge_depth": float(0.014 if rng.random() < 0.7 else rng.uniform(*DEPTHS)),
        "nominal_radius": float(0.46 if rng.random() < 0.3 else rng.uniform(*RADII)),
    }
    # these wheelsets do not roll: they have no creep forces
    methods = {
        name: str(rng.choice(choices)) for name, choices in CHOICES.items() if name != "tangential_model"
    }
    if methods["contact_mode"] == "compliant":
        methods["load"] = "normal"
    arguments.update(methods)
    if rng.random() < cuts:
        what, end, low, high = CUTS[rng.integers(len(CUTS))]
        arguments[what] = Cut(arguments[what], **{end: float(rng.uniform(low, high))})
    arguments.update(fixed)
    return Scene(arguments)


def find_jumps(scene, yaws):
    """Where the contacts jump at these ``yaws`` [rad]: the shifts before and behind, SHARP apart (n, 2) [m],
    the yaws (n,), and whether it is to the end of a profile (n,)."""
    shift, yaw = np.broadcast_arrays(np.linspace(*SHIFTS, GRID), np.asarray(yaws, dtype=float)[:, None])
    place = scene.locate(shift.ravel(), yaw.ravel()).reshape(*shift.shape, 2)
    far = np.nonzero(distance(place[:, :-1], place[:, 1:]) > MOVED)
    yaw = yaw[:, 1:][far]
    low, high = shift[:, :-1][far], shift[:, 1:][far]
    low_place, high_place = place[:, :-1][far], place[:, 1:][far]
    while len(low) and np.max(high - low) > SHARP:
        middle = 0.5 * (low + high)
        place = scene.locate(middle, yaw)
        before = distance(low_place, place) > distance(place, high_place)
        low, low_place = np.where(before, low, middle), np.where(before[:, None], low_place, place)
        high, high_place = np.where(before, middle, high), np.where(before[:, None], place, high_place)
    jumped = distance(low_place, high_place)
    found = jumped > JUMPED
    return np.stack([low, high], axis=1)[found], yaw[found], np.isinf(jumped[found])


def distance(one, other):
    """How far the contacts are apart [m]; infinite where only one of both poses has contacts."""
    apart = np.abs(one - other).max(axis=-1)
    lost, gone = np.isnan(one).any(axis=-1), np.isnan(other).any(axis=-1)
    return np.where(lost & gone, 0.0, np.where(lost | gone, np.inf, apart))


def draw_yaws(rng, count):
    """Yaws [rad]: most of them even, some zero, some tiny."""
    kind = rng.random(count)
    tiny = rng.choice((-1.0, 1.0), count) * log_uniform(rng, 1e-12, 1e-3, count)
    return np.where(kind < 0.1, 0.0, np.where(kind < 0.2, tiny, rng.uniform(*YAWS, count)))


def draw_poses(rng, scene, count):
    """``count`` poses: half evenly over the range, half beside jumps and ends."""
    shift, yaw = rng.uniform(*SHIFTS, count), draw_yaws(rng, count)
    beside = rng.random(count) < 0.5
    jumps, rows, at_end = find_jumps(scene, draw_yaws(rng, ROWS))
    if len(jumps):
        weight = np.where(at_end, 3.0, 1.0)  # there are more jumps on the profiles than to their ends
        chosen, behind = (
            rng.choice(len(jumps), size=count, p=weight / weight.sum()),
            rng.integers(2, size=count),
        )
        offset = log_uniform(rng, *OFFSETS, count)
        near = np.where(behind == 1, jumps[chosen, 1] + offset, jumps[chosen, 0] - offset)
        shift, yaw = np.where(beside, near, shift), np.where(beside, rows[chosen], yaw)
    guess = np.where(rng.random(count) < 0.5, 0.0, rng.uniform(*GUESSES, count))
    force = np.where(rng.random(count) < 0.01, 0.0, log_uniform(rng, *FORCES, count))
    transfer = rng.uniform(-1.0, 1.0, count)
    kind = rng.random(count)
    transfer = np.where(kind < 0.02, np.sign(transfer), np.where(kind < 0.3, 0.0, transfer))
    poses = Poses(np.stack([shift, yaw, guess, force, transfer, 0.0 * shift, 0.0 * shift], axis=1))
    if scene.arguments.get("contact_mode") == "compliant":
        poses = lay_down(rng, scene, poses)
    return poses


def lay_down(rng, scene, poses):
    """Height and roll of compliant poses: those of rigid contact, sunk in by up to 1
    mm, lifted, and tilted."""
    rigid = scene.geometry.evaluate_many(poses.lateral_shift, poses.yaw, outputs="geometry")
    sink = np.where(rng.random(len(poses)) < 0.9, 1.0, -1.0) * log_uniform(rng, 1e-9, 1e-3, len(poses))
    tilt = rng.choice((-1.0, 0.0, 1.0), len(poses)) * log_uniform(rng, 1e-9, 1e-3, len(poses))
    return poses.changed(
        vertical_shift_input=np.nan_to_num(rigid.vertical_shift) + sink,
        roll_input=np.nan_to_num(rigid.roll) + tilt,
    )


def batches(seed, scenes, poses, first=0, **fixed):
    """``scenes`` scenes, from number ``first`` on, each with ``poses`` poses;
    ``fixed`` as for ``draw_scene``."""
    for number in range(first, first + scenes):
        rng = np.random.default_rng([seed, number])
        scene = draw_scene(rng, **fixed)
        yield scene, draw_poses(rng, scene, poses)
