"""Whether y = 0 of a wheel can be its running circle: a remark with numbers where its flange is elsewhere; and
whether the points of a file are smooth enough.

A file may have another origin: the back of the flange, the middle or the outer face of the rim. The points of
the tread do not show it, but the back of the flange does, which does not wear: with the distance of the
running circles it gives the back-to-back distance of the wheelset, and this differs little between railways.
Where the points end before it, the tip of the flange is used. The face of the flange moves with wear, and is
compared with the limits of wear. The profile is used as it is.
"""

import numpy as np

from ..conventions import MILLIMETRE as MM
from ..interface.parameters import on_the_left
from .changing import is_sections, round_wheel
from .remarks import Grave, remark

#: Gauges of main lines [mm]; a track has the largest of them that it reaches but for NARROW, and is up to
#: WIDENED wider [mm].
GAUGES, NARROW, WIDENED = (1000.0, 1067.0, 1435.0, 1520.0, 1600.0, 1668.0, 1676.0), 6.0, 45.0
#: How much smaller than the gauge the back-to-back distance is [mm]: 72 ... 78 in Europe (TSI), 79 ... 84 in
#: North America (AAR), 77 ... 83 on 1520 mm, 67 ... 77 on 1000 and 1067 mm; and the distance of the flanges'
#: faces, FACE [mm] below the running circle: 9 ... 25 within the limits of wear (TSI: 1410 ... 1426 mm), and
#: less on hollow treads, whose running circle is higher.
BACKS, FACES, FACE = (67.0, 85.0), (3.0, 27.0), 10.0
#: Distance of the tip of a flange from its back [mm], 15 (S1002) ... 18 (AAR), and how much it may differ.
TIP, TIPS = 15.0, 4.0
#: A profile is read every STEP up to STOP [mm].
STEP, STOP = 0.1, 45.0
#: Roughness is that of the curvature within MIDDLE of y = 0 [mm] from its mean over SMOOTH [mm]: patches are longer,
#: and no design has such waves. Of more than ROUGH [1/m] the user is warned, a fifth of the relative curvature of S1002 on the
#: shoulder of UIC60, 5 to 8 1/m.
MIDDLE, SMOOTH, ROUGH = 15.0, 4.0, 1.0
#: A wheel has a flange if it is as deep below its running circle [mm]. The points within FLAT [mm] of the
#: deepest are its tip, which is there if the profile rises by RISE [mm] behind it; the back is there if the
#: last BACK [mm] are STEEP.
FLANGE, FLAT, RISE, BACK, STEEP = 15.0, 0.2, 1.0, 0.5, 3.0
#: Greatest height at the running circle [mm], above which a wheel has grown; and how far z = 0 is from y = 0
#: where that is reported [mm].
LARGER, ASIDE = 1.0, 1.0


def remark_profiles(system):
    """Give a :class:`~wrcontact.ProfileWarning` on each profile of a :class:`~wrcontact.ContactSystem` that is a
    wheel with an implausible origin, or is rough."""
    for wheel in dict.fromkeys(map(round_wheel, (system.wheel, system.left_wheel))):
        found = (*remarks_on(wheel, system.parameters), *_on_roughness(wheel), *_on_circles(wheel, system))
        remark("wheel", wheel.name, found)
    for rail, inclination in dict.fromkeys(_placed(system)):
        remark("rail", rail.name, [*_on_roughness(rail), *_on_inclination(rail, inclination)])


def _placed(system):
    """The rails of a system that are the same all along the track, and their inclinations [1]."""
    left = on_the_left(system.parameters)["rail_inclination"]
    placed = (system.rail, system.parameters["rail_inclination"]), (system.left_rail, left)
    return tuple(one for one in placed if not is_sections(one[0]))


def _on_circles(wheel, system):
    """The remark where the wheelsets of a standard wheel have another distance of the running circles."""
    usual = wheel.source and wheel.source.running_circle_distance
    given = system.parameters["running_circle_distance"]
    if usual and abs(usual - given) > ASIDE * MM:
        yield (
            f"the running circles of its wheelsets are {usual / MM:g} mm apart; running_circle_distance is "
            f"{given / MM:g} mm"
        )


def _on_inclination(rail, inclination):
    """The remark where a standard's rail that is inclined already is inclined again."""
    if rail.source and rail.source.inclined and inclination:
        yield Grave(
            f"it is inclined by 1:{1.0 / rail.source.inclined:g} already, and rail_inclination turns it by "
            f"{inclination:g} more; usual is rail_inclination=0"
        )


