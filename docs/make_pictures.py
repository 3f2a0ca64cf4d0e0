"""Draw the pictures of the documentation: ``python docs/make_pictures.py [frames] [demo] ...`` writes
docs/img/*.png.

    frames      frames and signs (docs/reference/conventions.md)
    demo        the picture of ``wrcontact demo`` (README)
    check       the picture of ``wrcontact check`` (docs/guides/check.md)
    models      the pressures of examples/compare_models.py (README)
    sections    sections of a crossing's nose (docs/guides/sections.md)
    along_track     a wheelset over a dipped weld (docs/guides/sections.md)
    around_wheel    a wheelset with a flat (docs/guides/wheels.md)
    profiles    the standard profiles (docs/guides/profiles_of_the_world.md)
    conformal   planar against conformal theory (docs/theory/conformal.md)
    source_5_8, source_7_14     two figures of ``wrcontact figures`` (docs/evidence/source_study.md)
    gallery     the pictures of docs/guides/gallery.md by the code of the page, also title_picture.png (README)

Wheel and rail are the real S1002 and UIC60 in their real positions; roll and yaw of the sketches are
exaggerated.
"""

import os
import re
import runpy
import sys
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from matplotlib.patches import Arc
from PIL import Image

from wrcontact import ContactSystem, RailSections
from wrcontact.plots import sections_figure, style
from wrcontact.plots.geometry import WHEEL_ZONES, rail_outline, wheel_outline
from wrcontact.plots.profiles import draw_profiles
from wrcontact.plots.style import CONTACT_COLOUR, INK, MM, QUIET, RAIL_COLOUR, RAIL_LABEL, WHEEL_COLOUR
from wrcontact.profiles.catalogue import every_profile
from wrcontact.progress import tracked

IMAGES = Path(__file__).resolve().parent / "img"
GALLERY = Path(__file__).resolve().parent / "guides" / "gallery.md"
FEW_COLOURS, ROUNDS = 256, 3  # of a picture of the gallery, and of the choice of its colours
FORCE = 78.5e3  # [N] of a wheel
TURNED = np.radians(7)  # yaw of the sketch from above
ARROW = {"arrowstyle": "-|>", "color": INK, "linewidth": 1.2, "shrinkA": 0, "shrinkB": 0}


def main(names):
    """Draw the pictures with these names and print their paths."""
    IMAGES.mkdir(exist_ok=True)
    for name in tracked(names, "pictures"):
        if name == "gallery":
            print(*draw_gallery(IMAGES), sep="\n")
        else:
            print(style.save(PICTURES[name](), IMAGES / f"{name}.png"))


def gallery_code():
    """The blocks of Python of the gallery's page."""
    return re.findall(r"^```python\n(.*?)^```", GALLERY.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)


def draw_gallery(folder):
    """Run the code of the gallery's page in this ``folder``, where it saves its pictures; their paths."""
    names = re.findall(r"!\[.*?\]\(\.\./img/(.*?)\)", GALLERY.read_text(encoding="utf-8"))
    with inside(folder):
        known = {}
        for number, block in enumerate(gallery_code(), 1):
            exec(compile(block, f"{GALLERY.name}, block {number}", "exec"), known)
    for name in names:
        if name.endswith(".png"):
            shrink(Path(folder, name))
    return [Path(folder, name) for name in names]


def shrink(path):
    """Write a PNG anew with few colours, which halves it."""
    with Image.open(path) as picture:
        few = picture.convert("RGB").quantize(FEW_COLOURS, kmeans=ROUNDS, dither=Image.Dither.NONE)
        few.save(path, optimize=True)


@contextmanager
def inside(folder):
    """Inside this context, ``folder`` is the working directory."""
    home = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(home)


def models():
    """The picture of the example that compares the normal models, which saves it in the working directory."""
    example = Path(__file__).resolve().parents[1] / "examples" / "compare_models.py"
    with TemporaryDirectory() as folder, inside(folder):
        return runpy.run_path(str(example))["figure"]


