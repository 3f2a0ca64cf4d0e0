"""Everything that is fixed during a simulation: one row for each keyword of
:class:`~wrcontact.ContactSystem`.

The numbers of track, wheelset and material are declared here, those of friction in friction.py, those of a
method in its file (wrcontact/methods).  Keywords, defaults, ranges, the parameters of an FMU and the options
of the command line follow from :data:`PARAMETERS`.
"""

from dataclasses import dataclass, replace

from ..methods import FAMILIES
from ..methods.numbers import Checked, Number, check_choice, frozen, number, unit_behind, warn_unusual
from ..methods.own import STAND_INS, functions_in
from .friction import Friction
from .outputs import STATION_COUNT, STATION_LEAST, STATION_LIMIT
from .section_places import SECTION_PLACES


@frozen
class Track(Checked):
    """Rails: ``gauge`` [m], measured ``gauge_depth`` [m] below the highest point of the inclined head;
    ``rail_inclination`` [1]."""

    rail_inclination: float = number(
        1 / 40,
        0.0,
        0.1,
        "1",
        "Inclination of the rails towards the track centre as a slope; 0.025 is 1:40",
        ratio=True,
    )
    gauge: float = number(
        1.435, 0.5, 2.0, "m", "Track gauge between the gauge faces of the rails", nominal=1.0
    )
    gauge_depth: float = number(
        0.014,
        0.005,
        0.035,
        "m",
        "Depth below the highest point of the inclined rail head at which the gauge is measured",
        nominal=0.01,
    )


@frozen
class Wheelset(Checked):
    """Wheels: ``running_circle_distance`` [m] of the two running circles, ``nominal_radius`` [m] there."""

    running_circle_distance: float = number(
        1.5, 0.5, 2.5, "m", "Distance between the running circles of the two wheels", nominal=1.0
    )
    nominal_radius: float = number(
        0.46, 0.1, 1.0, "m", "Wheel radius at the running circle", nominal=0.5, usual=(0.125, 0.7)
    )


@frozen
class Material(Checked):
    """Wheel and rail, which are of one material: ``youngs_modulus`` [Pa], ``poisson_ratio`` [1]."""

    youngs_modulus: float = number(
        210e9, 1e6, 1e13, "Pa", "Young's modulus of wheel and rail", nominal=1e11, usual=(1e9, 1e12)
    )
    poisson_ratio: float = number(0.28, 0.0, 0.499, "1", "Poisson's ratio of wheel and rail", nominal=0.3)


#: Records that may be given instead of the keywords that they hold.
GROUPS = {"track": Track, "wheelset": Wheelset, "material": Material, "friction": Friction}

#: Keywords that say where the profiles can touch.
GEOMETRY = (*Track.keywords(), *Wheelset.keywords())

#: Keywords whose value may differ on the left side, where a keyword of its own, with this before its name,
#: says so; without a value it is as on the right.
LEFT = "left_"
#: Springs below a rail, and the dampers beside them.
RAIL_SPRINGS = (
    "rail_lateral_stiffness",
    "rail_vertical_stiffness",
    "rail_lateral_damping",
    "rail_vertical_damping",
)
#: What stands for none of them on both sides.
RIGID_RAILS = {side + name: 0.0 for side in ("", LEFT) for name in RAIL_SPRINGS}
#: Methods beside which rails may stand on springs.
WITH_SPRINGS = {
    "contact_mode": ("compliant",),
    "normal_model": ("hertz", "analyn", "analyn_strip", "auto"),
    "tangential_model": ("none", "strips", "fastsim", "fastrip", "polach"),
}
SIDED = ("wheel", "rail", "nominal_radius", "rail_inclination", *RAIL_SPRINGS)
#: With those that FMUs do not have.
BOTH_SIDED = (*SIDED, *SECTION_PLACES)


#: What 0 means on the right side.
RIGID = "; 0: rigid"


def _spring(words):
    """The row of a spring below the rails."""
    return Number(0.0, 0.0, 1e12, "N/m", f"{words}, read with contact_mode compliant{RIGID}", nominal=1e7)


