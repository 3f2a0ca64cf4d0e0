"""What a sweep asks: the system, the axes, the fixed inputs and the outputs; and how a store keeps that.

Profiles are kept by their content, never as paths: a file that changes, or that is missing elsewhere, changes
nothing.
"""

import json
from dataclasses import dataclass, replace

import numpy as np

from ..interface.calls import given_inputs, warn_of_inputs
from ..interface.index import PROFILES
from ..interface.parameters import LEFT, PARAMETERS
from ..methods.numbers import unit_behind
from ..methods.own import functions_in
from ..profiles.catalogue import standard_name, standard_profile
from ..profiles.changing import is_sections
from ..profiles.files import prepared_profile, prepared_text
from ..profiles.profile import Profile
from ..results.columns import selected
from ..storage.hashes import content_hash
from ..system import ContactSystem
from ..version import __version__
from .grid import checked_axes, checked_inputs, row_of, words_of

#: Differences between two specifications that a sentence names.
MOST = 3


@dataclass(frozen=True)
class SweepSpecification:
    """``axes`` are arrays and ``fixed`` are numbers by keyword; ``outputs`` is the argument of
    :meth:`~wrcontact.ContactSystem.evaluate_many`, and ``names`` are those of the outputs that it means."""

    system: ContactSystem
    axes: dict
    fixed: dict
    outputs: object
    names: tuple

    @property
    def sizes(self):
        """The number of values of each axis."""
        return tuple(map(len, self.axes.values()))

    def record(self):
        """What a store keeps, apart from the values of the axes, as a dict for JSON; profiles by their
        hashes."""
        parameters = {
            **self.system.parameters,
            **{kind: profile_hash(getattr(self.system, kind)) for kind in PROFILES},
        }
        return {
            "version": __version__,
            "parameters": parameters,
            "fixed": self.fixed,
            "outputs": list(self.names),
            "axes": list(self.axes),
        }

    def profiles(self):
        """{hash: text} of the profiles; a rail that changes along the track has its hash alone."""
        found = (getattr(self.system, kind) for kind in PROFILES)
        return {profile_hash(one): prepared_text(one) for one in found if not is_sections(one)}


def asked(system, axes, outputs, fixed):
    """The checked :class:`SweepSpecification`; ValueError or TypeError, in a sentence, if it is none."""
    if not isinstance(system, ContactSystem):
        raise ValueError(f"system is {system!r}; permitted is a ContactSystem")
    for name, function in functions_in(system.parameters).items():
        raise ValueError(
            f"{name} is the function {getattr(function, '__name__', function)!r}; permitted in a sweep are models "
            "with a name, which a store and other processes know"
        )
    axes = checked_axes(axes)
    fixed = checked_inputs(fixed, axes)
    if not isinstance(outputs, str):
        outputs = tuple(outputs)
    rows = system.stepper().layout
    names = rows.names(selected("both", outputs, rows).places)
    warn_of_inputs(given_inputs((), {**axes, **fixed}), system._warned)
    return SweepSpecification(system, axes, fixed, outputs, names)


def profile_hash(profile):
    """SHA-256 of what a profile computes with, in hexadecimal digits; its name is no part of it."""
    if is_sections(profile):
        return content_hash(profile.surface.breaks.tobytes(), profile.surface.cubics.tobytes())
    return content_hash(prepared_text(replace(profile, name="")))


def system_of(record, profiles):
    """The system of a kept ``record`` and its ``profiles`` {hash: text}."""
    parameters = dict(record["parameters"])
    for kind in PROFILES:
        side, key = kind.removeprefix(LEFT), parameters[kind]
        profile = prepared_profile(profiles[key], side, Profile)
        standard = standard_name(profile.name) == profile.name and standard_profile(profile.name) == profile
        parameters[kind] = profile.name if standard else profile
        if kind != side and key == record["parameters"][side]:
            parameters[kind] = None  # as on the right
    return ContactSystem(**parameters)


# --- two specifications ------------------------------------------------------------------------------------------


def differences(specification, kept, axes):
    """How a specification differs from the ``kept`` record of another one with these ``axes`` {keyword: (n,)}, as
    clauses; of many differences the first ones."""
    own = json.loads(json.dumps(specification.record()))
    return [
        *_other_axes(specification.axes, axes, own, kept),
        *_other_inputs(own, kept, axes),
        *_other_outputs(own, kept),
        *_other_parameters(own, kept),
    ][:MOST]


def _other_axes(own, other, record, kept):
    if record["axes"] != kept["axes"]:
        yield f"the axes are {', '.join(record['axes'])}, there {', '.join(kept['axes'])}"
        return
    for keyword, values in own.items():
        if not np.array_equal(values, other[keyword]):
            there = words_of(keyword, other[keyword])
            there += " that differ" if there == words_of(keyword, values) else ""
            yield f"{keyword} has {words_of(keyword, values)}, there {there}"


def _other_inputs(own, kept, axes):
    for keyword in sorted({*own["fixed"], *kept["fixed"]}):
        row = row_of(keyword)
        values = [record["fixed"].get(keyword, row.start) for record in (own, kept)]
        if values[0] != values[1] and keyword not in {*own["axes"], *axes}:
            yield _values(keyword, values, row.unit)


def _other_outputs(own, kept):
    more, less = (
        sorted(set(a) - set(b))
        for a, b in ((own["outputs"], kept["outputs"]), (kept["outputs"], own["outputs"]))
    )
    if more:
        yield f"outputs has {more[0]!r}, which is not there"
    elif less:
        yield f"outputs lacks {less[0]!r}, which is there"


def _other_parameters(own, kept):
    for name in dict.fromkeys([*own["parameters"], *kept["parameters"]]):
        values = [record["parameters"].get(name) for record in (own, kept)]
        if values[0] == values[1]:
            continue
        if name in PROFILES:
            yield f"the {name.replace('_', ' ')} profile has another content"
        else:
            known = PARAMETERS[name].number if name in PARAMETERS else None
            yield _values(name, values, known.unit if known else "1")
    if own["version"] != kept["version"]:
        yield f"wrcontact is {own['version']}, there {kept['version']}"


def _values(name, values, unit):
    own, there = (f"{value!r}{unit_behind(unit)}" for value in values)
    return f"{name} is {own}, there {there}"
