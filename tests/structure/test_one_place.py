"""Forces are added in one file, and outputs are written in one."""

import ast

from tests.helpers.paths import ROOT
from tests.helpers.sources import parsed
from wrcontact.kernel import layout

KERNEL = ROOT / "wrcontact" / "kernel"
FILES = [
    *(path for path in KERNEL.rglob("*.py") if "generated" not in path.parts),
    *(ROOT / "wrcontact" / "halfspace").rglob("*.py"),
]
#: Vectors and numbers of a record Forces; a patch has its normal moment before, by itself.
VECTORS, NUMBERS = (
    {"force", "moment", "normal_force"},
    {"driving_torque", "friction_power", "damping_power", "wear_number"},
)
OUTPUTS = {"Outputs", "SideOutputs", "PatchOutputs"}


def adds(tree):
    """Whether a module adds to forces, moments or powers."""
    for node in ast.walk(tree):
        if isinstance(node, ast.AugAssign) and isinstance(node.op, (ast.Add, ast.Sub)):
            names, target = NUMBERS, node.target
            if isinstance(target, ast.Subscript):
                names, target = VECTORS, target.value
            if isinstance(target, ast.Attribute) and target.attr in names:
                return True
    return False


def trees():
    return {str(path.relative_to(ROOT / "wrcontact")): parsed(path) for path in FILES}


def test_forces_are_added_in_one_file():
    """And what only changing rails have of them in another."""
    assert VECTORS | NUMBERS | {"normal_moment"} == {name for name, _ in layout.Forces._fields_}
    assert {name for name, tree in trees().items() if adds(tree)} == {
        "kernel/wheelset/forces.py",
        "kernel/changing/section_forces.py",
    }


def test_outputs_are_written_in_one_file_and_read_where_starts_are_noted():
    """Nothing else reads a record of outputs, which so is no place to work in."""
    reading = {
        name
        for name, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Attribute)
        and node.attr == "outputs"
        and ast.unparse(node.value) == "work"
        or isinstance(node, ast.arg)
        and node.annotation
        and ast.unparse(node.annotation) in OUTPUTS
    }
    assert reading == {
        "kernel/wheelset/report.py",
        "kernel/changing/section_report.py",
        "kernel/prepare/tables.py",
    }
