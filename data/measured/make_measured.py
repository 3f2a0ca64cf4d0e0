"""A worn wheel and a worn rail as MiniProf would write them, from S1002 and UIC60 with a known wear.

    python -m data.measured.make_measured

writes worn.whl and worn.ban beside this file.  Nobody measured them: the wear is a formula, so that what
reading and smoothing make of the files can be compared with the truth.
"""

from pathlib import Path

import numpy as np

from data.noisy_profiles import even_points

HERE = Path(__file__).parent
SPACING = 0.2  # [mm] along the profile
NOISE = 0.005  # [mm] standard deviation in y and z
HOLLOW, HOLLOW_WIDTH = 0.8, 20.0  # [mm] depth of the tread's wear at the running circle
FLANGE, FLANGE_HEIGHT = 0.8, 10.0  # [mm] the flange's face is thinner by this, most at this depth
HEAD, HEAD_WIDTH = 0.5, 20.0  # [mm] depth of the rail head's wear at its top
INCLINATION = 1 / 40  # of the track in which the rail was measured
DUST = {"wheel": (120, 300, 470), "rail": (330,)}  # points that a grain of dust has lifted
GRAIN = 0.3  # [mm]


def worn_wheel():
    """y, z (n,) [mm] of the wheel without noise, z down from the old running circle."""
    y, z = even_points("wheel", SPACING)
    face = np.arange(len(y)) > np.argmax(z)  # of the flange's tip
    thinner = FLANGE * np.exp(-(((z - FLANGE_HEIGHT) / 5.0) ** 2))
    return y - np.where(face, thinner, 0.0), z - HOLLOW * np.exp(-((y / HOLLOW_WIDTH) ** 2))


def worn_rail():
    """y, z (n,) [mm] of the upright rail without noise, z down from the old top."""
    y, z = even_points("rail", SPACING)
    return y, z + HEAD * np.exp(-((y / HEAD_WIDTH) ** 2))


def inclined(y, z):
    """The rail's points as it stands in the track."""
    angle = np.arctan(INCLINATION)
    return np.cos(angle) * y + np.sin(angle) * z, np.cos(angle) * z - np.sin(angle) * y


def measured(y, z, kind):
    """Points with noise and dust; z [mm] of a grain is towards the instrument."""
    random = np.random.default_rng(25)
    y, z = (part + random.normal(0.0, NOISE, len(part)) for part in (y, z))
    z[list(DUST[kind])] += GRAIN if kind == "wheel" else -GRAIN
    return y, z


def miniprof(x, y):
    """Text of a MiniProf file with columns X, Y [mm]; Y is up."""
    rows = "".join(f"{a:.4f}\t{b:.4f}\r\n" for a, b in zip(x, y))
    return f"ProgramName=made by wrcontact\r\nColumnDef=X,Y\r\nXYPoints={len(x)}\r\n\r\n{rows}"


def texts():
    """What the files contain, by name."""
    y, z = measured(*worn_wheel(), "wheel")
    across, down = measured(*inclined(*worn_rail()), "rail")
    return {"worn.whl": miniprof(y + 70.0, -z), "worn.ban": miniprof(across, -down)}


if __name__ == "__main__":
    for name, text in texts().items():
        (HERE / name).write_bytes(text.encode("ascii"))
        print(HERE / name)
