"""The lateral shifts of ``wrcontact sweep``, and its options for a table over several inputs, kept in a Zarr
store."""

from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..results.columns import DEPTH_SIZES
from ..status import Status
from ..sweeps.grid import checked_axes
from ..sweeps.run import sweep
from .adding import adding, option
from .errors import Refused, sentences
from .groups import GRID
from .typed import typed

FORM = (
    "NAME=START:STOP:COUNT, NAME=VALUE,VALUE or NAME=VALUE, in SI units, such as lateral_shift=-8e-3:8e-3:161"
)
#: Values of one axis at most.
MOST = 10_000_000
#: Rows of a table over the lateral shift at most, and of one that is printed.
MOST_ROWS, MOST_PRINTED = 1_000_000, 10_000
WIDEST = 1000.0  # lateral shift [mm]
START, STOP, STEP = -8.0, 8.0, 0.5  # [mm]
WORDS = {
    "axis": (
        list[str],
        "NAME=A:B:COUNT",
        "Input that varies, in SI units: COUNT values from A to B, lateral_shift=-8e-3:8e-3:161, or a "
        "list, yaw=0,1e-3; can be repeated",
    ),
    "store": (
        Path,
        "FOLDER",
        "Folder of the table, a Zarr store; the same command goes on where it was stopped",
    ),
    "outputs": (
        str,
        "NAME[,NAME]",
        "Outputs, roll,right.area; or geometry, patches, all (default: all); with --output too",
    ),
    "workers": (int, "NUMBER", "Threads (default: as many as there are cores)"),
    "scheduler": (str, "ADDRESS", "Dask scheduler whose workers compute, tcp://host:8786"),
}
#: How sentences of a sweep begin, and those of the command.
OPTIONS = {
    "axes has": "--axis has",
    "the axis ": "--axis ",
    "outputs has": "--outputs has",
    "scheduler is": "--scheduler is",
}


def shifts_of(start, stop, step, to_file):
    """Lateral shifts [m] from ``start`` to ``stop`` [mm], both included where ``step`` [mm] fits, and the
    step; None are the usual ones.  A file may have more of them than are printed."""
    start, stop, step = (
        usual if given is None else given for given, usual in zip((start, stop, step), (START, STOP, STEP))
    )
    if not (-WIDEST <= start <= stop <= WIDEST and 0 < step < np.inf):
        raise Refused(
            f"--from-mm {start:g}, --to-mm {stop:g}, --step-mm {step:g} do not define a sweep; "
            f"permitted are --step-mm > 0 and {-WIDEST:g} <= --from-mm <= --to-mm <= {WIDEST:g}"
        )
    count = np.floor((stop - start) / step + 1e-9) + 1 if step > 1e-300 else np.inf
    most = MOST_ROWS if to_file else MOST_PRINTED
    if count > most:
        files = "" if to_file else f", with --output FILE at most {MOST_ROWS}"
        raise Refused(f"--step-mm {step:g} gives {count:.10g} rows; permitted are at most {most}{files}")
    return np.round(start + step * np.arange(int(count)), 9) / 1e3, step


@dataclass(frozen=True)
class Grid:
    """What the options ask for: ``axes`` {keyword: array}, {} without any, and the values of the others;
    ``outputs`` as ``evaluate_many`` takes them, None if they are not given."""

    axes: dict
    store: Path | None
    outputs: object
    workers: int | None
    scheduler: str | None


def sweeps_grids(command):
    """Decorator that adds these options; the command receives ``grid``, a :class:`Grid`."""

    def fold(given):
        chosen = {name: given.pop(name) for name in WORDS}
        outputs = chosen["outputs"]
        if outputs is not None and ("," in outputs or outputs not in DEPTH_SIZES):
            chosen["outputs"] = outputs.split(",")
        return given | {"grid": _grid(**chosen)}

    options = [
        option(
            name,
            kind,
            None,
            f"--{name}",
            metavar=metavar,
            help=words,
            rich_help_panel=GRID,
            hidden=name == "workers",
        )
        for name, (kind, metavar, words) in WORDS.items()
    ]
    return adding(command, options, fold, ("grid",))


def _grid(axis, store, outputs, workers, scheduler):
    """The :class:`Grid` of the options; Refused if they do not go together."""
    others = {"--store": store, "--workers": workers, "--scheduler": scheduler}
    if not axis:
        for name, value in others.items():
            if value is not None:
                raise Refused(f"{name} is given; it is permitted only with --axis")
        return Grid({}, None, outputs, None, None)
    if store is None:
        raise Refused("--axis is given without --store, the folder of the table")
    if workers is not None and scheduler is not None:
        raise Refused("--workers and --scheduler are given; permitted is one of them")
    if workers is not None and workers < 1:
        raise Refused(f"--workers is {workers}; permitted is a whole number from 1 on")
    given = [_axis(text) for text in axis]
    for name, _ in given:
        if [other for other, _ in given].count(name) > 1:
            raise Refused(f"--axis has {name!r} twice; permitted is each input once")
    with sentences(grid_options):
        axes = checked_axes(dict(given))
    return Grid(axes, store, "all" if outputs is None else outputs, workers, scheduler)


def _axis(text):
    """Name and values (n,) of one axis; Refused if the ``text`` has another form."""
    name, _, values = text.partition("=")
    try:
        if ":" in values:
            start, stop, count = values.split(":")
            if not 2 <= int(count) <= MOST:
                raise Refused(f"--axis has {count} values in {text!r}; permitted are 2 ... {MOST}")
            return name.strip(), np.linspace(float(start), float(stop), int(count))
        return name.strip(), np.array([float(value) for value in values.split(",")])
    except ValueError:
        raise Refused(f"--axis is {text!r}; permitted is {FORM}") from None


def grid_options(sentence):
    """A sentence of the sweep with options in place of its arguments."""
    for word, said in OPTIONS.items():
        if sentence.startswith(word):
            return said + sentence.removeprefix(word)
    return typed(sentence)


def refuse_beside_axes(options):
    """Refuse the ``options`` {name: value} of a sweep in lateral shift alone, where one is given."""
    for name, value in options.items():
        if value is not None:
            raise Refused(f"{name} is given; it is permitted only without --axis")


def write_grid(grid, system, load):
    """Compute what is missing of a table with the inputs ``load`` fixed, and print how many states it has."""
    from ..workers import dask_client  # slow to import

    with _stopped(grid.store), sentences(grid_options), dask_client(grid.scheduler) as client:
        try:
            table = sweep(
                system, grid.axes, grid.outputs, grid.store, client=client, workers=grid.workers, **load
            )
        except RuntimeError as failed:
            raise Refused(f"{failed}; what is done is in {grid.store}", code=1) from None
    counts = np.zeros(len(Status), dtype=int)
    for part in table["status"]:
        counts += np.bincount(part.values.ravel(), minlength=len(Status))
    said = ", ".join(
        f"{count} {kind.name.lower().replace('_', ' ')}" for kind, count in zip(Status, counts) if count
    )
    if not counts[: Status.UNLOADED + 1].sum():
        raise Refused(f"no state in {grid.store} has a contact: {said}")
    print(f"{counts.sum()} states in {grid.store}: {said}")


@contextmanager
def _stopped(store):
    """Inside this context, an end by a signal says how to go on."""
    try:
        yield
    except KeyboardInterrupt:
        raise Refused(f"interrupted; {_going_on(store)}", code=130) from None
    except Refused as end:
        if end.code <= 128:
            raise
        raise Refused(f"terminated; {_going_on(store)}", code=end.code) from None


def _going_on(store):
    return f"the finished blocks are in {store}, and the same command goes on from there"
