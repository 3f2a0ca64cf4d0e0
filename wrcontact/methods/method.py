"""What every method is: a frozen record of its numerics with a name, words, and the kernel's number; and the
families, in which methods register themselves when their classes are made."""

from typing import ClassVar

from .numbers import Checked, check_choice


class Family:
    """The methods for one parameter, of which the first is the default; ``base`` is the class of all of them.

    ``decides`` says what for, in words for the user.  The kernel's constants for their numbers begin with
    ``constant``: MODE_RIGID.
    """

    def __init__(self, base):
        self.parameter, self.constant, self.decides = base.parameter, base.constant, base.decides
        self.methods = ()

    def add(self, method):
        """Register a method.  Its name is its own, and so is its number; one that an FMU does not have may
        have the number of an earlier method, which the kernel then solves for it."""
        missing = [name for name in ("kernel_number", "words") if not hasattr(method, name)]
        if missing:
            raise TypeError(f"{method.__name__} has no {' and no '.join(missing)}; a method has both")
        numbers = {one.kernel_number for one in self.methods}
        if method.name in self.names() or not method.python_only and method.kernel_number in numbers:
            raise TypeError(
                f"two methods of {self.parameter} have the name {method.name!r} "
                f"or the number {method.kernel_number}"
            )
        self.methods += (method,)

    @property
    def default(self):
        """The name of the first method."""
        return self.methods[0].name

    def names(self, python=True):
        """The strings that can be chosen, those of an FMU and the command line without ``python``."""
        return tuple(method.name for method in self.methods if python or not method.python_only)

    def method(self, name):
        """The class of the method with this name; ValueError, in a sentence, where there is none."""
        check_choice(self.parameter, name, self.names())
        return next(method for method in self.methods if method.name == name)

    def with_keyword(self, keyword):
        """Names of the methods that have this number."""
        return [method.name for method in self.methods if keyword in method.keywords()]


class Method(Checked):
    """One choice of a family.

    A direct subclass is a family: it has ``parameter``, ``constant`` and ``decides`` (see :class:`Family`).
    A class below it that has a ``name`` is a method, and is registered in ``family``; its fields are its
    numbers, each with default, range, unit and words (numbers.py).  docs/guides/own_model.md shows how to
    add one.

    Attributes
    ----------
    parameter : the family it belongs to: the keyword of :class:`~wrcontact.ContactSystem` and the FMU's
        parameter.
    name : its string there.
    kernel_number : by which the kernel knows it.  It is in FMUs and saved states: it never moves, and a new
        method gets the next one.
    words : what it does, a clause for the user: in the FMU, the command's help and
    docs/reference/nomenclature.md.
    python_only : whether an FMU and the command line do not have it.
    needs : what else must be chosen with it: {reason: {parameter: name}}.
    """

    parameter: ClassVar[str]
    constant: ClassVar[str]
    decides: ClassVar[str]
    family: ClassVar[Family]
    name: ClassVar[str]
    kernel_number: ClassVar[int]
    words: ClassVar[str]
    python_only: ClassVar[bool] = False
    needs: ClassVar[dict] = {}

    def __init_subclass__(cls):
        if Method in cls.__bases__:
            cls.family = Family(cls)
        elif "name" in vars(cls):
            cls.family.add(cls)

    @property
    def context(self):
        """How sentences about its numbers name it."""
        return f"with the {self.parameter} {self.name!r} "

    def check_beside(self, chosen):
        """ValueError, in a sentence, where ``chosen``, the names of all methods by parameter, does not go
        with this one."""
        for reason, needed in self.needs.items():
            for parameter, name in needed.items():
                if chosen[parameter] != name:
                    raise ValueError(
                        f"{parameter} is {chosen[parameter]!r}; permitted with the "
                        f"{self.parameter} {self.name!r}, which {reason}, is {name!r}"
                    )