def _damper(direction):
    """The row of a damper beside a spring."""
    return Number(
        0.0,
        0.0,
        1e9,
        "N.s/m",
        f"Damping beside the {direction} spring of each rail, over the rail_time_step",
        nominal=1e4,
    )


#: Numbers that belong to none of the records.
OTHERS = {
    "contact_damping": Number(
        0.0,
        0.0,
        100.0,
        "s/m",
        "Contact damping with contact_mode compliant: forces are multiplied by 1 + damping times the speed of "
        "the approach, and are never below zero",
        nominal=0.1,
    ),
    "rail_lateral_stiffness": _spring("Stiffness of the spring that holds each rail laterally"),
    "rail_vertical_stiffness": _spring("Stiffness of the spring that holds each rail vertically"),
    "rail_lateral_damping": _damper("lateral"),
    "rail_vertical_damping": _damper("vertical"),
    "independent_wheels": Number(
        False,
        0,
        1,
        "1",
        "Whether each wheel turns by itself, with left.wheel_rate and right.wheel_rate instead of wheel_rate",
        switch=True,
    ),
    "nominal_rolling": Number(
        False,
        0,
        1,
        "1",
        "Whether a wheel_rate of 0 with free_rolling means speed / nominal_radius, a rotation that brakes or "
        "drives, instead of the one without torque",
        switch=True,
    ),
    "wear_outputs": Number(
        False,
        0,
        1,
        "1",
        "Whether the outputs of wear are computed: the place on both profiles, the friction power and the "
        "patch at each station of an outline, and in Python the strips of each patch",
        switch=True,
    ),
    "fatigue_outputs": Number(
        False,
        0,
        1,
        "1",
        "Whether the outputs of fatigue are computed: T gamma, its damage, the shakedown ratio and the surface "
        "fatigue index of each patch",
        switch=True,
    ),
    "yield_shear": Number(
        300e6,
        1e7,
        1e10,
        "Pa",
        "Yield stress in cyclic shear of wheel or rail, read with fatigue_outputs; give that of your steel",
    ),
    "error_outputs": Number(
        False,
        0,
        1,
        "1",
        "Whether the normal_model analyn estimates its error in the peak pressure; auto always does, others "
        "have no estimate",
        switch=True,
    ),
    "stations": Number(
        STATION_COUNT,
        STATION_LEAST,
        STATION_LIMIT,
        "1",
        "Stations of a patch's outline",
        whole=True,
        python_only=True,
    ),
    "smoothing": Number(
        None,
        0.0,
        0.5e-3,
        "m",
        "Permitted RMS distance between the curve and the points of a profile file",
        python_only=True,
    ),
}


@dataclass(frozen=True)
class Parameter:
    """One keyword of :class:`~wrcontact.ContactSystem`.

    Attributes
    ----------
    name : the keyword.
    meaning : words for the user.
    default : in Python; ``start`` where None cannot be given (FMUs, command line).
    number : its :class:`~wrcontact.methods.numbers.Number`; None for profiles and methods.
    family : its :class:`~wrcontact.methods.method.Family`; None but for methods.
    fmu_name : its name in an FMU, "" where an FMU does not have it.
    right : the keyword of the right side, of which it is the value on the left; "" for all others.  Its
        default, None, is the value on the right; an FMU has "" or 0 for that.
    """

    name: str
    meaning: str
    default: object
    number: Number | None = None
    family: object = None
    fmu_name: str = ""
    right: str = ""

    @property
    def start(self):
        """The default of an FMU and the command line."""
        if self.right and self.number is None:
            return ""
        return self.default if self.default is not None else self.number.start

    def checked(self, value):
        """``value`` in its type and range; ValueError, in a sentence, where it is not permitted."""
        if self.right and self.number is not None and value is not None:
            return PARAMETERS[self.right].number.checked(self.name, value)
        if self.number is not None:
            return self.number.checked(self.name, value)
        if self.family is not None:
            check_choice(self.name, value, self.family.names())
        return value