def _on_roughness(profile):
    """The remark on the points of a file whose curvature scatters in the middle, where wheel and rail mostly
    touch; :func:`wrcontact.check` looks where they do."""
    if profile.reading is None or not profile.reading.noise > 0.0:
        return
    y = np.arange(max(-MIDDLE * MM, profile.start), min(MIDDLE * MM, profile.stop), 0.5 * STEP * MM)
    scatter = roughness(profile.curvature(y), SMOOTH / (0.5 * STEP))
    if scatter > ROUGH:
        yield (
            f"its curvature scatters by {scatter:.3g} 1/m within 4 mm between y = {-MIDDLE:g} and {MIDDLE:g} mm: "
            "the contact follows noise; use more smoothing"
        )


def roughness(curvature, count):
    """Median deviation of a ``curvature`` (n,) [1/m] at even places from its mean over ``count`` of them; NaN if
    there are fewer. The few joints of a design do not affect the median."""
    window = np.ones(int(count) | 1)
    if len(curvature) <= len(window):
        return np.nan
    spare = len(window) // 2
    mean = np.convolve(curvature, window / len(window), mode="valid")
    return float(np.median(np.abs(curvature[spare : len(curvature) - spare] - mean)))


def remarks_on(wheel, parameters):
    """The remarks (a tuple) on a ``wheel``, a Profile, of a wheelset and track with these ``parameters``."""
    if not wheel.start < 0.0 < wheel.stop:
        return ()
    y = STEP * np.arange(np.ceil(wheel.start / MM / STEP), np.floor(min(wheel.stop / MM, STOP) / STEP) + 1)
    z = wheel.height(y * MM) / MM
    y, z = y[np.isfinite(z)], z[np.isfinite(z)]
    middle = float(np.interp(0.0, y, z))
    return (*_on_height(middle), *_on_flange(y, z, middle, parameters))


def _on_height(middle):
    """The remark on the height at y = 0 [mm]."""
    if middle > LARGER:
        yield Grave(
            f"at y = 0 it is {middle:.3g} mm larger than nominal_radius, which no wear does; usual "
            f"is at most {LARGER:g} mm: y = 0 is the running circle, and z = 0 there"
        )


def _on_flange(y, z, middle, parameters):
    """The remark on the flange of points ``y``, ``z`` (n,) [mm]: its first implausible part."""
    gauge, circles = nominal_gauge(parameters["gauge"] / MM), parameters["running_circle_distance"] / MM
    if z.max() - middle < FLANGE or gauge is None:
        return
    for part, place, words, found, (least, most) in _distances(y, z, middle, circles):
        if not least <= gauge - found <= most:
            yield Grave(
                f"the {part} of its flange is at y = {place:.4g} mm{_zero(y, z)}; with running "
                f"circles {circles:.5g} mm apart {words} is {found:.4g} mm; usual is "
                f"{gauge - most:g} ... {gauge - least:g} mm on a gauge of {gauge:g} mm: y = 0 is the "
                "running circle, for most wheels 70 mm from the back of the flange"
            )
            return


def _distances(y, z, middle, circles):
    """What the flange says of the wheelset: its part, where that is [mm], words for a distance, its value
    [mm], and how much smaller than the gauge that usually is [mm]."""
    tip = float(np.median(y[z >= z.max() - FLAT]))
    last = round(BACK / STEP)
    if z[last] - z[0] >= STEEP * BACK:
        yield "back", float(y[0]), "the back-to-back distance", circles + 2.0 * y[0], BACKS
    elif z.max() - z[0] >= RISE:
        yield (
            "tip",
            tip,
            "the back-to-back distance, 15 mm behind it,",
            circles + 2.0 * (tip - TIP),
            (BACKS[0] - 2.0 * TIPS, BACKS[1] + 2.0 * TIPS),
        )
    face = float(y[(y < 0.0) & (z >= middle + FACE)][-1])
    words = f"the distance of both faces, {FACE:g} mm below the running circles,"
    yield "face", face, words, circles + 2.0 * face, FACES


def nominal_gauge(gauge):
    """The one of GAUGES [mm] that a track of this ``gauge`` [mm] has; None if it is no main line's."""
    return max((known for known in GAUGES if -NARROW <= gauge - known <= WIDENED), default=None)


def _zero(y, z):
    """Words on where the tread crosses z = 0, if that is aside of y = 0."""
    before = np.flatnonzero((z[:-1] > 0.0) & (z[1:] <= 0.0) & (y[:-1] > -30.0))
    places = y[before] + (y[before + 1] - y[before]) * z[before] / (z[before] - z[before + 1])
    near = places[np.argsort(np.abs(places))][:1]
    return f", and z = 0 at y = {near[0]:.3g} mm" if len(near) and abs(near[0]) > ASIDE else ""
