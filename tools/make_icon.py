"""Draw the FMU's icon: ``python tools/make_icon.py`` writes fmu_src/icon.svg and fmu_src/icon.png from one
list of shapes.

A wheelset on two rails, seen along the track, on a transparent background of 200 by 200 units.  Wheels and
rails are drawn much too thick, so that the icon is clear at 64 pixels.
"""

from pathlib import Path

from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon

ICON = Path(__file__).resolve().parents[1] / "fmu_src" / "icon"
SIZE = 200  # units of the shapes, and pixels of the PNG
# as in the pictures of the documentation
WHEEL, AXLE, RAIL, CONTACT = "#0072B2", "#004C77", "#6E6E6E", "#D55E00"

# The right wheel, from its flange's tip at the bottom, and its rail: x from the track centre, y from the
# bottom.
RIGHT_WHEEL = [
    (49, 58),
    (44, 64),
    (44, 174),
    (49, 180),
    (54, 180),
    (58, 168),
    (86, 166),
    (86, 72),
    (58, 70),
    (54, 58),
]
RIGHT_RAIL = [
    (60, 70),
    (58, 66),
    (58, 54),
    (67, 49),
    (67, 28),
    (50, 22),
    (50, 14),
    (96, 14),
    (96, 22),
    (79, 28),
    (79, 49),
    (88, 54),
    (88, 66),
    (86, 70),
]
AXLE_BODY = [(-96, 112), (-96, 126), (96, 126), (96, 112)]
CONTACT_POINT, CONTACT_RADIUS = (68, 70), 7


def mirrored(points):
    """The left side's shape."""
    return [(-x, y) for x, y in points]


def polygons():
    """(points in the icon's units, colour), from the back to the front."""
    shapes = [
        (AXLE_BODY, AXLE),
        (RIGHT_RAIL, RAIL),
        (mirrored(RIGHT_RAIL), RAIL),
        (RIGHT_WHEEL, WHEEL),
        (mirrored(RIGHT_WHEEL), WHEEL),
    ]
    return [([(x + SIZE / 2, y) for x, y in points], colour) for points, colour in shapes]


def circles():
    """Centres of the two contact points."""
    x, y = CONTACT_POINT
    return [(SIZE / 2 + x, y), (SIZE / 2 - x, y)]


def svg():
    """The icon as SVG, whose y runs down."""
    lines = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {SIZE} {SIZE}">']
    for points, colour in polygons():
        corners = " ".join(f"{x:g},{SIZE - y:g}" for x, y in points)
        look = f'fill="{colour}" stroke="{colour}" stroke-width="2" stroke-linejoin="round"'
        lines.append(f'  <polygon points="{corners}" {look}/>')
    lines += [
        f'  <circle cx="{x:g}" cy="{SIZE - y:g}" r="{CONTACT_RADIUS}" fill="{CONTACT}"/>'
        for x, y in circles()
    ]
    return "\n".join([*lines, "</svg>"]) + "\n"


def png(path):
    """Write the icon as PNG with a transparent background."""
    figure = Figure(figsize=(1, 1), dpi=SIZE)
    panel = figure.add_axes((0, 0, 1, 1), xlim=(0, SIZE), ylim=(0, SIZE))
    panel.set_axis_off()
    for points, colour in polygons():
        panel.add_patch(
            Polygon(points, facecolor=colour, edgecolor=colour, linewidth=2 * 72 / SIZE, joinstyle="round")
        )
    for centre in circles():
        panel.add_patch(Circle(centre, CONTACT_RADIUS, color=CONTACT, linewidth=0))
    figure.savefig(path, transparent=True, metadata={"Software": None})


if __name__ == "__main__":
    ICON.with_suffix(".svg").write_text(svg(), encoding="utf-8")
    png(ICON.with_suffix(".png"))
    print(ICON.with_suffix(".svg"), ICON.with_suffix(".png"), sep="\n")
