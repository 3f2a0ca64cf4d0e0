"""Animation of a run: the wheelset on its track from above, both contacts from behind, and the patches on
the rails."""

import os
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib
import numpy as np
from matplotlib.animation import FFMpegWriter, PillowWriter
from PIL import Image

from ..conventions import SIDES
from ..progress import tracked
from ..storage.atomic import write_atomically
from .animation_frames import frames_of, shifted
from .patch import draw_patch, missing, patch_places
from .pose import draw_contact
from .style import DEGREE, INK, MM, QUIET, RAIL_COLOUR, SIDE_COLOUR, WHEEL_COLOUR, new_figure, number, styled

ENDINGS = (".gif", ".mp4")
MOST_FRAMES, RATE = 60, 12  # of an animation, and frames in a second of it
RESOLUTION = 80  # dots per inch
COLOURS, ROUNDS = 128, 2  # of a GIF, and of the choice of its colours
#: Lateral shift and yaw are this many times larger in the view from above.
LARGER = 30.0
#: [m] seen ahead of and behind the wheelset, distance of sleepers, their half length and half width.
AHEAD, SLEEPERS, SLEEPER_ENDS, SLEEPER = 1.5, 0.6, 1.3, 0.12


@styled
def animate(system, run, path, *, frames=MOST_FRAMES, rate=RATE):
    """Write an animation of a run of a wheelset.

    The states are computed by ``system`` from the inputs of the run, such as ``lateral_shift``, ``yaw``,
    ``speed`` and ``normal_force``; those that it does not have are as in ``evaluate``.  In ``contact_mode``
    compliant the wheelset's ``vertical_shift`` and ``roll`` are inputs.

    Parameters
    ----------
    system : a :class:`~wrcontact.ContactSystem`.
    run : a table of states, or arrays (n,) in SI by FMU name, as for :func:`history`, or the path of a CSV
        file.
    path : of the file; the ending says the format, .gif or .mp4, which needs ffmpeg.
    frames : at most so many rows of the run are drawn, evenly.
    rate : frames in a second.

    Returns
    -------
    path

    Raises
    ------
    ValueError
        in a sentence, where the run has no lateral shift or no pose with contact, or there is no ffmpeg.
    """
    writer = _writer(path, rate)
    states = frames_of(system, run, frames)
    figure = new_figure(9.6, 4.4)
    above, right = figure.subfigures(1, 2, width_ratios=(1, 2.6))
    panels = _Panels(above.subplots(), *right.subplots(2, 2, height_ratios=(1, 1.1)))
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"animation{Path(path).suffix.lower()}"
        with writer.saving(figure, str(file), RESOLUTION):
            for frame in tracked(range(len(states.rows)), "frames"):
                _draw(figure, panels, states, frame)
                if frame == 0:
                    figure.draw_without_rendering()
                    figure.set_layout_engine("none")
                writer.grab_frame()
        write_atomically(path, file.read_bytes())
    return path


def _writer(path, rate):
    """The writer for the file's ending."""
    ending = Path(path).suffix.lower()
    if ending not in ENDINGS:
        raise ValueError(
            f"path is {os.fspath(path)!r}; permitted are files that end in {' or '.join(ENDINGS)}"
        )
    if not (np.isfinite(rate) and 0.0 < rate <= 100.0):
        raise ValueError(f"rate is {rate:g} frames per second; permitted are values above 0 up to 100")
    if ending == ".gif":
        return _Gif(fps=rate)
    if find_spec("imageio_ffmpeg"):
        import imageio_ffmpeg

        matplotlib.rcParams["animation.ffmpeg_path"] = imageio_ffmpeg.get_ffmpeg_exe()
    if not FFMpegWriter.isAvailable():
        raise ValueError(
            f"path is {os.fspath(path)!r}, which needs ffmpeg, and there is none; permitted is a file that "
            "ends in .gif; pip install 'wrcontact[films]' brings ffmpeg"
        )
    return FFMpegWriter(fps=rate, codec="libx264", extra_args=["-pix_fmt", "yuv420p"])


