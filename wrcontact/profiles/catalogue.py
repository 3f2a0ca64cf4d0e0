"""Standard profiles from their defining zones, and the profile that an argument means.

Wheel
    S1002: EN 13715 / UIC 510-2, zones A to H.
    cone20, cone40: cones of 1:20 and 1:40 without flange.
Rails
    crown R300, shoulder R80, gauge corner R13, side 1:20, tangent to each other and symmetric:
    UIC60 (the widths of the Manchester benchmark's rail), 60E1 and 54E1 (EN 13674-1).
"""

import math
import os
from functools import cache

from ..interface.parameters import on_the_left
from ..methods.words import did_you_mean
from .files import of_kind, read_profile, smoothing_in_mm
from .options import ProfileFile
from .profile import Profile
from .zones import Arc, Polynomial, mirror_zone


def s1002():
    """Wheel profile S1002, zones H to A from the flange back to the field side [mm]."""
    zones = (
        Arc(-70.0, -62.764705882, 20.5, -49.5, 9.519259302, +1),
        Arc(-62.764705882, -49.662510381, 12.0, -55.0, 16.0, +1),
        Arc(-49.662510381, -39.764473993, 20.0, -58.558326413, 8.834924130, +1),
        Polynomial(-39.764473993, -38.426669071, (-93.576667419, -2.747477419)),
        Arc(-38.426669071, -35.0, 13.0, -26.210665, 16.446, -1),
        Polynomial(
            -35.0,
            -26.0,
            (
                -4.320221063e3,
                -1.038384026e3,
                -1.065501873e2,
                -6.051367875,
                -2.054332446e-1,
                -4.169739389e-3,
                -4.687195829e-5,
                -2.252755540e-7,
            ),
        ),
        Polynomial(
            -26.0,
            32.15796,
            (
                0.0,
                -3.358537058e-2,
                1.565681624e-3,
                -2.810427944e-5,
                5.844240864e-8,
                -1.562379023e-8,
                5.309217349e-15,
                -5.957839843e-12,
                2.646656573e-13,
            ),
        ),
        Polynomial(32.15796, 60.0, (1.364323640, -0.066666667)),
    )
    return Profile("S1002", "wheel", zones)


def cone(name, run):
    """A cone that rises by 1 in ``run`` towards the field side, without flange [mm], for comparison with
    closed forms: its equivalent conicity is 1 / run."""
    return Profile(name, "wheel", (Polynomial(-40.0, 60.0, (0.0, -1.0 / run)),))


def rail_head(name, *, crown_half_width, shoulder_half_width, corner_half_width, depth=40.0):
    """A head of tangent arcs R300, R80, R13 and a side 1:20, symmetric about its top [mm].

    Each arc's centre lies on the line through the neighbour's centre and the joint, so the chain is tangent
    by construction.  The side starts where the R13 arc has the slope 20, or at ``corner_half_width``, and
    continues down to ``depth``.
    """
    crown = Arc(-crown_half_width, crown_half_width, 300.0, 0.0, 300.0, -1)
    shoulder = _tangent_arc(crown, 80.0, crown_half_width, shoulder_half_width)
    corner = _tangent_arc(shoulder, 13.0, shoulder_half_width, corner_half_width)
    tangent = corner.y_centre + corner.radius * 20.0 / math.sqrt(401.0)
    corner = Arc(corner.start, tangent, corner.radius, corner.y_centre, corner.z_centre, -1)
    z_side = float(corner(tangent)[0])
    side = Polynomial(tangent, tangent + (depth - z_side) / 20.0, (z_side, 20.0), tangent)
    half = (shoulder, corner, side)
    return Profile(name, "rail", tuple(mirror_zone(zone) for zone in reversed(half)) + (crown,) + half)


def _tangent_arc(previous, radius, start, stop):
    """The arc of ``radius`` from ``start`` to ``stop`` that continues ``previous`` with the same tangent at
    ``start``."""
    share = 1.0 - radius / previous.radius
    z_start = float(previous(start)[0])
    return Arc(
        start,
        stop,
        radius,
        previous.y_centre + share * (start - previous.y_centre),
        previous.z_centre + share * (z_start - previous.z_centre),
        -1,
    )