def check():
    """The picture of the check of S1002 on 60E1."""
    import wrcontact
    from wrcontact.plots import check_figure

    return check_figure(wrcontact.check(ContactSystem(rail="60E1")))


def demo():
    """The picture of ``wrcontact demo``, from a run of the FMU."""
    from wrcontact.cli.demo import step_through, stored_run
    from wrcontact.fmu import build_fmu
    from wrcontact.plots import demo_figure

    stored = stored_run()
    with TemporaryDirectory() as folder:
        answers, _ = step_through(build_fmu(folder), stored)
    return demo_figure(ContactSystem(), answers, stored)


def along_track():
    """The picture of the example with a dipped weld."""
    return of_example("dipped_weld")


def around_wheel():
    """The picture of the example with a flat."""
    return of_example("wheel_flat")


def of_example(name):
    """The figure that an example draws."""
    example = Path(__file__).resolve().parents[1] / "examples" / f"{name}.py"
    with TemporaryDirectory() as folder, inside(folder):
        return runpy.run_path(str(example))["figure"]


@style.styled
def frames():
    """Five sketches: the track frame from behind and from above, the profile frames, and the contact
    plane."""
    figure = style.new_figure(10.5, 6.9)
    upper, lower = figure.subfigures(2, 1, height_ratios=(1.25, 1))
    behind, above = upper.subplots(1, 2, width_ratios=(1.75, 1))
    wheel, rail, plane = lower.subplots(1, 3)
    system = ContactSystem()
    centred, leaning = system.evaluate(), system.evaluate(lateral_shift=6e-3)
    draw_from_behind(behind, system, centred)
    draw_from_above(above)
    draw_wheel_frame(wheel, system)
    draw_rail_frame(rail, system)
    draw_contact_plane(plane, system, leaning)
    for panel in (behind, above, wheel, rail, plane):
        panel.set_axis_off()
        panel.set_aspect("equal")
    return figure


def sections():
    """The artificial nose of CONTACT's test bank: arcs of 5 mm beside a top 10 mm wide, walls at 80 deg, rising 1:10."""
    turn = np.radians(np.linspace(80.0, 0.0, 70))
    y, z = 5.0 - 5.0 * np.sin(turn), 5.0 * (1.0 - np.cos(turn))
    wall = np.arange(z[0] + 20.0, z[0], -0.1)
    side = np.column_stack([np.r_[y[0] - (wall - z[0]) / np.tan(turn[0]), y], np.r_[wall, z]])
    top = np.column_stack([np.arange(5.1, 14.95, 0.1), np.zeros(99)])
    points = np.concatenate([side, top, side[::-1] * [-1.0, 1.0] + [20.0, 0.0]]) * MM
    u = np.linspace(-0.1, 0.1, 21)
    nose = RailSections(
        u, [points] * 21, places=np.column_stack([0.0 * u, -0.1 * u]), name="Nose of a crossing"
    )
    return sections_figure(nose)


@style.styled
def conformal():
    """Peak pressure over the arc and outline of the right wheel's patches at three poses, by both
    theories."""
    from benchmarks.errors import planar_contact
    from wrcontact.halfspace.edge import chords, edge_field

    figure = style.new_figure(10.5, 5.4)
    panels = figure.subplots(2, 3, sharex="col", height_ratios=(1.2, 1))
    rigid, halfspace = ContactSystem(), ContactSystem(normal_model="halfspace", stations=201)
    for (upper, lower), shift in zip(panels.T, (1e-3, 6e-3, 6.25e-3)):
        planar = planar_contact(rigid, rigid.evaluate(shift, 0.0, FORCE), FORCE)
        turning = halfspace.evaluate(shift, 0.0, FORCE, side="right").right.outline
        half = 0.5 * chords(edge_field(planar.pressure)) * (planar.x[1] - planar.x[0])
        for station, pressure, length, colour, name in (
            (planar.s, planar.pressure.max(axis=0), half, QUIET, "one plane"),
            (turning.station, turning.pressure, turning.half_length, CONTACT_COLOUR, "conformal"),
        ):
            there = np.append(length[1:], 0.0) + np.append(0.0, length[:-1]) + length > 0.0
            station, pressure, length = (
                np.where(there, each, np.nan) for each in (station, pressure, length)
            )
            upper.plot(station / MM, pressure / style.MEGAPASCAL, color=colour, label=name)
            for sign in (-1, 1):
                lower.plot(station / MM, sign * length / MM, color=colour)
        upper.set_title(f"{shift / MM:g} mm")
        upper.set_ylim(0.0)
        lower.set_xlabel("arc from the contact point, mm")
    panels[0, 0].set_ylabel("largest pressure at a station, MPa")
    panels[1, 0].set_ylabel("edge along the track, mm")
    panels[0, 0].legend()
    return figure


