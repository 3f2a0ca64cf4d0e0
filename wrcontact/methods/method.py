"""What every method is: a frozen record of its numerics with a name, words, and the kernel's number."""

from typing import ClassVar

from .numbers import Checked


class Method(Checked):
    """One choice of a family.

    Attributes
    ----------
    parameter : the family it belongs to: the keyword of :class:`~wrcontact.ContactSystem` and the FMU's
        parameter.
    name : its string there.
    kernel_number : by which the kernel knows it.
    words : what it does, a clause for the user.
    python_only : whether an FMU and the command line do not have it.
    needs : what else must be chosen with it: {reason: {parameter: name}}.
    """

    parameter: ClassVar[str]
    name: ClassVar[str]
    kernel_number: ClassVar[int]
    words: ClassVar[str]
    python_only: ClassVar[bool] = False
    needs: ClassVar[dict] = {}

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
                        f"{parameter} is {chosen[parameter]!r}; "
                        f"permitted with the {self.parameter} {self.name!r}, which {reason}, is {name!r}"
                    )
