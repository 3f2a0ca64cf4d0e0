"""Poses as input of CONTACT, the program of Vollebregt, module 1: wheel on rail.

The form of the file, the order of its numbers, their units (mm, N, N/mm2, mm/s, rad) and directions are those of CONTACT's
public user guide and of its example ``mbench_a22_right.inp``, the Manchester benchmark, which the tests repeat.
"""

from __future__ import annotations

import math
import warnings
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from ..conventions import SIDES
from ..interface.friction import Friction
from ..profiles.changing import refuse_changing
from ..profiles.placement import place_rail
from ..profiles.remarks import ProfileWarning
from ..status import Status
from ..storage.atomic import write_atomically

MM = 1e3
#: Distance of the flange back from the running circle [mm], from which CONTACT places the wheels; any number would do.
BACK = 70.0
#: Size of CONTACT's elements along and across [mm].
ELEMENT = 0.2
#: Numbers of a friction law that CONTACT's input of a constant coefficient cannot hold.
LAW = tuple(Friction.__dataclass_fields__)
HEADING = """\
% {title}, {side} wheel, by wrcontact
% The rail's profile is already inclined ({inclination:g}), so CANT is 0.
"""
DIGITS = """\

% {number}: lateral shift {shift:.6g} mm, yaw {yaw:.6g} mrad

  1 MODULE
 {config}2{bound}{tang}1{force}0    C-P-B-T-N-F-S   CONFIG, PVTIME, BOUND,  TANG,   NORM,   FORCE,  STRESS
 {material}    V-L-D-C-M-Z-E   VARFRC, FRCLAW, DISCNS, INFLCF, MATER,  ZTRACK, EWHEEL
 {solver}    H-G-I-A-O-W-R     HEAT, GAUSEI, IESTIM, MATFIL, OUTPUT, FLOW,   RETURN
"""
SOLVER = "   999   100    30     1   1e-5         MAXGS , MAXIN , MAXNR , MAXOUT, EPS\n"
FRICTION = "  {mu:.9g}   {mu:.9g}   FSTAT, FKIN\n"
TRACK = """\
  {nu:.9g}  {nu:.9g}  {shear:.9g}  {shear:.9g}   POISS 1,2,  GG 1,2
  {element:g}  {element:g}  1.0  90d  8.0  4.0   DX, DS, DQREL, A_SEP, D_SEP, D_COMB
  {depth:.9g}  0  {gauge:.9g}  0.0   GAUGHT, GAUGSQ, GAUGWD, CANT
  '{rail}'  0  1.0  0.0   RFNAME, MIRRORY, SCALE, SMOOTH
  0.0  0.0  0.0  0.0  0.0  0.0   DY, DZ, ROLL, VY, VZ, VROLL
  {backs:.9g}  -{back:.9g}  {radius:.9g}   FBDIST, FBPOS, NOMRAD
  '{wheel}'  0  1.0  0.0   WFNAME, MIRRORY, SCALE, SMOOTH
"""
PLACE = """\
  0.0  {y:.9g}  {fz:.9g}  {roll:.12g}  {yaw:.12g}  0.0   S, Y, FZ, ROLL, YAW, PITCH
  {vs:.9g}  {vy:.9g}  {vz:.9g}  {vroll:.9g}  {vyaw:.9g}  {vpitch:.12g}   VS, VY, VZ, VROLL, VYAW, VPITCH
"""


def to_contact(system: Any, state: Any, folder: str | PathLike[str]) -> list[Path]:
    """Write input files of CONTACT for a state or a table, a case for each pose: the paths.

    ``left.inp`` and ``right.inp`` are those of the wheels, with the profiles ``left_wheel.prw``, ``left_rail.prr`` and so
    on beside them.  A case has the place of the wheelset and the vertical force of its wheel; CONTACT finds how deep the
    wheel stands.  With creep forces it rolls steadily at the speed and the rotation of the state, otherwise without friction.

    Parameters
    ----------
    system : the :class:`~wrcontact.ContactSystem` of the state.
    state : of one pose, or a table of all outputs.
    folder : is made if it is not there.

    Raises
    ------
    ValueError
        if a row has no contact, or what CONTACT's module 1 has no number for: a curve, rails that move, a friction law
        that is not constant.
    """
    states = [state] if np.ndim(state.status) == 0 else [state[k] for k in range(len(state))]
    _check(system, states)
    target = Path(folder)
    target.mkdir(parents=True, exist_ok=True)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)
        for side in SIDES:
            _write_profiles(system, side, target)
    paths = [target / f"{side}.inp" for side in SIDES]
    for side, path in zip(SIDES, paths):
        write_atomically(path, _text(system, states, side).encode())
    return paths


