"""The check of a pair as JSON, and its headline."""

import dataclasses
import json

from ..interface.parameters import GEOMETRY, LEFT, SIDED
from ..results.words import plain


def headline(report):
    """The pair, track and wheelset of a report in one line."""
    chosen, mm = report.system.parameters, {}
    for name in ("gauge", "nominal_radius", "running_circle_distance"):
        mm[name] = f"{chosen[name] * 1e3:.6g} mm"
    lean = chosen["rail_inclination"]
    return (
        f"{report.system.title}: gauge {mm['gauge']}, {f'inclination 1:{1 / lean:.4g}' if lean else 'rails upright'}, "
        f"nominal radius {mm['nominal_radius']}, running circles {mm['running_circle_distance']} apart"
        f"{differing_left(report.system)}; without yaw"
    )


def differing_left(system):
    """What a headline adds on the left side: its nominal radius and inclination where they differ."""
    right, left, words = system.parameters, system.side_parameters("left"), []
    if left["nominal_radius"] != right["nominal_radius"]:
        words.append(f"nominal radius {left['nominal_radius'] * 1e3:.6g} mm")
    if left["rail_inclination"] != right["rail_inclination"]:
        lean = left["rail_inclination"]
        words.append(f"inclination 1:{1 / lean:.4g}" if lean else "upright rail")
    return f"; on the left {', '.join(words)}" if words else ""


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
