"""Standard profiles from the numbers in standards.json, which is read when the first name is asked.

Rails are half a head: ``arcs`` of a radius up to a half-width [mm] from the middle outwards, tangent to each
other, then a straight side of slope dz/dy down to ``depth`` [mm]; or zones. Wheels are zones from the back of the
flange to the field side, as printed; steps between printed numbers are joined. Those of EN 13715 are made of
their designation, such as S1002/h30/e31.5/15%.
"""

import json
import math
import re
from functools import cache
from pathlib import Path

from .profile import JOINT_HEIGHT, PRINTED_STEP, Profile
from .source import Source
from .zones import Arc, Polynomial, joined, lifted, mirror_zone, moved_across

FILE = Path(__file__).with_name("standards.json")
#: A designation of EN 13715: tread, height and thickness of the flange [mm], outer slope [%].
DESIGNATION = re.compile(
    r"(?:en13715(?::\d{4})?[-–—_/:]*)?(s1002|1-40|1/40)[/_]h([\d.]+)[/_]e([\d.]+)[/_]([\d.]+)%?"
)
#: What is meant to be one.
DESIGNATED = re.compile(r"([^/_]+|1/40|en\s*13715_[^/_]+)\s*[/_]\s*h\s*\d.*", re.IGNORECASE)
#: What may stand between the letters of a name.
LOOSE = r"[\s_-]*"
#: Letters of GOST's names in Latin ones.
CYRILLIC = str.maketrans("рогст", "pogst")
#: How it is written, and what may stand in it.
PATTERNS = ("S1002/h28/e32.5/6.7%", "1-40/h28/e32.5/6.7%")
HEIGHTS, THICKNESSES, SLOPES = (28.0, 32.0), (28.5, 32.5), (6.7, 15.0)
#: The straight face of EN 13715's flange: its slope, and its lower end for a flange of 32.5 mm [mm].
FACE_SLOPE, FACE_END = -2.747477419, (-38.426669071, 11.999738200)


@cache
def standards():
    """What the file says: {"rails": {name: entry}, "wheels": ..., "en13715": ..., "missing": [name]}."""
    return json.loads(FILE.read_text(encoding="utf-8"))


def names(kind):
    """The names of all standard profiles of a ``kind``, "wheel" or "rail", without designations."""
    return tuple(standards()[kind + "s"])


@cache
def _known():
    """The name of each profile by its names and other names, as they are compared."""
    return {
        compared(one): name
        for kind in ("rails", "wheels")
        for name, entry in standards()[kind].items()
        for one in (name, *entry.get("also", ()))
    }


def compared(name):
    """``name`` without what has no meaning in it: case, blanks, underscores and hyphens, and the letters of GOST."""
    return re.sub(r"[\s_-]", "", name.lower()).translate(CYRILLIC)


def missing_name(name, kind):
    """The profile of this ``kind`` that ``name`` means, "GOST" of "a GOST wheel", of which no public source with enough
    numbers was found; None if it means none of these."""
    asked = name.lower().translate(CYRILLIC)
    means = [
        one
        for one in standards()["missing"][kind]
        if compared(one) == compared(name)
        or len(one) > 2
        and re.search(rf"(?<!\d){LOOSE.join(one.lower())}(?!\d)", asked)
    ]
    return max(means, key=len, default=None)


def known_name(name):
    """The name of the standard profile that is also called ``name``; None if there is none."""
    return _known().get(compared(name)) or designation(name)


def designation(name):
    """``name`` as EN 13715 spells it; None if it is no designation.  The standard's own number may stand before it.

    >>> designation("s1002/H30/e31.5/15")
    'S1002/h30/e31.5/15%'
    >>> designation("EN 13715 - S1002/h28/e32,5/6,7 %")
    'S1002/h28/e32.5/6.7%'

    Raises
    ------
    ValueError
        if it is one, with a number that the standard does not have.
    """
    found = DESIGNATION.fullmatch(re.sub(r"\s", "", name.lower()).replace(",", "."))
    if not found:
        return None
    tread, *numbers = found.groups()
    for letter, unit, number, (low, high) in zip("he ", ("mm", "mm", "%"), numbers, _ranges()):
        if not (number.count(".") <= 1 and number != "." and low <= float(number) <= high):
            words = {"h": "height of its flange h", "e": "thickness of its flange e"}.get(
                letter, "outer slope"
            )
            raise ValueError(
                f"the {words} of wheel {name!r} is {number} {unit}; permitted is {low:g} ... {high:g} {unit}"
            )
    h, e, slope = (f"{float(number):g}" for number in numbers)
    return f"{'S1002' if tread == 's1002' else '1-40'}/h{h}/e{e}/{slope}%"


