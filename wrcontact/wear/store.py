"""A folder with the steps of a run of wear, so that it goes on where it was interrupted."""

import json
import zlib
from dataclasses import asdict
from pathlib import Path

import numpy as np

from ..profiles.files import prepared_text, read_profile
from ..profiles.options import ProfileFile
from ..profiles.profile import Profile
from ..storage.atomic import write_atomically
from ..storage.hashes import content_hash
from ..version import __version__
from .laws import law_mark
from .rows import whole_of
from .shape import WheelShape
from .steps import WearStep


class Store:
    """The folder of a run; None keeps nothing.

    Each step is ``step_00000.json``, and the worn profiles behind it are prepared profiles such as
    ``worn_00000_right.json``, which :class:`~wrcontact.ContactSystem` reads.
    """

    def __init__(self, folder, plan, system):
        self.folder, self.plan = None if folder is None else Path(folder), plan
        whole, side = whole_of(system)
        zones = [prepared_text(one) for one in (whole.left_wheel, whole.wheel, whole.left_rail, whole.rail)]
        numbers = sorted(
            f"{name}={value!r}"
            for name, value in whole.parameters.items()
            if not name.endswith(("wheel", "rail"))
        )
        options = sorted(map(repr, plan.options.items()))
        #: A digest by what a run is made of; the law is one of values, since functions may have one name.
        self.mark = {
            "version": __version__,
            "profiles": _digest(zones),
            "law": _digest(law_mark(plan.law)),
            "steps": _digest([plan.part, plan.depth_step, plan.smoothing, options]),
            "parameters": _digest([numbers, side]),
        }

    def read(self):
        """Steps so far, and the worn profiles behind the last one by side, or None."""
        if self.folder is None:
            return [], None
        self.folder.mkdir(parents=True, exist_ok=True)
        steps = []
        while self._file(len(steps)).exists():
            content = self._content(len(steps))
            others = _others(content["mark"], self.mark)
            if others:
                raise ValueError(
                    f"store is {str(self.folder)!r}, which has another run, with another {' and '.join(others)}; "
                    "permitted is an empty folder, or that of a run with the same profiles, law and steps"
                )
            if content["distance"] + content["length"] > self.plan.mileage * (1.0 + 1e-9):
                raise ValueError(
                    f"mileage is {self.plan.mileage:g} and the store has "
                    f"{content['distance'] + content['length']:g} already; permitted is at least "
                    "that"
                )
            if content["length"] == 0.0 and content["distance"] < self.plan.mileage * (1.0 - 1e-9):
                break  # the end of a run that goes on now
            steps.append(self._step(content, len(steps)))
        if not steps or steps[-1].length == 0.0:
            return steps, None
        return steps, {side: self._profile(len(steps) - 1, side) for side in self.plan.new}

    def write(self, step, worn, number):
        """Keep a step, and the ``worn`` profiles by side behind it."""
        if self.folder is None:
            return
        texts = {side: prepared_text(profile).encode() for side, profile in (worn or {}).items()}
        for side, text in texts.items():
            write_atomically(self._profile_file(number, side), text)
        content = {
            "mark": self.mark,
            "worn": {side: zlib.crc32(text) for side, text in texts.items()},
            "distance": step.distance,
            "length": step.length,
            "depth": {side: [part.tolist() for part in both] for side, both in step.depth.items()},
            "taken": step.taken,
            "conicity": step.conicity,
            "shares": step.shares,
            "left_out": step.left_out,
            "shapes": {side: asdict(shape) for side, shape in step.shapes.items()},
        }
        write_atomically(self._file(number), json.dumps(content | {"sum": _sum(content)}).encode())

    def _content(self, number):
        """What is in a step's file, whole with the profiles behind it; ValueError otherwise."""
        path = self._file(number)
        try:
            content = json.loads(path.read_text(encoding="utf-8"))
            if content.pop("sum") == _sum(content):
                for side, digest in content["worn"].items():
                    path = self._profile_file(number, side)
                    if zlib.crc32(path.read_bytes()) != digest:
                        raise ValueError
                return content
        except (ValueError, LookupError, TypeError, AttributeError, FileNotFoundError):
            pass
        raise ValueError(
            f"store is {str(self.folder)!r}, where {path.name} is damaged or not of this version; permitted are the "
            f"files as wear_run wrote them; without {self._file(number).name} and all later steps the run goes on "
            "from there"
        )

    def _step(self, content, number):
        profiles = {
            side: self._profile(number - 1, side) if number else new for side, new in self.plan.new.items()
        }
        depth = {side: tuple(map(np.array, both)) for side, both in content["depth"].items()}
        shapes = {side: WheelShape(**shape) for side, shape in content["shapes"].items()}
        return WearStep(
            content["distance"],
            content["length"],
            profiles,
            depth,
            content["taken"],
            shapes,
            content["conicity"],
            content["shares"],
            content["left_out"],
        )

    def _profile(self, number, side):
        return read_profile(ProfileFile(self._profile_file(number, side)), self.plan.part, None, Profile)

    def _profile_file(self, number, side):
        return self.folder / f"worn_{number:05d}_{side}.json"

    def _file(self, number):
        return self.folder / f"step_{number:05d}.json"


def _digest(words):
    return content_hash(json.dumps(words))


def _sum(content):
    """A number by which a change of a step's ``content`` is seen."""
    return zlib.crc32(json.dumps(content).encode())


def _others(there, here):
    """Names of what differs between two marks."""
    return [name for name in here if not isinstance(there, dict) or there.get(name) != here[name]]
