"""Places of inputs and outputs by the names of an FMU, for arrays of a stepper."""

from functools import cache, lru_cache

from ..interface.index import PLACES, ROWS
from ..interface.variables import INTEGER
from ..methods.words import did_you_mean
from .columns import ALWAYS, DEPTH_SIZES, selected
from .layout import variable_of


@cache
def places(rows):
    """{name: place} of all inputs, and of the outputs in rows with this Layout."""
    return {name: PLACES[name] for name in ROWS} | rows.places


def place_of(name, rows):
    """The place of an input or output; ValueError if there is none."""
    try:
        return places(rows)[name]
    except (KeyError, TypeError):
        hint = did_you_mean(name, places(rows)) or "; input_names and output_names list them"
        raise ValueError(f"there is no input or output {name!r}{hint}") from None


@lru_cache
def differentiated_inputs(by):
    """Places of the inputs, a tuple of names, that derivatives are taken by."""
    found = []
    for name in by:
        if name not in ROWS:
            hint = did_you_mean(name, ROWS) or f"; inputs are {', '.join(ROWS)}"
            raise ValueError(f"by has {name!r}; permitted are names of inputs{hint}")
        if ROWS[name].switch:
            raise ValueError(f"by has {name!r}, which is true or false; derivatives are by numbers")
        found.append(PLACES[name])
    return found


@lru_cache
def differentiated_outputs(of, rows):
    """Places of the outputs, a tuple of names, whose derivatives are taken, and the least ``side`` and
    ``depth`` with which a stepper computes them; None for both where every stepper does."""
    known = rows.places
    for name in of:
        if name not in known:
            hint = did_you_mean(name, known) or "; output_names lists them"
            raise ValueError(f"of has {name!r}; permitted are names of outputs{hint}")
        if variable_of(name).type == INTEGER:
            raise ValueError(f"of has {name!r}, which is a count; derivatives are those of numbers")
    least = [name for name in of if name not in ALWAYS]
    wanted = selected("both", least, rows) if least else None
    return [known[name] for name in of], wanted and (wanted.side, wanted.depth)


def is_computed(least, wanted):
    """Whether a stepper of which (side, depth) are ``wanted`` computes what ``least`` says."""
    depths = list(DEPTH_SIZES)  # the deepest is first
    return (
        least is None or wanted[0] in ("both", least[0]) and depths.index(wanted[1]) <= depths.index(least[1])
    )


def listed(argument, names):
    """``names`` as a tuple; one name alone is refused, since its letters would be taken for names."""
    if isinstance(names, str):
        raise ValueError(f"{argument} is {names!r}; permitted is a list of names, [{names!r}]")
    return tuple(names)
