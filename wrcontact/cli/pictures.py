"""Kinds of pictures of ``wrcontact plot``, the options that each reads, and how it is drawn."""

import re
import sys
from dataclasses import dataclass
from inspect import Parameter
from pathlib import Path
from typing import Annotated

import typer

from ..methods.numbers import check_choice
from .adding import adding, option
from .errors import Refused, check_file, sentences
from .options import POSE, SYSTEM, name_of, option_of

PICTURES, ANIMATIONS = (".png", ".svg", ".pdf"), (".gif", ".mp4")


@dataclass(frozen=True)
class Kind:
    """A kind of picture: the inputs of ``pose`` that it reads ("all", "along" for all but the position along the track, "yaw",
    "none"), whether it needs a system, and its own options."""

    pose: str = "all"
    system: bool = True
    options: tuple = ()


KINDS = {
    "pose": Kind(),
    "lines": Kind("yaw", options=("side",)),
    "radii": Kind("yaw"),
    "angles": Kind("yaw"),
    "roll": Kind("yaw"),
    "wheel": Kind(options=("side",)),
    "patch": Kind(options=("side", "colour")),
    "creep": Kind(options=("side", "over")),
    "along": Kind("along"),
    "history": Kind("none", system=False, options=("run", "names", "over")),
    "animation": Kind("none", options=("run", "frames")),
}
STARTS = {"side": "right", "colour": "pressure", "frames": 60}
#: Options by name: kind of value, metavar and words.
OWN = {
    "output": (
        Path,
        "FILE",
        "Its file: .png, .svg, .pdf, animations .gif, .mp4 (default: KIND.png or .gif)",
    ),
    "side": (str, "left|right", "Wheel of lines, wheel, patch and creep"),
    "colour": (str, "pressure|shear|slip", "Colours of a patch"),
    "over": (str, "NAME", "Axis of creep: creepage_x, creepage_y, spin; of history: a column"),
    "run": (Path, "FILE", "CSV file of history and animation, in SI with the names of the FMU"),
    "names": (str, "NAME[,NAME]", "Columns of a history, of one unit"),
    "frames": (int, "NUMBER", "Frames of an animation"),
}
#: An option's name in Python at the beginning of a sentence.
OPTION = re.compile(rf"^({'|'.join(OWN)})\b(?= is )")


@dataclass(frozen=True)
class Picture:
    """A picture that was asked for: its kind, file, and options by name."""

    name: str
    output: Path
    chosen: dict

    @property
    def kind(self):
        return KINDS[self.name]

    @property
    def of_pose(self):
        """Whether it shows one pose."""
        return self.kind.pose == "all"

    def check(self, pose, system):
        """Refuse options that this kind does not read, a wrong choice, and a file that cannot be written."""
        for own in set(OWN) - {"output", *self.kind.options}:
            if self.chosen[own] != STARTS.get(own):
                kinds = " or ".join(name for name, kind in KINDS.items() if own in kind.options)
                raise Refused(f"--{own} is given; it is permitted only with plot {kinds}")
        read = {"all": set(pose), "along": set(pose) - {"track_position"}, "yaw": {"yaw"}, "none": set()}[
            self.kind.pose
        ]
        for variables, unread in (
            (POSE, set(pose) - read),
            (SYSTEM, set() if self.kind.system else set(system)),
        ):
            for variable in variables:
                if variable.name == "lateral_shift" and name_of(variable) in unread:
                    print(f"wrcontact: plot {self.name} does not use {option_of(variable)}", file=sys.stderr)
                    del pose[variable.name]
                elif name_of(variable) in unread:
                    raise Refused(f"{option_of(variable)} is given; plot {self.name} does not use it")
        if "run" in self.kind.options and self.chosen["run"] is None:
            raise Refused(f"--run is missing; plot {self.name} needs the CSV file of a run")
        if self.name == "history" and not self.chosen["names"]:
            raise Refused("--names is missing; plot history needs the names of columns")
        with sentences():
            check_choice("--side", self.chosen["side"], ("left", "right"))
            check_choice("--colour", self.chosen["colour"], ("pressure", "shear", "slip"))
        endings = ANIMATIONS if self.name == "animation" else PICTURES
        if self.output.suffix.lower() not in endings:
            raise Refused(
                f"--output is {str(self.output)!r}; permitted are files that end in {', '.join(endings)}"
            )
        check_file(self.output)

    def write(self, system, pose, state):
        """Draw and save it; ``system`` and ``state`` are those of the options, where the kind reads them."""
        from .. import plots

        chosen = self.chosen
        with sentences(lambda sentence: OPTION.sub(r"--\1", sentence)):
            if self.name == "animation":
                plots.animate(system, chosen["run"], self.output, frames=chosen["frames"])
                return
            plots.save(_DRAW[self.name](plots, system, pose, state, chosen), self.output)


def _draw_creep(plots, system, pose, state, chosen):
    """Creep curves of the patch with the largest load, with its other creepages as they are."""
    from ..creep import patch_of

    side, over = chosen["side"], chosen["over"] or "creepage_x"
    material = {name: system.parameters[name] for name in ("youngs_modulus", "poisson_ratio")}
    patch, _ = patch_of(state, side, **material)
    return plots.creep_curves(patch, over=over, friction=state.inputs[f"{side}.friction"])


def _draw_history(plots, system, pose, state, chosen):
    names = [name.strip() for name in chosen["names"].split(",")]
    return plots.history(chosen["run"], names, over=chosen["over"] or "time")


def _over_shift(draw):
    """Draw one quantity over the lateral shift."""
    return lambda plots, system, pose, state, chosen: getattr(plots, draw)(plots.sweep(system, **pose))


_DRAW = {
    "pose": lambda plots, system, pose, state, chosen: plots.pose_figure(system, state),
    "lines": lambda plots, system, pose, state, chosen: plots.contact_lines(
        system, side=chosen["side"], **pose
    ),
    "radii": _over_shift("radius_difference"),
    "angles": _over_shift("contact_angle"),
    "roll": _over_shift("roll_angle"),
    "along": lambda plots, system, pose, state, chosen: plots.along_track_figure(system, **pose),
    "wheel": lambda plots, system, pose, state, chosen: plots.wheel_on_rail(
        system, state, side=chosen["side"]
    ),
    "patch": lambda plots, system, pose, state, chosen: plots.patch_map(
        system, state, side=chosen["side"], colour=chosen["colour"]
    ),
    "creep": _draw_creep,
    "history": _draw_history,
}


def draws(command):
    """Decorator that adds the argument KIND and the options of pictures to a command, which gets a
    :class:`Picture` as ``picture``."""

    def fold(given):
        name, chosen = given.pop("kind"), {own: given.pop(own) for own in OWN}
        with sentences():
            check_choice("KIND", name, KINDS)
        output = chosen.pop("output") or Path(f"{name}.{'gif' if name == 'animation' else 'png'}")
        return given | {"picture": Picture(name, output, chosen)}

    kind = Annotated[str, typer.Argument(metavar="KIND", help="Kind of the picture")]
    options = [
        option(
            name,
            typed,
            STARTS.get(name),
            f"--{name}",
            metavar=metavar,
            help=words,
            show_default=name in STARTS,
            hidden=name == "frames",
        )
        for name, (typed, metavar, words) in OWN.items()
    ]
    kind = Parameter("kind", Parameter.KEYWORD_ONLY, default="pose", annotation=kind)
    return adding(command, [kind, *options], fold, ("picture",))