BUILDERS = {
    "S1002": s1002,
    "cone20": lambda: cone("cone20", 20.0),
    "cone40": lambda: cone("cone40", 40.0),
    "UIC60": lambda: rail_head(
        "UIC60", crown_half_width=10.5, shoulder_half_width=25.988023, corner_half_width=36.0
    ),
    "60E1": lambda: rail_head(
        "60E1", crown_half_width=10.228, shoulder_half_width=26.0265, corner_half_width=36.0
    ),
    "54E1": lambda: rail_head(
        "54E1", crown_half_width=10.012, shoulder_half_width=24.864, corner_half_width=35.0
    ),
}
WHEELS = ("S1002", "cone20", "cone40")
RAILS = ("UIC60", "60E1", "54E1")
NAMES = {"wheel": WHEELS, "rail": RAILS}


#: What may have happened where a wheel's profile is a rail's.
SWAPPED = "; did you swap wheel and rail?"


@cache
def standard_profile(name):
    """The built-in profile called ``name``; KeyError if there is none."""
    return BUILDERS[name]()


def standard_name(name):
    """The built-in profile's name that differs from ``name`` at most in case; None if there is none."""
    return next((known for known in BUILDERS if known.lower() == name.lower()), None)


def find_profile(source, kind, smoothing=None, argument=None, track=None):
    """The profile for ``source``: a :class:`Profile`, a standard name, the path of a file, or a
    :class:`ProfileFile`.

    ``kind`` is "wheel" or "rail"; ``smoothing`` [m] is that of :meth:`Profile.from_file`; ``argument`` is
    what the user calls the profile, by default its kind; ``track`` is the inclination of its rails [1], None
    where it is not known.  The case of a name has no effect, unless a file has
    this very name.  ValueError, in one sentence, if ``source`` is none of these.
    """
    smoothing_in_mm(smoothing)
    if isinstance(source, Profile):
        return of_kind(source, kind)
    if isinstance(source, ProfileFile) and os.path.isfile(source.path):
        return read_profile(source, kind, smoothing, Profile, track)
    if isinstance(source, str) and source in NAMES[kind]:
        return standard_profile(source)
    if isinstance(source, (str, os.PathLike)) and os.path.isfile(source):
        return read_profile(ProfileFile(source), kind, smoothing, Profile, track)
    missing = ", and there is no such file" if _looks_like_a_path(source) else ""
    others = ", the path of a profile file, or a Profile"
    return named_profile(source, kind, argument or kind, others, missing, SWAPPED)


def find_profiles(parameters):
    """Wheel and rail of the right side, wheel and rail of the left side, by the keywords of a
    system."""
    smoothing, track = parameters["smoothing"], parameters["rail_inclination"]
    left_track = on_the_left(parameters)["rail_inclination"]
    right = [find_profile(parameters[kind], kind, smoothing, track=track) for kind in ("wheel", "rail")]
    left = [
        profile
        if parameters[f"left_{kind}"] is None
        else find_profile(parameters[f"left_{kind}"], kind, smoothing, f"left_{kind}", left_track)
        for kind, profile in zip(("wheel", "rail"), right)
    ]
    return *right, *left


def named_profile(source, kind, argument, others, missing="", swapped=""):
    """The standard profile called ``source``, in any case; otherwise a ValueError, which names the
    ``argument``, what is ``missing`` and what is permitted: the names, and ``others``, words that continue
    their list; ``swapped`` continues that the profile is of the other kind."""
    standard = standard_name(source) if isinstance(source, str) else None
    if standard in NAMES[kind]:
        return standard_profile(standard)
    other = f" (a profile of the other kind{swapped})" if standard else ""
    meant = "" if missing or other else did_you_mean(source, NAMES[kind])
    raise ValueError(
        f"{argument} is {str(source)!r}{other}{missing}; permitted are "
        f"{', '.join(NAMES[kind])}{others}{meant}"
    )


def _looks_like_a_path(source):
    """Whether a name that is no profile's is rather that of a file: it has an ending or a folder."""
    return (
        isinstance(source, (ProfileFile, os.PathLike))
        or isinstance(source, str)
        and (bool(os.path.splitext(source)[1]) or os.path.basename(source) != source)
    )
