"""Remarks on a pair of profiles, as sentences, the most serious first."""

import math

import numpy as np

from ..profiles.plausible import ROUGH, remarks_on
from ..profiles.remarks import Grave, counted, stretch
from .curves import merged_jumps

# [m] a pair is usable if there is contact up to this shift, the smallest amplitude of the conicity
LEAST_RANGE = 1e-3
RUNNING = 8e-3  # [m] the largest amplitude of the conicity: shifts that occur in operation
STRAIGHT = 3e-3  # [m] shifts that occur on straight track; EN 15302 compares conicities at this amplitude
CLOSE = 1e-3  # [m] a jump closer to the centred position is crossed all the time
MANY = 8  # jumps of one contact within RUNNING: exact profiles have 3 to 5
FAST = 20.0  # rate of the contact position: 10 um of gauge or profile then move it by 0.2 mm
# treads and roots of wheels in use are less steep where they touch, flanges steeper
FLANGE = math.radians(45.0)
OFF_MIDDLE = 0.05e-3  # [m] largest distance of an oscillation's middle from the middle of the track


def sentences(found):
    """The remarks (a tuple of sentences) on the results of ``check``, a Conditioning."""
    equal = found.system.equal_sides
    profiles = [(found.wheel, ""), (found.rail, "")]
    if not equal:
        profiles += [(found.left_wheel, "left "), (found.left_rail, "left ")]
    grave = [remark for profile in profiles for remark in _grave(*profile, found.system)]
    on_profiles = [remark for profile in profiles for remark in _on_profile(*profile)]
    if not math.isfinite(found.usable_shifts[0]):
        return (
            "there is no contact in the centred position: the smallest gap lies at the end of a profile",
            *grave,
            *on_profiles,
        )
    return (
        *grave,
        *_on_range(found.usable, found.usable_shifts, found.flange_shift, found.curves),
        *_on_jumps(found.jumps, found.nearest_jump, equal),
        *_on_moves(found.curves, equal),
        *_on_zones(found.conformal, equal),
        *_on_conicity(found.conicity),
        *on_profiles,
    )


def _named(equal):
    """The sides that remarks name: of equal sides the right one."""
    return ("right",) if equal else ("left", "right")


def _mm(value, digits=2):
    return f"{round(value * 1e3, digits) + 0.0:.{digits}f}"


def _on_range(usable, usable_shifts, flange_shift, curves):
    first, last = usable_shifts
    if not usable:
        yield (
            f"the contact leaves the profiles within 1 mm of the centred position, beyond {_mm(first)} "
            f"... {_mm(last)} mm: the pair cannot be used"
        )
    elif max(first, -last) > -RUNNING:
        yield f"the contact leaves the profiles beyond lateral shifts of {_mm(first)} ... {_mm(last)} mm"
    inside = (curves.lateral_shift >= first) & (curves.lateral_shift <= last)
    lost = np.flatnonzero(inside & np.isnan(curves.roll))
    if len(lost):
        yield f"no contact is found at {len(lost)} of {inside.sum()} lateral shifts between"
    if flange_shift <= 0.0:
        yield "a flange is in contact already in the centred position"
    elif flange_shift < STRAIGHT:
        yield f"the flange touches from {_mm(flange_shift)} mm of lateral shift on"


def _on_jumps(jumps, nearest_jump, equal):
    if nearest_jump < CLOSE:
        nearest = min(jumps, key=lambda jump: (abs(jump.lateral_shift), jump.side == "left"))
        distance = _mm(nearest_jump, 2 if nearest_jump > 0.1e-3 else 3)
        yield (
            f"contact jumps {distance} mm from the centred position, from {_mm(nearest.before, 1)} to "
            f"{_mm(nearest.after, 1)} mm on the {nearest.side} wheel: near it, small changes decide which "
            "place is in contact"
        )
    for side in _named(equal):
        count = sum(abs(jump.lateral_shift) <= RUNNING for jump in merged_jumps(jumps, side))
        if count > MANY:
            yield (
                f"the {side} contact jumps {count} times within {_mm(RUNNING, 0)} mm of lateral shift: "
                f"the "
                "curvatures are rough, or the two profiles are nearly equal there"
            )