def source(number):
    """A figure of the degree project that wrcontact started from."""
    from wrcontact.study.figures import Study, compute
    from wrcontact.study.pictures import source_figure

    return source_figure(compute(number, Study()))


PICTURES = {
    "frames": frames,
    "demo": demo,
    "check": check,
    "profiles": lambda: draw_profiles(every_profile()),
    "sections": sections,
    "along_track": along_track,
    "around_wheel": around_wheel,
    "models": models,
    "conformal": conformal,
    "source_5_8": partial(source, "5.8"),
    "source_7_14": partial(source, "7.14"),
}


# --- sketches --------------------------------------------------------------------------------------


def draw_from_behind(panel, system, state):
    """Wheelset and rails seen in the direction of travel, with the track frame."""
    panel.set_title("Track frame, seen from behind in the direction of travel")
    radius = system.parameters["nominal_radius"]
    for side in ("left", "right"):
        y, z = wheel_outline(system, state, side)
        around = np.append(-z, 2 * radius + z[::-1])  # down at the rail, up over the axle
        panel.fill(np.append(y, y[::-1]) / MM, around / MM, color=WHEEL_COLOUR, alpha=0.25, linewidth=0)
        y, z = rail_outline(system, side)
        panel.fill(y / MM, -z / MM, color=RAIL_COLOUR, alpha=0.7, linewidth=0)
    panel.plot([-900, 900], [radius / MM] * 2, color=WHEEL_COLOUR, linewidth=1, linestyle=(0, (8, 3, 2, 3)))
    panel.plot([-900, 900], [0, 0], color=QUIET, linewidth=0.6)
    axis(panel, (0, 0), (230, 0), "y")
    axis(panel, (0, 0), (0, -230), "z")
    into_page(panel, (0, 0), 16, "x", (-24, -30))
    turn(panel, (0, radius / MM), 170, (150, 30), "roll", (0, 200))
    axis(panel, (0, 840), (260, 0), "lateral_shift", above=True)
    dimension(panel, -717.5, 717.5, -115, "gauge 1435 mm, at 14 mm depth")
    dimension(panel, -750, 750, 1010, "running circles 1500 mm")
    panel.text(
        -752, radius / MM + 190, "left wheel", ha="center", rotation=90, va="center", color=WHEEL_COLOUR
    )
    panel.text(
        752, radius / MM + 190, "right wheel", ha="center", rotation=90, va="center", color=WHEEL_COLOUR
    )
    panel.text(430, 8, "top of rail", color=QUIET, fontsize=8, ha="center", va="bottom")
    panel.set(xlim=(-930, 930), ylim=(-270, 1080))


