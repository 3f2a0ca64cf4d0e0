"""Planar gaps with the frictionless solution that CONTACT finds for them."""

import json

from .paths import REFERENCE_DATA


def planar_cases():
    return json.loads((REFERENCE_DATA / "contact_planar.json").read_text())["cases"]