def _on_moves(curves, equal):
    near = np.abs(curves.lateral_shift) <= RUNNING
    for side in _named(equal):
        rate = getattr(curves, side).wheel_rate
        rate = np.where(near & np.isfinite(rate), np.abs(rate), 0.0)
        worst = int(np.argmax(rate))
        if rate[worst] > FAST:
            yield (
                f"at {_mm(curves.lateral_shift[worst])} mm the {side} contact moves by {rate[worst]:.0f} "
                f"mm "
                "on its wheel per mm of lateral shift"
            )


def _on_zones(conformal, equal):
    for zone in conformal:
        if zone.side in _named(equal) and zone.start <= RUNNING and zone.stop >= -RUNNING:
            yield (
                f"the {zone.side} contact is conformal from {_mm(zone.start)} to {_mm(zone.stop)} mm: "
                f"wheel and "
                f"rail are within 0.1 mm of each other over up to {_mm(zone.width, 0)} mm, and their "
                f"direction changes there by up to {math.degrees(zone.turn):.0f} deg"
            )


def _on_conicity(conicity):
    aside = [k for k, middle in enumerate(conicity.middle) if abs(middle) > OFF_MIDDLE]
    if aside:
        k = aside[0]
        yield (
            f"a free wheelset oscillates about {_mm(conicity.middle[k])} mm, not about the middle of the "
            f"track, at {_mm(conicity.amplitude[k], 0)} mm amplitude: the rolling radius difference "
            "drives it away from the middle"
        )
    for reason in dict.fromkeys(filter(None, conicity.level_reason)):
        at = ", ".join(
            _mm(value, 0) for value, why in zip(conicity.amplitude, conicity.level_reason) if why == reason
        )
        yield f"there is no equivalent conicity at {at} mm amplitude: {reason}"


def _named_profile(profile, side):
    return f"{side}{profile.kind} profile {profile.name}"


def _grave(profile, side, system):
    """The remark on a profile that may be another one than it is taken for."""
    used = getattr(system, f"{side.strip()}_{profile.kind}".strip("_"))
    standing = remarks_on(used, system.parameters) if profile.kind == "wheel" else ()
    read = profile.reading.remarks if profile.reading else ()
    for remark in (*standing, *(one for one in read if isinstance(one, Grave))):
        yield Grave(f"{_named_profile(profile, side)}: {remark}")


def _on_profile(profile, side):
    name = _named_profile(profile, side)
    for remark in profile.reading.remarks if profile.reading else ():
        if not isinstance(remark, Grave):
            yield f"{name}: {remark}"
    if profile.kinks:
        y, turn = max(profile.kinks, key=lambda kink: abs(kink[1]))
        more = f", and {len(profile.kinks) - 1} more" if len(profile.kinks) > 1 else ""
        yield (
            f"{name} has a kink of {abs(turn) * 1e3:.1f} mrad at y = {_mm(y, 1)} mm, where it is in "
            f"contact{more}"
        )
        outwards = -1.0 if profile.kind == "wheel" else 1.0
        convex = [y for y, turn in profile.kinks if outwards * turn > 0.0]
        if convex:
            yield (
                f"{name} is convex at {counted(len(convex), 'kink')} ({stretch([y * 1e3 for y in convex])}): "
                "the pressure of hertz has no limit there, and is that of the rounding; use another normal_model"
            )
    if profile.roughness > ROUGH:
        yield (
            f"the curvature of {name} scatters by {profile.roughness:.3g} 1/m within 4 mm where it is in "
            "contact: the contact follows noise; use more smoothing"
        )
