"""A row of inputs becomes one of outputs: inputs as before are not evaluated again."""

from ..elementary.runs import copy_run
from ..layout import INPUT_COUNT, UNLOADED, Tables, Work, offset
from ..patch.outline import row_size


def open_row(workspace: Work, inputs: "float[:]", row: int) -> bool:
    """Take row ``row`` of ``inputs``; whether it has to be evaluated."""
    changed = not workspace.known
    for i in range(INPUT_COUNT):
        if not workspace.inputs[i] == inputs[INPUT_COUNT * row + i]:
            changed = True
        workspace.inputs[i] = inputs[INPUT_COUNT * row + i]
    if changed:
        workspace.known = False
    return changed


def keep_row(tables: Tables, workspace: Work, outputs: "float[:]", row: int, status: int):
    """Write row ``row`` of ``outputs``, unless the ``status`` is one without a result."""
    if status <= UNLOADED:
        workspace.known = True
        workspace.status = status
        size = row_size(tables)
        copy_run(workspace.raw, offset(workspace.outputs, workspace), outputs, size * row, size)