def _ranges():
    return HEIGHTS, THICKNESSES, SLOPES


def build(name):
    """The standard profile with this very ``name``; KeyError if there is none."""
    if "/" in name:
        tread, *numbers = name.rstrip("%").split("/")
        h, e, slope = (float(number.strip("he")) for number in numbers)
        zones = en13715(tread, height=h, thickness=e, slope=slope)
        return _whole(name, "wheel", zones, standards()["en13715"])
    kind = "rail" if name in standards()["rails"] else "wheel"
    entry = standards()[kind + "s"][name]
    zones = _head(entry) if "arcs" in entry else tuple(map(_zone, entry["zones"]))
    if "running_circle" in entry:
        zones = _at_running_circle(zones, entry["running_circle"])
    return _whole(name, kind, zones, entry)


def _whole(name, kind, zones, entry):
    """The profile of ``zones``, without steps, and with its corners."""
    zones, steps = joined(zones, JOINT_HEIGHT, PRINTED_STEP)
    note = entry.get("note", "")
    if steps:
        words = f"steps of up to {max(map(abs, steps)):.2g} mm between its printed zones are joined"
        note = f"{note}; {words}" if note else words
    source = Source(
        **{
            key: entry[key]
            for key in ("standard", "year", "sources", "origin", "running_circle_distance", "inclined")
            if key in entry
        },
        note=note,
    )
    smooth = "arcs" in entry or entry.get("smooth", False)  # tangent by construction, or as printed
    return Profile(name, kind, zones, smooth, source=source)


def _zone(row):
    """The zone in one row of the file."""
    family, start, stop, *numbers = row
    if family == "arc":
        return Arc(start, stop, *numbers)
    if family == "line":
        z, slope, at = numbers
        return Polynomial(start, stop, (z, slope), at)
    return Polynomial(start, stop, tuple(numbers[0]))


def _at_running_circle(zones, y):
    """Zones moved so that y = 0, z = 0 is where they have the abscissa ``y`` [mm]."""
    zones = tuple(moved_across(zone, -y) for zone in zones)
    middle = next(zone for zone in zones if zone.start <= 0.0 <= zone.stop)
    return tuple(lifted(zone, -float(middle(0.0)[0])) for zone in zones)


def _head(entry):
    """A head of arcs and a straight side, symmetric about its top.

    Each arc's centre lies on the line through the neighbour's centre and the joint, so the chain is tangent
    by construction.  The side starts where the last arc has its slope.
    """
    (radius, width), *others = entry["arcs"]
    crown = Arc(-width, width, float(radius), 0.0, float(radius), -1)
    half, slope = [crown], float(entry["side"])
    for radius, stop in others:
        half.append(_tangent_arc(half[-1], float(radius), stop))
    corner = half.pop()
    tangent = corner.y_centre + corner.radius * slope / math.sqrt(1.0 + slope * slope)
    corner = Arc(corner.start, tangent, corner.radius, corner.y_centre, corner.z_centre, -1)
    z_side = float(corner(tangent)[0])
    end = tangent + (entry["depth"] - z_side) / slope
    half = (*half[1:], corner, Polynomial(tangent, end, (z_side, slope), tangent))
    return tuple(mirror_zone(zone) for zone in reversed(half)) + (crown,) + half


def _tangent_arc(previous, radius, stop):
    """The arc of ``radius`` up to ``stop`` that continues ``previous`` with the same tangent."""
    share, start = 1.0 - radius / previous.radius, previous.stop
    z_start = float(previous(start)[0])
    return Arc(
        start,
        stop,
        radius,
        previous.y_centre + share * (start - previous.y_centre),
        previous.z_centre + share * (z_start - previous.z_centre),
        -1,
    )