def _profile(kind, default):
    return Parameter(
        kind,
        f"{kind.capitalize()} profile: a built-in name, or the name of a file that is packed in the FMU",
        default,
        fmu_name=f"{kind}_profile",
    )


def _numeric(name, known):
    return Parameter(name, known.meaning, known.default, known, fmu_name="" if known.python_only else name)


def _left(row):
    """The row of the left side beside one of the right."""
    known = row.number
    if known is None:
        meaning = f"Left side: {row.meaning[0].lower()}{row.meaning[1:]}; empty: as on the right"
    elif known.python_only:
        return Parameter(LEFT + row.name, row.meaning, None, replace(known, default=None), right=row.name)
    else:
        known = replace(known, default=None, low=0.0, start=0.0, nominal=known.nominal or known.default)
        meaning = known.meaning.removesuffix(RIGID)
        meaning = f"Left side: {meaning[0].lower()}{meaning[1:]}; 0: as on the right"
    return Parameter(LEFT + row.name, meaning, None, known, fmu_name=LEFT + row.fmu_name, right=row.name)


def _method(family):
    words = ", ".join(
        f"{method.name} = {method.words}" for method in family.methods if not method.python_only
    )
    return Parameter(
        family.parameter,
        f"Method, {family.decides}: {words}",
        family.default,
        family=family,
        fmu_name=family.parameter,
    )


def _numbers_of(family):
    """The numbers of a family's methods by keyword; one that several methods have gets the range that
    contains all of theirs."""
    found = {}
    for method in family.methods:
        for keyword, name in method.keywords().items():
            own = method.numbers()[name]
            known = found.setdefault(keyword, own)
            found[keyword] = replace(known, low=min(known.low, own.low), high=max(known.high, own.high))
            if replace(own, low=0, high=0) != replace(known, low=0, high=0):
                raise TypeError(
                    f"{keyword} of the {family.parameter} {method.name!r} differs from that of another one"
                )
    return found


def _rows():
    """All rows but those of the left side."""
    yield _profile("wheel", "S1002")
    yield _profile("rail", "UIC60")
    for group in GROUPS.values():
        for name, known in group.numbers().items():
            yield _numeric(name, known)
    for family in FAMILIES:
        yield _method(family)
        for keyword, known in _numbers_of(family).items():
            yield _numeric(keyword, known)
    for name, known in (OTHERS | SECTION_PLACES).items():
        yield _numeric(name, known)


#: Every row by its name, in the order of the keywords.
PARAMETERS = {row.name: row for row in _rows()}
PARAMETERS |= {LEFT + name: _left(PARAMETERS[name]) for name in PARAMETERS if name in BOTH_SIDED}


#: Names of those that always have a number or a method, and so have a place in the kernel's record
#: Parameters.
KERNEL_PARAMETERS = tuple(
    row.name
    for row in PARAMETERS.values()
    if not row.right
    and row.name not in SECTION_PLACES
    and (row.family or (row.number is not None and row.start is not None))
)


def checked_parameters(given, groups):
    """What a system is built from: (parameters, methods).

    Parameters
    ----------
    given : values by keyword, where other than the default; a method may be its string or its object.
    groups : a :class:`Track`, :class:`Wheelset`, :class:`Material`, :class:`Friction` or None by the name in
        :data:`GROUPS`.

    Returns
    -------
    parameters : the checked value of every keyword; methods are strings, or the user's functions.
    methods : the object of every method, by its parameter; of a function that of the method in whose place
        the kernel calls it.

    Raises
    ------
    ValueError
        in one sentence with name, value, unit and permitted range or choices.
    """
    given = _split(given)
    functions = functions_in(given)
    given |= {name: STAND_INS[name] for name in functions}
    for name, group in groups.items():
        if group is not None:
            if not isinstance(group, GROUPS[name]):
                hint = (
                    "; its coefficient is left_friction and right_friction of evaluate"
                    if name == "friction"
                    else ""
                )
                raise ValueError(f"{name} is {group!r}; permitted is a {GROUPS[name].__name__}{hint}")
            _take(group, given, name)
    for family in FAMILIES:
        method = given.get(family.parameter)
        if isinstance(method, family.methods):
            given[family.parameter] = method.name
            _take(method, given, family.parameter)
    parameters = {name: row.checked(given.get(name, row.default)) for name, row in PARAMETERS.items()}
    _check_springs(parameters)
    methods = {family.parameter: _method_of(family, parameters) for family in FAMILIES}
    return parameters | functions, methods