def draw_from_above(panel):
    """A yawed wheelset seen from above, x up the page."""
    panel.set_title("Track frame, seen from above")
    for y in (-760, 760):
        panel.fill_between([y - 36, y + 36], -700, 700, color=RAIL_COLOUR, alpha=0.5, linewidth=0)
    # x up, y right: clockwise
    turned = np.array([[np.cos(TURNED), np.sin(TURNED)], [-np.sin(TURNED), np.cos(TURNED)]])
    for y in (-750, 750):
        corners = np.array([[y - 65, -420], [y + 65, -420], [y + 65, 420], [y - 65, 420]]) @ turned.T
        panel.fill(*corners.T, color=WHEEL_COLOUR, alpha=0.35, linewidth=0)
    panel.plot(
        *(np.array([[-900, 0], [900, 0]]) @ turned.T).T,
        color=WHEEL_COLOUR,
        linewidth=1,
        linestyle=(0, (8, 3, 2, 3)),
    )
    axis(panel, (0, 0), (0, 480), "x", shift=(30, -10))
    axis(panel, (0, 0), (420, 0), "y", above=True)
    into_page(panel, (0, 0), 26, "z", (-55, -85))
    turn(panel, (0, 0), 310, (150, 55), "yaw", (-270, 285))
    panel.set(xlim=(-980, 980), ylim=(-720, 720))


def draw_wheel_frame(panel, system):
    """The right wheel's profile frame with the zones of the S1002."""
    panel.set_title("Wheel profile frame, right wheel")
    y = np.linspace(-69.9, 60, 900)
    z = system.wheel.height(y * MM) / MM
    panel.fill_between(y, -z, 42, color=WHEEL_COLOUR, alpha=0.2, linewidth=0)
    panel.plot(y, -z, color=WHEEL_COLOUR)
    for name, (low, high) in WHEEL_ZONES.items():
        panel.plot([low / MM] * 2, [-34, 42], color=QUIET, linewidth=0.5, linestyle=":")
        middle = (low + high) / 2 / MM
        panel.text(middle, 38, name.replace(" ", "\n"), color=QUIET, style="italic", ha="center", va="top")
    panel.text(-72, -46, "track side", color=QUIET, fontsize=8, ha="left")
    panel.text(60, -46, "field side", color=QUIET, fontsize=8, ha="right")
    axis(panel, (0, 0), (34, 0), "y", above=True)
    axis(panel, (0, 0), (0, -28), "z", shift=(3, 0))
    panel.text(-6, -33, "radius = nominal radius + z", fontsize=8, va="top")
    panel.set(xlim=(-76, 66), ylim=(-50, 46))


def draw_rail_frame(panel, system):
    """The right rail's profile frame; the head is inclined towards the track centre."""
    panel.set_title("Rail profile frame, right rail")
    y, z = rail_outline(system, "right")
    top = y[np.argmin(z)]
    y, z = (y - top) / MM, z / MM
    panel.fill(y, -z, color=RAIL_COLOUR, alpha=0.3, linewidth=0)
    panel.plot(y, -z, color=RAIL_COLOUR)
    inner = np.interp(14, z[: np.argmin(z)][::-1], y[: np.argmin(z)][::-1])
    panel.plot([inner - 26, inner], [-14, -14], color=QUIET, linewidth=0.8)
    panel.plot([inner], [-14], "o", color=INK, markersize=4)
    panel.text(
        inner - 2,
        -17,
        "gauge\n14 mm below\nthe highest\npoint",
        fontsize=8,
        ha="right",
        va="top",
        color=RAIL_LABEL,
    )
    panel.text(0, -36, "leans 1:40 to the\ntrack centre", fontsize=8, ha="center", color=RAIL_LABEL)
    axis(panel, (0, 0), (34, 0), "y", above=True)
    axis(panel, (0, 0), (0, -22), "z", shift=(3, 0))
    panel.text(0, 14, "origin: highest point of the inclined head", fontsize=8, ha="center")
    panel.set(xlim=(-76, 66), ylim=(-50, 46))


