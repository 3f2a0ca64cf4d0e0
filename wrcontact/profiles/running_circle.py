"""Where the running circle of a wheel in a file is: y = 0, 70 mm from the back of the flange.

A file may count y from the back of the flange. MiniProf defines this: its instrument lies on the back. The
first point is not the back, since the points of a flange often begin on its rounding; the back itself is
known by points that are nearly vertical.
"""

from dataclasses import replace

import numpy as np

from .remarks import Grave, Refusal

#: Position of the flange tip from the running circle, height of the flange, and distance of the running
#: circle from the flange's back [mm].
TIP, FLANGE, BACK = (-80.0, -30.0), (10.0, 60.0), 70.0
#: Distance of the flange's tip from y = 0, if that is the back of the flange [mm]: 15 in S1002, 18 in AAR-1B,
#: 21 and more on worn wheels.
FROM_BACK = (8.0, 30.0)
#: The back of the flange is in the points if they rise by RISE within ROOM of their smallest y [mm]: the
#: rounding of S1002 does so from 0.05 mm behind the back on.
ROOM, RISE = 0.2, 1.6
#: The gauge face of a rail is steeper than FACE [1] over more than FACE_HEIGHT [mm]; the flange of a wheel is so
#: steep at its back alone, behind a tip that is DEEPER [mm] deeper. Wheels are NARROWEST [mm] wide or more.
FACE, FACE_HEIGHT, DEEPER, NARROWEST = 8.0, 5.0, 0.2, 80.0
#: The back is reported where it is farther from y = 0 of a format that counts from it [mm].
ASIDE = 0.5
#: Largest height of the running circle that counts as wear, not as another origin [mm].
OFFSET = 10.0


def at_running_circle(found, file, free, remarks):
    """Move a wheel so that y = 0 is its running circle, and z is within OFFSET of zero there; what ``file``
    shifts stays.

    Parameters
    ----------
    found : :class:`~wrcontact.profiles.flaws.Mended` with the flange at smaller y, and z down.
    file : :class:`~wrcontact.profiles.options.ProfileFile`.
    free : whether the format is MiniProf's, which counts y from the back of the flange.
    remarks : list to which the shift is added.
    """
    y, z = evenly(found)
    deepest = np.percentile(z, 99)
    tip = np.median(y[z >= deepest])
    if not (TIP[0] <= tip <= TIP[1] and y[-1] > 0.0):
        shift = _from_back(found, tip, file, free, remarks)
        found, y = replace(found, y=found.y + shift), y + shift
    middle = np.interp(0.0, y, z)
    height = deepest - middle
    if not FLANGE[0] <= height <= FLANGE[1]:
        raise Refusal(
            f"has a flange of {height:.4g} mm, from the running circle to the deepest point; "
            f"permitted are {FLANGE[0]:g} ... {FLANGE[1]:g} mm"
        )
    if z[-1] - middle > FLANGE[0]:
        raise Refusal(
            f"has its field side {z[-1] - middle:.4g} mm deeper than the running circle, as a "
            f"rail's head has; permitted are {FLANGE[0]:g} mm or less"
        )
    _refuse_gauge_face(y, z)
    if (abs(middle) > OFFSET or free) and not file.shift[1]:
        if not free:
            remarks.append(f"z was {middle:.4g} mm at the running circle; shifted to 0")
        found = replace(found, z=found.z - middle)
    return found


def _refuse_gauge_face(y, z):
    """A Refusal if the points end on a flange that only a rail can have: steeper than FACE over FACE_HEIGHT
    without a tip behind, or without a tip and narrower than any wheel."""
    fall = z[:-1] - z[1:]
    steep = float(np.sum(fall[fall > FACE * np.diff(y)]))
    if z[0] >= z.max() - DEEPER and (steep > FACE_HEIGHT or y[-1] - y[0] < NARROWEST):
        raise Refusal(
            f"ends at its deepest point, y = {y[0]:.4g} mm, with {steep:.3g} mm as steep as a rail's gauge face "
            f"and a width of {y[-1] - y[0]:.4g} mm, as part of a rail does; permitted are wheels with the tip "
            f"of the flange, or {NARROWEST:g} mm or more wide and with at most {FACE_HEIGHT:g} mm so steep"
        )


def _from_back(found, tip, file, free, remarks):
    """By how much a wheel with the ``tip`` [mm] of its flange aside is shifted [mm]: its y counts from the
    back of the flange, by the format or because the tip is at the usual distance, or the back is seen."""
    back = _back(found)
    counts = FROM_BACK[0] <= tip <= FROM_BACK[1] and (free or back is None)
    if file.shift[0] or (back is None and not counts):
        raise Refusal(
            f"has the tip of its flange, or its deepest point, at y = {tip:.4g} mm; permitted "
            f"are {TIP[0]:g} ... {TIP[1]:g} mm from the running circle, {FROM_BACK[0]:g} ... "
            f"{FROM_BACK[1]:g} mm from the back of the flange, or points on that back; "
            "shift = Y,Z moves y = 0 to the running circle"
        )
    if not counts:
        remarks.append(
            f"the running circle is assumed {BACK:g} mm from the back of the flange at y = {back:.4g} mm; y "
            f"shifted by {-BACK - back:.4g} mm"
        )
        return -BACK - back
    if not free:
        remarks.append(
            Grave(
                f"the running circle is assumed {BACK:g} mm from the back of the flange, taken to be at y = "
                f"0; y shifted by {-BACK:g} mm; shift = Y,Z states another distance"
            )
        )
    elif back is not None and abs(back) > ASIDE:
        remarks.append(
            Grave(
                f"the back of its flange is at y = {back:.3g} mm in the file, and not at 0, where MiniProf "
                f"has it; y = 0 is used; shift = Y,Z moves the running circle"
            )
        )
    return -BACK


def _back(found):
    """Place [mm] of the back of the flange, which is nearly vertical; None if the points do not show it."""
    low = found.y.min()
    near = found.z[found.y <= low + ROOM]
    return float(low) if near.max() - near.min() >= RISE else None


def evenly(found):
    """y and z (n,) [mm] at even steps across the profile, independent of the spacing of the points."""
    order = np.argsort(found.y, kind="stable")
    y = np.linspace(found.y.min(), found.y.max(), 401)
    return y, np.interp(y, found.y[order], found.z[order])
