"""The check of a pair as JSON."""

import dataclasses
import json

from ..interface.parameters import GEOMETRY, LEFT, SIDED
from ..results.words import plain


def check_text(report):
    """A :class:`~wrcontact.conditioning.Conditioning` as JSON in SI with its attribute names; null for
    NaN."""
    right, left = report.system.parameters, report.system.side_parameters("left")
    fields = {field.name: getattr(report, field.name) for field in dataclasses.fields(report)}
    system = {
        "wheel": report.wheel.name,
        "rail": report.rail.name,
        **{name: right[name] for name in GEOMETRY},
    }
    if not report.system.equal_sides:
        system |= {
            "left_wheel": report.left_wheel.name,
            "left_rail": report.left_rail.name,
            **{LEFT + name: left[name] for name in SIDED if name in GEOMETRY},
        }
    return json.dumps(plain({**fields, "system": system}), indent=1)