class _Gif(PillowWriter):
    """Frames in one palette and without grain, which takes a third of the memory."""

    def finish(self):
        frames = [frame.convert("RGB") for frame in self._frames]
        few = frames[:: max(1, len(frames) // 6)]
        sheet = Image.new("RGB", (frames[0].width, frames[0].height * len(few)))
        for place, frame in enumerate(few):
            sheet.paste(frame, (0, place * frame.height))
        palette = sheet.quantize(COLOURS, kmeans=ROUNDS)
        first, *rest = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
        first.save(self.outfile, save_all=True, append_images=rest, duration=round(1000 / self.fps), loop=0)


@dataclass(frozen=True)
class _Panels:
    """View from above, contacts and patches of both sides."""

    above: object
    contacts: object
    patches: object


def _draw(figure, panels, states, frame):
    """Draw one frame into the panels."""
    state = states.rows[frame]
    for panel in (panels.above, *panels.contacts, *panels.patches):
        panel.clear()
    _draw_above(panels.above, states, frame)
    for side, contact, patch in zip(SIDES, panels.contacts, panels.patches):
        draw_contact(contact, states.system, state, side)
        contact.set(xlabel="across the track [mm]", ylabel="up [mm]" if side == "left" else "")
        contact.set_title(f"{side.capitalize()} wheel, from behind")
        _draw_patch(patch, states, state, side)


def _draw_above(panel, states, frame):
    """Rails, sleepers and wheelset from above, x up the page [m]."""
    state, arm = states.rows[frame], states.system.parameters["running_circle_distance"] / 2
    first = np.floor((states.distance[frame] - AHEAD) / SLEEPERS)
    for k in first + np.arange(int(2 * AHEAD / SLEEPERS) + 3):
        x = k * SLEEPERS - states.distance[frame]
        panel.fill_between(
            [-SLEEPER_ENDS, SLEEPER_ENDS], x - SLEEPER, x + SLEEPER, color="#E9E4DC", linewidth=0
        )
    for y in (-arm, arm):
        panel.fill_between([y - 0.036, y + 0.036], -AHEAD, AHEAD, color=RAIL_COLOUR, alpha=0.8, linewidth=0)
    yaw, shift = LARGER * state.inputs.yaw, LARGER * state.inputs.lateral_shift
    turn = np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]])  # x up, y right: clockwise
    panel.plot(
        *((turn.T @ [[0.0, 0.0], [-1.0, 1.0]])[::-1] + [[shift], [0.0]]), color=WHEEL_COLOUR, linewidth=3
    )
    for y in (-arm, arm):
        corners = np.array([[-0.46, 0.46, 0.46, -0.46], [y - 0.07, y - 0.07, y + 0.07, y + 0.07]])
        x, y = turn.T @ corners
        panel.fill(y + shift, x, color=WHEEL_COLOUR, alpha=0.55, linewidth=0)
    panel.plot([0, 0], [-AHEAD, AHEAD], color=QUIET, linewidth=0.6, linestyle=(0, (8, 3, 2, 3)))
    time = states.time[frame]
    panel.set(
        xlim=(-SLEEPER_ENDS - 0.05, SLEEPER_ENDS + 0.05),
        ylim=(-AHEAD, AHEAD),
        aspect="equal",
        xticks=[],
        yticks=[],
    )
    for spine in panel.spines.values():
        spine.set_visible(False)
    panel.set_title(
        (f"{number(time, 2)} s" if np.isfinite(time) else f"pose {frame + 1}")
        + f"\nshift {number(state.inputs.lateral_shift / MM, 1)} mm, yaw "
        f"{number(state.inputs.yaw / DEGREE, 2)}°"
    )
    panel.text(
        0.5,
        -0.01,
        f"shift and yaw {LARGER:g} times larger",
        transform=panel.transAxes,
        ha="center",
        va="top",
        fontsize=8,
        color=INK,
    )


def _draw_patch(panel, states, state, side):
    """The patches of one side on the rail as seen from above, the field side outside."""
    wheel, (low, high, along) = getattr(state, side), states.window
    panel.set(
        xlim=(low, high) if side == "right" else (high, low),
        ylim=(-along, along),
        aspect="equal",
        xlabel="on the rail from its top, field side + [mm]",
        ylabel="along [mm]" if side == "left" else "",
    )
    panel.axvline(0.0, color=QUIET, linewidth=0.6, linestyle=":")
    if missing(wheel):
        panel.set_title(f"{side.capitalize()} wheel: {missing(wheel)}")
        return
    draw_patch(
        panel, shifted(states.system, state, side), states.scale, patch_places(states.system, state, side)
    )
    panel.set_title(
        f"{number(wheel.normal_force / 1e3, 0)} kN, up to {number(wheel.max_pressure / 1e6, 0)} MPa",
        color=SIDE_COLOUR[side],
    )
