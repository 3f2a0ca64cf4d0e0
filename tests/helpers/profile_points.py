"""Points of profiles as files have them."""

import warnings

import numpy as np

import wrcontact
from data.noisy_profiles import NAMES, even_points, noisy_points
from wrcontact import Profile, ProfileWarning
from wrcontact.profiles import standard_profile

MM = 1e-3
SHIFTS = np.arange(-6.0, 6.01, 0.5) * MM
#: Smallest y [mm] and largest, where heights are compared: short of the vertical back of the flange,
#: and of the field side.
INSIDE = {"wheel": (-60.0, 55.0), "rail": (-33.0, 33.0)}


def points(kind, spacing=0.2):
    """y, z (n,) [mm] of the standard profile, exact."""
    return even_points(kind, spacing)


def noisy(kind, deviation, seed, spacing=0.2):
    """The points with noise [mm] in y and z."""
    return noisy_points(kind, spacing, deviation, seed)


def columns(y, z, separator=" "):
    return "".join(f"{a:.12g}{separator}{b:.12g}\n" for a, b in zip(y, z))


def read(folder, text, kind="wheel", name="own.txt", smoothing=None):
    """The profile in ``text`` (str or bytes), and what was said of it."""
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        profile = Profile.from_file(path, kind, smoothing)
    assert all(issubclass(warning.category, ProfileWarning) for warning in said) and len(said) <= 1
    return profile, str(said[0].message) if said else ""


def error(profile):
    """Largest difference in height from the standard profile [mm]."""
    low, high = INSIDE[profile.kind]
    y = np.linspace(low, high, 3001) * MM
    exact = standard_profile(NAMES[profile.kind])
    return np.max(np.abs(profile.height(y) - exact.height(y)) / np.hypot(1.0, exact.slope(y))) / MM


def swept(**profiles):
    return wrcontact.ContactSystem(**profiles).evaluate_many(lateral_shift=SHIFTS, outputs="patches")


Y, Z = points("wheel")


def simpack(y, z, kind, keys="units.len.f = 1000", row="{:.12g}  {:.12g}\n"):
    rows = "".join(row.format(a, b) for a, b in zip(y, z))
    return (
        f"! a comment\nheader.begin\n  version = 1\n  type = {int(kind == 'wheel')}   ! 0 rail, 1 "
        f"wheel\nheader.end\n"
        f"spline.begin\n  comment = 'worn'\n{keys}\n  point.begin\n! y z\n{rows}  "
        f"point.end\nspline.end\n"
    )


def miniprof(y, z, definition="ColumnDef=X,Y,A,C,N\n"):
    rows = "".join(f"{a:.9f}\t{b:.9f}\t0.00\t0.000\t{k}\r\n" for k, (a, b) in enumerate(zip(y, z)))
    return f"ProgramName=MPWin\r\nDate=1-2-2024\r\n{definition}XYPoints={len(y)}\r\n\r\n{rows}"


def changed(values, places, by):
    values = values.copy()
    values[places] += by
    return values


RNG = np.random.default_rng(11)
SINGLE = RNG.choice(np.arange(10, 750, 12), 30, replace=False)
