"""Style of the pictures: fonts, lines and colours; units mm, deg, kN and MPa.

The colours are those of Okabe and Ito, which can be distinguished with any colour vision.  Figures are made
without pyplot: they need no display and leave no global state.
"""

import textwrap
import warnings
from functools import wraps
from math import radians
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib import font_manager
from matplotlib.figure import Figure

from ..conventions import MILLIMETRE as MM  # noqa: F401  beside the other units
from ..storage.atomic import open_atomically

DEGREE = radians(1)
KILONEWTON = 1e3  #: [N]
MEGAPASCAL = 1e6  #: [Pa]

#: Colours of the two wheels, of the rail, and of text.
SIDE_COLOUR = {"left": "#0072B2", "right": "#D55E00"}
WHEEL_COLOUR, RAIL_COLOUR, RAIL_LABEL, CONTACT_COLOUR = "#0072B2", "#6E6E6E", "#4A4A4A", "#D55E00"
INK, QUIET = "#222222", "#767676"
#: Fill of tread, flange root and flange behind the curves.
ZONE_COLOUR = {"tread": "#FFFFFF", "flange root": "#EDEDED", "flange": "#DADADA"}
#: Pressure: light is low, dark is high, also in print.
PRESSURE_COLOURS = "magma_r"
#: Lateral shifts from left to right, without the light end, which is hard to see on white.
SHIFT_COLOURS = matplotlib.colormaps["viridis"](np.linspace(0.0, 0.92, 128))

#: Fonts of Windows, macOS and Linux with Chinese, Japanese and Korean letters, which names of files may have.
WIDE_FONTS = (
    *(f"Noto Sans CJK {script}" for script in ("SC", "TC", "JP", "KR")),
    *("WenQuanYi Zen Hei", "WenQuanYi Micro Hei", "Droid Sans Fallback"),
    *("Microsoft YaHei", "SimHei", "Yu Gothic", "Malgun Gothic"),
    *("PingFang SC", "Hiragino Sans GB", "Apple SD Gothic Neo", "Arial Unicode MS"),
)
#: Those of them that this machine has.
OTHER_FONTS = [name for name in WIDE_FONTS if name in font_manager.get_font_names()]

LOOK = {
    "font.family": ["DejaVu Sans", *OTHER_FONTS],
    "font.size": 9,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.titleweight": "bold",
    "axes.labelsize": 9,
    "axes.labelcolor": INK,
    "axes.edgecolor": QUIET,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.color": QUIET,
    "ytick.color": QUIET,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 8.5,
    "ytick.labelsize": 8.5,
    "text.color": INK,
    "lines.linewidth": 1.6,
    "lines.solid_capstyle": "round",
    "legend.frameon": False,
    "legend.fontsize": 8.5,
    "figure.titlesize": 10.5,
    "figure.titleweight": "bold",
    "figure.constrained_layout.h_pad": 0.05,
    "figure.constrained_layout.w_pad": 0.05,
}
LETTERS = 9.6  #: of a figure's title in an inch
RESOLUTION = 130  #: dots per inch of a saved picture


def styled(draw):
    """Decorator: ``draw`` uses this style, independent of the caller's matplotlib settings."""

    @wraps(draw)
    def drawing(*arguments, **options):
        with matplotlib.rc_context(), warnings.catch_warnings():
            warnings.filterwarnings("ignore", "Glyph .* missing from font")  # a box stands for it
            matplotlib.rcdefaults()
            matplotlib.rcParams.update(LOOK)
            return draw(*arguments, **options)

    return drawing


def number(value, digits):
    """``value`` as text with this many digits after the point and a typographic minus; no "-0.0"."""
    return f"{round(value, digits) + 0.0:.{digits}f}".replace("-", "\N{MINUS SIGN}")


def in_lines(title, width):
    """A figure's title with line breaks, so that it fits a figure of this ``width`` [in]; long names are
    broken too."""
    return "\n".join(textwrap.wrap(title, round(LETTERS * width)))


def new_figure(width, height):
    """An empty figure of this size [in] with automatic layout of its panels."""
    return Figure(figsize=(width, height), dpi=RESOLUTION, layout="constrained", facecolor="white")


def given_axes(ax, shape):
    """The figure of the caller's axes ``ax``, and the axes as an array of this ``shape``.

    Raises
    ------
    ValueError
        if their number is another one.
    """
    axes = np.array(ax, dtype=object).reshape(-1)
    if len(axes) != np.prod(shape):
        raise ValueError(f"ax has {len(axes)} axes; permitted are {np.prod(shape)}, as an array {shape}")
    return axes[0].get_figure(), axes.reshape(shape)


def given_axis(axis, width, height, **kind):
    """The caller's ``axis``, without the frame's upper and right side, or for None one in a new figure of
    this size [in]."""
    if axis is None:
        return new_figure(width, height).add_subplot(**kind)
    if "top" in axis.spines:
        axis.spines[["top", "right"]].set_visible(False)
    return axis


@styled
def save(figure, path, resolution=RESOLUTION):
    """Write ``figure``, or that of an axis, to ``path``; the ending says the format (png, svg, pdf).
    ``resolution`` is in dots per inch."""
    with open_atomically(path) as file:
        figure.figure.savefig(file, format=Path(path).suffix[1:].lower(), dpi=resolution)
    return path