def _check_springs(parameters):
    """ValueError, in a sentence, where rails cannot stand on their springs, or have dampers without them."""
    for name in RIGID_RAILS:
        if parameters[name]:
            shown = f"{name} is {parameters[name]!r}{unit_behind(PARAMETERS[name].number.unit)}"
            for method, permitted in WITH_SPRINGS.items():
                if parameters[method] not in permitted:
                    raise ValueError(
                        f"{shown}; permitted with the {method} {parameters[method]!r} is 0: "
                        f"rails stand on springs with the {method} "
                        f"{' or '.join(map(repr, permitted))}"
                    )
            stiffness = name.replace("damping", "stiffness")
            own = on_the_left(parameters) if name.startswith(LEFT) else parameters
            if not own[stiffness.removeprefix(LEFT)]:
                raise ValueError(f"{shown} without {stiffness}; permitted is 0, or a stiffness beside it")


def _split(given):
    """The keywords ``given``, a pair (left, right) as two; ValueError where the left one is there besides."""
    found = dict(given)
    for name in BOTH_SIDED:
        value = found.get(name)
        if isinstance(value, (tuple, list)):
            if len(value) != 2:
                raise ValueError(f"{name} is {value!r}; permitted is one value, or (left, right)")
            if None in (value[0], value[1]):
                raise ValueError(
                    f"{name} is {value!r}, which says nothing of one side; permitted is a value for each side, or "
                    "one value for both"
                )
            if found.get(LEFT + name) is not None:
                raise ValueError(
                    f"{LEFT}{name} is {found[LEFT + name]!r}, but {name} is {value!r}; "
                    "permitted is one of the two"
                )
            found[LEFT + name], found[name] = value
    return found


def on_the_left(parameters):
    """``parameters`` as the left side has them: of each keyword in :data:`BOTH_SIDED` the value on the left."""
    own = {name: parameters[LEFT + name] for name in BOTH_SIDED}
    return parameters | {name: value for name, value in own.items() if value is not None}


def warn_of_parameters(parameters):
    """Give an UnusualValueWarning for every number of ``parameters`` outside its usual range."""
    for name, value in parameters.items():
        known = PARAMETERS[name].number
        if known is not None and value is not None:
            warn_unusual(name, value, known.unit, known.usual)


def _take(record, given, argument):
    """Write the numbers of a group or method into the keywords ``given``; ValueError where one is there with
    another value."""
    for keyword, name in record.keywords().items():
        own, other = getattr(record, name), given.get(keyword)
        if other is not None and PARAMETERS[keyword].checked(other) != own:
            unit = unit_behind(PARAMETERS[keyword].number.unit)
            raise ValueError(
                f"{keyword} is {other!r}{unit}, but {own!r}{unit} in {argument}={record!r}; "
                "permitted is one value"
            )
        given[keyword] = own


def _method_of(family, parameters):
    """The chosen method of one family with its numbers."""
    method = family.method(parameters[family.parameter])
    for keyword in _numbers_of(family):
        value = parameters[keyword]
        if value is not None and PARAMETERS[keyword].default is None and keyword not in method.keywords():
            users = " or ".join(repr(name) for name in family.with_keyword(keyword))
            raise ValueError(
                f"{keyword} is {value!r}; it cannot be given with the {family.parameter} {method.name!r}, only "
                f"{users} has it"
            )
    method().check_beside(parameters)
    return method(**{name: parameters[keyword] for keyword, name in method.keywords().items()})
