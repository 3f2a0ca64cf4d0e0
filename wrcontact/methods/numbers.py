"""Numbers that a user chooses, each declared once as a field of a frozen dataclass: default, range, unit and
words.

>>> @frozen
... class Track(Checked):
...     gauge: float = number(1.435, 0.5, 2.0, "m", "Track gauge")
>>> Track(gauge=1435)
Traceback (most recent call last):
ValueError: gauge is 1435; permitted is 0.5 ... 2 m; did you mean 1435 mm, which is 1.435 m?
"""

import math
from dataclasses import dataclass, field, fields
from numbers import Real
from typing import TYPE_CHECKING

from .caller import warn_caller
from .words import did_you_mean


class UnusualValueWarning(UserWarning):
    """A value is permitted but lies outside the usual range, as after an error in typing or units.

    Attributes
    ----------
    name, value, unit : of the parameter or input.
    usual : (low, high), ends included.
    """

    def __init__(self, name, value, unit, usual):
        super().__init__(name, value, unit, usual)
        self.name, self.value, self.unit, self.usual = name, value, unit, usual

    def __str__(self):
        low, high = self.usual
        return (
            f"{self.name} is {self.value:g}{unit_behind(self.unit)}; usual is {low:g} ... {high:g}"
            f"{unit_behind(self.unit)}. It is used as it is."
        )


def warn_unusual(name, value, unit, usual):
    """Give an :class:`UnusualValueWarning` where the finite ``value`` lies outside ``usual``, which may be
    None; whether it does."""
    unusual = usual is not None and math.isfinite(value) and not usual[0] <= value <= usual[1]
    if unusual:
        warn_caller(UnusualValueWarning(name, value, unit, usual))
    return unusual


#: What is permitted for a ``ratio`` too, where a text can be said.
ALSO_RATIO = ", or a ratio such as '1:40'"
if TYPE_CHECKING:
    from typing_extensions import dataclass_transform

    @dataclass_transform(kw_only_default=True, frozen_default=True)
    def frozen(cls: type) -> type: ...
else:
    #: Every record of numbers is a dataclass of this kind.
    frozen = dataclass(frozen=True, kw_only=True, repr=False)


@dataclass(frozen=True)
class Number:
    """What is known of one number.

    Attributes
    ----------
    default : in Python; None leaves the choice to the method, which then needs a ``start`` for FMUs and
        the command line.
    low, high : permitted range, ends included.
    unit : SI, "1" without one.
    meaning : words for the user, one sentence without the full stop.
    nominal : usual magnitude; None is that of the default.
    keyword : its name among the keywords of :class:`~wrcontact.ContactSystem`, "" for the name of the field.
    whole : whether it is a whole number.
    start : default where None cannot be said.
    python_only : an FMU and the command line do not have it.
    usual : (low, high) outside which a value is permitted but rather a typing error; see
        :class:`UnusualValueWarning`.
    ratio : whether it may also be a text, "1:40" or "1/40".
    switch : whether it is True or False, a Boolean in an FMU; the kernel reads 1 or 0.
    """

    default: float | int | None
    low: float
    high: float
    unit: str
    meaning: str
    nominal: float | None = None
    keyword: str = ""
    whole: bool = False
    start: float | None = None
    python_only: bool = False
    usual: tuple | None = None
    ratio: bool = False
    switch: bool = False

    def checked(self, name, value, context=""):
        """``value`` as a float or int within the range; None where that is the default.

        Raises
        ------
        ValueError
            in a sentence with ``name``, value, permitted range and unit; ``context`` says with what that
            range holds.
        """
        if value is None and self.default is None:
            return None
        if self.switch:
            if not is_truth(value):
                raise ValueError(f"{name} is {value!r}; permitted is True or False")
            return bool(value)
        if self.ratio and isinstance(value, str):
            found = ratio_of(value)
        else:
            found = _number(value) if isinstance(value, Real) or not self.whole else math.nan
        if not self.low <= found <= self.high or (self.whole and found != int(found)):
            raise ValueError(f"{name} is {value!r}; permitted {self._permitted(context)}{self.meant(found)}")
        return int(found) if self.whole else found

    def meant(self, value, factor=1.0, unit=""):
        """What may be meant by a ``value`` out of range: it would be permitted in mm for m, or m for mm, or as
        the other side of a ratio; "" where nothing is likely.  ``factor`` is that from SI to the ``unit`` of the
        value."""
        if self.ratio:
            return (
                f"; did you mean 1:{value:g}?" if self.low <= 1.0 / (value or math.inf) <= self.high else ""
            )
        unit = unit or self.unit
        for other, scale in {"m": (("mm", 1e-3),), "mm": (("m", 1e3),)}.get(unit, ()):
            if self.low <= value * scale / factor <= self.high:
                return f"; did you mean {value:g} {other}, which is {value * scale:g} {unit}?"
        return ""

    def _permitted(self, context):
        if self.whole:
            return f"are whole numbers {self.low} ... {self.high}"
        also = ALSO_RATIO if self.ratio else ""
        return f"{context}is {self.low:g} ... {self.high:g}{unit_behind(self.unit)}{also}"