def _check(system, states):
    """Refuse what the file cannot hold, in a sentence."""
    refuse_changing(system, "CONTACT")
    for name in LAW:
        given = system.parameters[name]
        usual = Friction.__dataclass_fields__[name].default
        if name.endswith(("ratio", "fall", "reduction")) and given != usual:
            raise ValueError(f"{name} is {given!r}; permitted for CONTACT is constant friction, {usual!r}")
    for number, one in enumerate(states, 1):
        if one.status > Status.UNLOADED:
            raise ValueError(
                f"pose {number} has the status {int(one.status)}; permitted are poses with contact"
            )
        moved = [
            side
            for side in SIDES
            for part in ("lateral", "vertical", "roll")
            if one.inputs[f"{side}.rail_{part}"]
        ]
        if moved or one.inputs["track_curvature"]:
            raise ValueError(
                f"pose {number} has {'a rail that is moved' if moved else 'a track_curvature'}; permitted for CONTACT are "
                "rails in their nominal place on straight track"
            )


def _write_profiles(system, side, folder):
    """The profiles of a side, the rail as it leans."""
    wheel = system.left_wheel if side == "left" else system.wheel
    rail = system.left_rail if side == "left" else system.rail
    given = system.side_parameters(side)
    leaning = place_rail(
        rail,
        inclination=given["rail_inclination"],
        gauge=given["gauge"],
        gauge_depth=given["gauge_depth"],
    ).profile
    wheel.save(folder / f"{side}_wheel.prw")
    leaning.save(folder / f"{side}_rail.prr")


def _text(system, states, side):
    """The input file of one wheel."""
    given = system.side_parameters(side)
    rubs = given["tangential_model"] != "none"
    nu = given["poisson_ratio"]
    rail = system.left_rail if side == "left" else system.rail
    text = HEADING.format(title=system.title, side=side, inclination=given["rail_inclination"])
    track = TRACK.format(
        nu=nu,
        shear=1e-6 * given["youngs_modulus"] / (2.0 * (1.0 + nu)),
        element=ELEMENT,
        depth=MM * given["gauge_depth"],
        gauge=MM * (given["gauge"] + 2.0 * rail.worn_face),
        rail=f"{side}_rail.prr",
        backs=MM * given["running_circle_distance"] - 2.0 * BACK,
        back=BACK,
        radius=MM * given["nominal_radius"],
        wheel=f"{side}_wheel.prw",
    )
    for number, one in enumerate(states, 1):
        wheel, inputs = getattr(one, side), one.inputs
        first = number == 1
        rolls = rubs and (inputs.speed != 0.0 or inputs.wheel_rate != 0.0)
        text += DIGITS.format(
            number=number,
            shift=MM * inputs.lateral_shift,
            yaw=1e3 * inputs.yaw,
            config=int(side == "right"),
            bound=0,
            tang=3 if rolls else 0,
            force=0,
            material="0022033" if first else "0011002",
            solver="0000321" if first else "0100321",
        )
        text += SOLVER if first else ""
        text += FRICTION.format(mu=float(inputs[f"{side}.friction"]) if rolls else 0.3)
        text += track if first else ""
        falls, rolling = _rates(system, inputs)
        text += PLACE.format(
            y=MM * inputs.lateral_shift,
            fz=-wheel.force.z,
            roll=one.roll,
            yaw=float(inputs.yaw),
            vs=MM * inputs.speed,
            vy=MM * inputs.lateral_velocity,
            vz=MM * falls,
            vroll=rolling,
            vyaw=float(inputs.yaw_rate),
            vpitch=-wheel.wheel_rate_found if rolls else 0.0,
        )
    return text + "\n  0 MODULE\n"


def _rates(system, inputs):
    """Vertical velocity [m/s] and roll rate [rad/s]: inputs of compliant contact, and otherwise as both wheels keep their
    contact."""
    if system.parameters["contact_mode"] == "compliant":
        return float(inputs.vertical_velocity), float(inputs.roll_rate)
    moving = np.array([inputs.lateral_velocity, inputs.yaw_rate])
    if not moving.any():
        return 0.0, 0.0
    from ..interface.inputs import INPUTS

    given = {row.keyword: value for row, value in zip(INPUTS, np.asarray(inputs))}
    by = system.derivatives(["vertical_shift", "roll"], ["lateral_shift", "yaw"], **given)
    found = by @ moving
    return (float(found[0]), float(found[1])) if np.isfinite(found).all() else (math.nan, math.nan)