def draw_contact_plane(panel, system, state):
    """Contact plane and contact angle of a right wheel at the flange root."""
    panel.set_title("Contact plane, right wheel")
    rail, wheel = rail_outline(system, "right"), wheel_outline(system, state, "right")
    for (y, z), colour, end in ((rail, RAIL_COLOUR, -60), (wheel, WHEEL_COLOUR, 60)):
        panel.fill_between(y / MM, -z / MM, end, color=colour, alpha=0.2, linewidth=0)
        panel.plot(y / MM, -z / MM, color=colour)
    contact, angle = state.right.contact, state.right.contact_angle
    point = np.array([contact.y_track, -contact.z_track]) / MM
    along, normal = np.array([np.cos(angle), np.sin(angle)]), np.array([-np.sin(angle), np.cos(angle)])
    ends = np.array([point - 24 * along, point + 30 * along])
    panel.plot(*ends.T, color=CONTACT_COLOUR, linewidth=1, linestyle=(0, (4, 2)))
    panel.plot([point[0], point[0] + 30], [point[1]] * 2, color=QUIET, linewidth=0.8)
    panel.add_patch(Arc(point, 44, 44, theta1=0, theta2=np.degrees(angle), color=INK, linewidth=1.2))
    on_arc = point + 22 * np.array([np.cos(angle / 4), np.sin(angle / 4)])
    panel.annotate(
        "contact_angle,\nhere positive",
        on_arc,
        point + np.array([14, -11]),
        fontsize=8,
        va="top",
        arrowprops={"arrowstyle": "-", "color": QUIET, "linewidth": 0.7},
    )
    axis(panel, point, 20 * along, "station s", shift=(-7, 6))
    axis(panel, point, 16 * normal, "normal", shift=(-12, 2))
    panel.plot(*point, "o", color=CONTACT_COLOUR, markersize=5)
    panel.set(xlim=(688, 782), ylim=(-36, 28))


# --- strokes ---------------------------------------------------------------------------------------


def axis(panel, start, stroke, name, *, above=False, shift=None):
    """An arrow with its name at the tip, or above it."""
    tip = np.add(start, stroke)
    panel.annotate("", tip, start, arrowprops=ARROW)
    if shift is not None:
        panel.text(*np.add(tip, shift), name)
    elif above:
        near_tip = np.add(start, np.multiply(stroke, 0.95))
        panel.annotate(name, near_tip, (0, 4), textcoords="offset points", ha="right", va="bottom")
    else:
        panel.annotate(name, tip, (4, 0), textcoords="offset points", va="center")


def into_page(panel, centre, size, name, shift):
    """A circle with a cross: an axis that points away from the reader."""
    angle = np.linspace(0, 2 * np.pi, 60)
    panel.fill(
        centre[0] + size * np.cos(angle),
        centre[1] + size * np.sin(angle),
        facecolor="white",
        edgecolor=INK,
        zorder=4,
    )
    reach = 0.7 * size
    for rise in (reach, -reach):
        ends = [centre[0] - reach, centre[0] + reach], [centre[1] - rise, centre[1] + rise]
        panel.plot(*ends, color=INK, linewidth=1, zorder=5)
    panel.text(*np.add(centre, shift), name, ha="right")


def turn(panel, centre, radius, span, name, shift):
    """A clockwise arrow around ``centre`` over ``span`` (from, to) in degrees."""
    angle = np.radians(np.linspace(*span, 40))
    y, z = centre[0] + radius * np.cos(angle), centre[1] + radius * np.sin(angle)
    panel.plot(y, z, color=CONTACT_COLOUR, linewidth=1.4)
    panel.annotate("", (y[-1], z[-1]), (y[-3], z[-3]), arrowprops={**ARROW, "color": CONTACT_COLOUR})
    panel.text(*np.add(centre, shift), name, color=CONTACT_COLOUR, ha="center", va="center")


def dimension(panel, low, high, height, words):
    """A dimension line."""
    look = {**ARROW, "arrowstyle": "<|-|>", "color": QUIET, "linewidth": 0.8}
    panel.annotate("", (low, height), (high, height), arrowprops=look)
    panel.text(0.56 * low, height + 12, words, color=QUIET, fontsize=8, ha="center", va="bottom")


if __name__ == "__main__":
    main(sys.argv[1:] or [*PICTURES, "gallery"])