def number(default, low, high, unit, meaning, **more):
    """A field of a :class:`Checked` record that holds a :class:`Number`; ``more`` are other attributes."""
    return field(default=default, metadata={"number": Number(default, low, high, unit, meaning, **more)})


def whole(default, low, high, meaning, **more):
    """The same for a whole number."""
    return number(default, low, high, "1", meaning, whole=True, **more)


class Checked:
    """Base of the frozen records: every number is checked when a record is made."""

    context = ""

    def __post_init__(self):
        for name, known in self.numbers().items():
            object.__setattr__(self, name, known.checked(name, getattr(self, name), self.context))

    def __repr__(self):
        changed = [
            f"{one.name}={getattr(self, one.name)!r}"
            for one in fields(self)
            if getattr(self, one.name) != one.default
        ]
        return f"{type(self).__name__}({', '.join(changed)})"

    @classmethod
    def numbers(cls):
        """The :class:`Number` of every field, by its name."""
        return {one.name: one.metadata["number"] for one in fields(cls)}

    @classmethod
    def keywords(cls):
        """The name of every field by its keyword of :class:`~wrcontact.ContactSystem`."""
        return {known.keyword or name: name for name, known in cls.numbers().items()}


def check_choice(name, value, choices):
    """ValueError, in a sentence that lists them, unless ``value`` is one of ``choices``."""
    if value not in tuple(choices):  # a value need not have a hash
        permitted, verb = ", ".join(repr(choice) for choice in choices), "are" if len(choices) > 1 else "is"
        raise ValueError(f"{name} is {value!r}; permitted {verb} {permitted}{did_you_mean(value, choices)}")


def unit_behind(unit):
    """``unit`` as it follows a number in a sentence, with a space; "" for "1"."""
    return "" if unit == "1" else f" {unit}"


def ratio_of(text):
    """The number of a ``text`` such as "1:40", "1/40" or "0.025"; not a number where it is none."""
    try:
        rise, _, run = text.replace("/", ":").partition(":")
        return float(rise) / float(run or 1)
    except (ValueError, ZeroDivisionError):
        return math.nan


def is_truth(value):
    """Whether ``value`` is True or False, also numpy's."""
    return isinstance(value, bool) or getattr(getattr(value, "dtype", None), "kind", "") == "b"


def is_plain(value):
    """Whether ``value`` is neither a text nor a truth value, which float() would take for numbers."""
    return not is_truth(value) and not isinstance(value, (str, bytes))


def _number(value):
    """``value`` as a float; not a number where it is none."""
    try:
        return float(value) if is_plain(value) else math.nan
    except (TypeError, ValueError):
        return math.nan
