"""The check of a fleet: pairs that are done are kept, the others are handed out."""

from dataclasses import replace

from ..interface.calls import check_count
from ..interface.index import KINDS
from ..methods.numbers import check_choice
from ..profiles import Profile
from ..progress import working
from ..system import ContactSystem
from ..version import __version__
from ..workers import results
from .files import mark, named_sources, path_of, read
from .folder import Folder
from .pair import PICTURES, examine
from .table import Fleet, empty_row
from .workers import Here, workers


def check_fleet(
    wheels,
    rails,
    output=None,
    *,
    pictures="remarks",
    processes=None,
    scheduler=None,
    smoothing=None,
    **parameters,
):
    """Check every wheel on every rail, as :func:`wrcontact.check` does one pair.

    Each file is read and smoothed once.  A file that cannot be used is a row with its sentence.  In a folder
    that has pairs of an earlier run, those that would be the same are kept.

    Parameters
    ----------
    wheels, rails : a folder, a pattern such as ``"worn/*.whl"``, the path of a file, the name of a built-in
        profile, a :class:`~wrcontact.ProfileFile` with a path, folder or pattern, a
        :class:`~wrcontact.Profile`, or a list of these.
    output : folder for the report ``report.html``, the table ``fleet.csv``, and the JSON of each pair, with
        its picture; None writes nothing.
    pictures : "remarks", of the pairs with remarks; "all"; "none".
    processes : how many share the work; None is one for each core, and one for a few pairs.  A script makes
        such a call below ``if __name__ == "__main__":``.
    scheduler : address of a dask scheduler, or a dask client, whose workers do the work instead.
    smoothing : of the files [m], as for :class:`~wrcontact.ContactSystem`.
    parameters : its other keywords: gauge, rail_inclination, nominal_radius, ...

    Returns
    -------
    Fleet

    Raises
    ------
    ValueError
        if an argument is not permitted, in one sentence.
    RuntimeError
        if a process ends early; what is done is kept.
    """
    check_choice("pictures", pictures, PICTURES)
    if processes is not None:
        check_count("processes", processes)
    for name in {"wheel", "rail", "left_wheel", "left_rail"} & parameters.keys():
        raise ValueError(f"{name} is {parameters[name]!r}; permitted are wheels and rails, for both sides")
    track = ContactSystem(**parameters)  # a wrong one is refused before files are read
    track = track.parameters["rail_inclination"]
    sources = {kind: named_sources(given, kind) for kind, given in zip(KINDS, (wheels, rails))}
    folder = None if output is None else Folder(output)
    settings = parameters, folder is not None, pictures if folder else "none"
    with workers(processes, scheduler, len(sources["wheel"]) * len(sources["rail"])) as pool:
        # the files need be on this machine only
        profiles, broken = _profiles(pool if scheduler is None else (Here(), 1), sources, smoothing, track)
        pairs = {
            (wheel, rail): mark(__version__, profiles["wheel"][wheel], profiles["rail"][rail], parameters)
            for wheel in profiles["wheel"]
            for rail in profiles["rail"]
        }
        rows = dict(_rows(pool, folder, profiles, pairs, settings))
    for (wheel, rail), row in rows.items():
        row |= {
            "wheel": wheel,
            "rail": rail,
            "wheel_file": path_of(sources["wheel"][wheel]),
            "rail_file": path_of(sources["rail"][rail]),
        }
    fleet = Fleet((*(rows[pair] for pair in pairs), *broken))
    return replace(fleet, report=folder.finish(pairs.values(), fleet)) if folder else fleet


def _profiles(pool, sources, smoothing, track):
    """{name: profile} by kind, and a row for each file that cannot be used."""
    tasks = {
        (kind, name): (source, kind, smoothing, track)
        for kind in KINDS
        for name, source in sources[kind].items()
    }
    with working("reading profiles", len(tasks)) as advance:
        found = {}
        for key, result in results(*pool, read, tasks):
            found[key] = result
            advance()
    profiles = {
        kind: {name: found[kind, name] for name in sources[kind] if isinstance(found[kind, name], Profile)}
        for kind in KINDS
    }
    broken = [
        empty_row(**{kind: name, f"{kind}_file": path_of(source)}, error=found[kind, name])
        for (kind, name), (source, *_) in tasks.items()
        if name not in profiles[kind]
    ]
    return profiles, broken


def _rows(pool, folder, profiles, pairs, settings):
    """(pair, row) of every pair: those that the folder has first, then the others as they are done."""
    tasks = {}
    for (wheel, rail), own in pairs.items():
        row = folder and folder.kept(own, settings[-1])
        if row:
            yield (wheel, rail), row
        else:
            tasks[wheel, rail] = profiles["wheel"][wheel], profiles["rail"][rail], *settings
    with working("checking pairs", len(tasks)) as advance:
        for pair, (row, *files) in results(*pool, examine, tasks):
            row |= dict(zip(KINDS, pair))
            yield pair, folder.add(pairs[pair], row, *files) if folder else row
            advance()