# --- EN 13715 ----------------------------------------------------------------------------------------------------


def en13715(tread, *, height, thickness, slope):
    """Zones of the wheel of EN 13715 with this ``tread``, "S1002" or "1-40"; flange of ``height`` and
    ``thickness`` [mm]; outer ``slope`` [%]."""
    thinner = 32.5 - thickness
    treads = {"S1002": _tread_s1002, "1-40": _tread_1_40}
    return (*_flange(height - 28.0, thinner), *treads[tread](thinner, slope))


def _flange(higher, thinner):
    """Flange of appendix A, ``higher`` than 28 mm and ``thinner`` than 32.5 mm [mm], down to its straight face.

    The face's arc R (20, 21.5 and 23 mm at h = 28, 30 and 32) is tangent to the tip's R12 and to the face.
    """
    y_face, z_face = FACE_END[0] - thinner, FACE_END[1]
    y_tip, z_tip = -55.0 - thinner, 16.0 + higher
    radius, across = 20.0 + 0.75 * higher, math.hypot(1.0, FACE_SLOPE)
    along_y, along_z = 1.0 / across, FACE_SLOPE / across
    # the arc's centre lies R inside the face, and R - 12 from the tip's centre
    y_0, z_0 = y_face + radius * along_z - y_tip, z_face - radius * along_y - z_tip
    middle = y_0 * along_y + z_0 * along_z
    t = -middle + math.sqrt(middle * middle - (y_0 * y_0 + z_0 * z_0 - (radius - 12.0) ** 2))
    y_arc, z_arc = y_tip + y_0 + t * along_y, z_tip + z_0 + t * along_z
    y_g = y_tip + 12.0 * (y_tip - y_arc) / (radius - 12.0)
    y_f = y_face + t * along_y
    back = -62.764705882
    tip = [Arc(back, y_g, 12.0, -55.0, z_tip, 1)]
    if thinner > 0.0:
        top = -55.0 - 0.5 * thinner
        tip = [Arc(back, top, 12.0, -55.0, z_tip, 1), Arc(top, y_g, 12.0, y_tip, z_tip, 1)]
    return (
        Arc(-70.0, back, 20.5, -49.5, 9.519259302 + higher, 1),
        *tip,
        Arc(y_g, y_f, radius, y_arc, z_arc, 1),
        Polynomial(y_f, y_face, (z_face, FACE_SLOPE), y_face),
    )


def _tread_s1002(thinner, slope):
    """Tread of appendix C: its part at the flange moves with that, and a straight line joins it to the rest."""
    *_, root, first, second, outer = map(_zone, standards()["wheels"]["S1002"]["zones"])
    if slope != SLOPES[0]:
        z = float(second(second.stop)[0])
        outer = Polynomial(outer.start, outer.stop, (z, -0.01 * slope), outer.start)
    if not thinner:
        return root, first, second, outer
    inner = moved_across(Polynomial(second.start, -0.5, second.coefficients), -thinner)
    z = float(inner(inner.stop)[0])
    return (
        moved_across(root, -thinner),
        moved_across(first, -thinner),
        inner,
        Polynomial(inner.stop, 0.0, (0.0, z / inner.stop)),
        Polynomial(0.0, second.stop, second.coefficients),
        outer,
    )


def _tread_1_40(thinner, slope):
    """Tread of appendix B: R13 and R36, tangent, and straight lines through its printed points."""
    y_root, y_arc, y_line, y_flat = (y - thinner for y in (FACE_END[0], -32.695094, -15.640, -0.5))
    arc = Arc(y_arc, y_line, 36.0, -14.740 - thinner, 36.380, -1)
    z_line, z_flat = float(arc(y_line)[0]), 0.013
    return (
        Arc(y_root, y_arc, 13.0, -26.210665 - thinner, 16.446, -1),
        arc,
        Polynomial(y_line, y_flat, (z_flat, (z_flat - z_line) / (y_flat - y_line)), y_flat),
        Polynomial(y_flat, 0.0, (0.0, z_flat / y_flat)),
        Polynomial(0.0, 35.0, (0.0, -0.025)),
        Polynomial(35.0, 60.0, (-0.875, -0.01 * slope), 35.0),
    )
