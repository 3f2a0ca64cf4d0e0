"""Look-alikes of profile files that instruments and other programs write, and shapes that such files have."""

import numpy as np

from tests.helpers.profile_points import points


def inclined_rail(inclination, spacing=0.2, noise=0.0):
    """y, z (n,) [mm] of UIC60, inclined towards smaller y."""
    y, z = points("rail", spacing)
    c, s = np.cos(np.arctan(inclination)), np.sin(np.arctan(inclination))
    random = np.random.default_rng(3)
    return tuple(part + random.normal(0.0, noise, len(y)) for part in (c * y + s * z, c * z - s * y))


def worn_rail(spacing=0.2):
    """y, z (n,) [mm] of UIC60 whose gauge corner, at smaller y, is worn to a plane of 45 deg, with round
    ends."""
    y, z = points("rail", spacing)
    plane = -y - 22.0
    return y, z + 0.5 * np.logaddexp(0.0, (plane - z) / 0.5)


def wavy_back(amplitude=0.005):
    """y, z (n,) [mm] of S1002 with more of the flange's back, which waves by ``amplitude`` [mm]."""
    y, z = points("wheel")
    height = np.arange(-12.0, z[0], 0.3)
    return np.r_[y[0] + amplitude * np.sin(2.0 * height), y], np.r_[height, z]


def several(profiles, other="[FileInfo]\nProgramName=MiniProf for Windows\n"):
    """A .mpt file of ``profiles``, rows (name, y, z)."""
    text = other
    for number, (name, y, z) in enumerate(profiles, start=1):
        rows = "".join(f"{a:.6f} {b:.6f} 1.3254 0 \n" for a, b in zip(y, z))
        text += (
            f"\n[Profile{number}Info]\nProgramName=AutoCAD\nMPDC=2\nMPDN={name}\nMPD1=L 1.0 2.0 3.0\n"
            f"MPTypeNo=299\nColumnDef=X,Y,A,C\nXYPoints={len(y)}\n\n[Profile{number}Points]\n{rows}"
        )
    return text


def vampire(kind, y, z, *, datum="EUROPEAN", width=1360.0, left=None):
    """A .whe or .rai file with the profile on the right, and ``left`` (y, z) or the same on the left."""
    offset = 0.5 * width + 70.0 if kind == "wheel" else 750.0
    up = 1.0 if kind == "wheel" else -1.0
    left_y, left_z = (y, z) if left is None else left
    head = {
        "wheel": f"TREADDATUM {datum}\nFLANGEBACK {width}\n",
        "rail": f"GAUGEPOINT {datum}\nGAUGE 1435\n",
    }[kind]
    rows = "".join(
        f"{-offset - a:.6f}, {up * b:.6f}, {offset + c:.6f}, {up * d:.6f}\n"
        for a, b, c, d in zip(left_y, left_z, y, z)
    )
    return f"{kind.upper()}PROFILE\nS1002 on UIC60, a title\n{head}! left, right\n{rows}"


def gensys(y, z):
    """A .wheel or .rail file: y towards the track centre."""
    return "# GENSYS\n" + "".join(f"{-a:.9f}  {b:.9f}   # point\n" for a, b in zip(y[::-1], z[::-1]))
