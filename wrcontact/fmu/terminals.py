"""The icon of an FMU, and of FMI 3 its folder terminalsAndIcons: variables in groups that connect as one."""

from xml.etree.ElementTree import Element, SubElement

from ..conventions import SIDES
from ..interface.friction import FRICTION as FRICTION_INPUTS
from ..interface.inputs import DEFLECTIONS, RATES, TIME_STEP, TORQUES
from ..interface.inputs import MOTION as MOTION_INPUTS
from ..interface.inputs import RAILS as RAIL_INPUTS
from ..interface.variables import INPUT_VARIABLES, OUTPUT, VARIABLES
from .archive import SOURCES
from .description import xml_file
from .variants import WHEELSET

#: Inputs by what they are called in a connection: an axle's pose has no variable "roll_input".
POSE = {
    "lateral_shift": "lateral_shift",
    "vertical_shift": "vertical_shift_input",
    "roll": "roll_input",
    "yaw": "yaw",
    "roll_guess": "roll_guess",
    "track_position": "track_position",
    "wheel_rotation": "wheel_rotation",
}
RAILS = {row.name: row.name for row in (*RAIL_INPUTS, TIME_STEP, *DEFLECTIONS)}
MOTION = {row.name: row.name for row in (*MOTION_INPUTS, *RATES, *TORQUES)}
FRICTION = {row.name: row.name for row in FRICTION_INPUTS}
LOAD = {"normal_force": "normal_force", "load_transfer": "load_transfer"}


def terminals_and_icons(version, names, variant=WHEELSET):
    """Entries of the archive for FMI ``version`` (2 or 3), whose variables are those of a wheelset with these
    ``names`` that the ``variant`` has.

    FMI 2 has an icon alone.  The schema of the terminals, which is FMI 3's, permits only versions 3.x of
    them, and FMI Library ends with a fatal error where this version is not that of the model description.
    """
    image = (SOURCES / "icon.png").read_bytes()
    if version == 2:
        return {"model.png": image}
    root = Element("fmiTerminalsAndIcons", fmiVersion="3.0")
    corners = {"x1": "-100", "y1": "-100", "x2": "100", "y2": "100"}
    picture = SubElement(root, "GraphicalRepresentation")
    SubElement(picture, "CoordinateSystem", {**corners, "suggestedScalingFactorTo_mm": "0.1"})
    SubElement(picture, "Icon", corners)
    parent = SubElement(root, "Terminals")
    for name, (kind, meaning, members) in terminals(names).items():
        members = {
            variant.name(member) or member: own
            for member, variable in members.items()
            if (own := variant.name(variable))
        }
        if not members:
            continue
        terminal = SubElement(
            parent,
            "Terminal",
            name=name,
            matchingRule="bus",
            terminalKind=f"wrcontact.{kind}",
            description=meaning,
        )
        for member, variable in members.items():
            SubElement(
                terminal,
                "TerminalMemberVariable",
                variableName=variable,
                memberName=member,
                variableKind="signal",
            )
    return {
        "terminalsAndIcons/terminalsAndIcons.xml": xml_file(root),
        "terminalsAndIcons/icon.png": image,
        "terminalsAndIcons/icon.svg": (SOURCES / "icon.svg").read_bytes(),
    }


def terminals(names):
    """(kind, meaning, variables by their name in a connection) of each terminal, by name."""
    whole = [
        variable.name
        for variable in VARIABLES
        if variable.causality == OUTPUT and not variable.name.startswith(SIDES)
    ]
    inputs = set(INPUT_VARIABLES)
    groups = {
        "pose": (
            "pose",
            "Where the wheelset stands; compliant contact reads the height and the roll too",
            POSE,
        ),
        "load": ("load", "What the wheels carry; compliant contact does not read it", LOAD),
        "rails": ("rails", "How far the rails are from their nominal places", RAILS),
        "motion": ("motion", "How the wheelset and its rails move", MOTION),
        "friction": ("friction", "Friction between wheels and rails", FRICTION),
        "wheelset": (
            "resultant",
            "Roll and height of the wheelset, and the resultant of its contact forces",
            {name: name for name in whole},
        ),
    }
    for side in SIDES:
        of_side = [
            name.removeprefix(f"{side}.")
            for name in names
            if name.startswith(f"{side}.") and name not in inputs
        ]
        groups[side] = (
            "contact",
            f"Contact of the {side} wheel",
            {name: f"{side}.{name}" for name in of_side},
        )
    return groups
