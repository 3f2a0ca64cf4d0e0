"""Models that are Python functions: the kernel's Python source calls them in place of its own models."""

import threading
from contextlib import contextmanager
from functools import cache, wraps
from importlib import import_module

from .library import Kernel

#: What this thread's kernel calls at present, by the parameter that chooses it.
_present = threading.local()


class OwnKernel(Kernel):
    """The Python source with ``functions`` {parameter: function} in place of the models that stand in for them
    (wrcontact/methods/own.py)."""

    def __init__(self, functions):
        super().__init__()
        self.functions = functions

    def bind(self, *arrays):
        """As :meth:`Kernel.bind`."""
        bound = super().bind(*arrays)
        bound.step, bound.step_many = self._inside(bound.step), self._inside(bound.step_many)
        return bound

    def solve_creep_force(self, tables, workspace):
        """As :meth:`Kernel.solve_creep_force`."""
        return self._inside(super().solve_creep_force)(tables, workspace)

    def _inside(self, call):
        def inside(*arguments):
            _open_doors()
            with _calling(self.functions):
                return call(*arguments)

        return inside


@cache
def _open_doors():
    """Let the Python source ask for functions where it calls the models that stand in for them."""
    normal = import_module("..normal.normal_contact", __package__)
    creep = import_module("..creep.creep_force", __package__)
    normal.hertz_contact = _door("normal_model", normal.hertz_contact)
    creep.solve_polach = _door("tangential_model", creep.solve_polach, _write_creep)


def _door(parameter, model, taken=lambda found, arguments: found):
    """The ``model``, or the function in its place; ``taken`` is called with its result and arguments."""

    @wraps(model)
    def called(*arguments):
        function = getattr(_present, "functions", {}).get(parameter)
        if function is None:
            return model(*arguments)
        with _calling({}):  # the function may evaluate other systems
            return taken(function(*arguments), arguments)

    return called


def _write_creep(found, arguments):
    """Write what a function returns, (x, y) or (x, y, moment), to its patch; one that returns None has
    written itself."""
    if found is None:
        return
    numbers = tuple(found)
    if len(numbers) not in (2, 3):
        raise ValueError(
            f"tangential_model returned {len(numbers)} numbers; permitted are None, (x, y) [N] and "
            "(x, y, moment) [N, N m]"
        )
    patch = arguments[1]
    patch.creep_x, patch.creep_y, patch.creep_moment = map(float, (*numbers, 0.0)[:3])


@contextmanager
def _calling(functions):
    before = getattr(_present, "functions", {})
    _present.functions = functions
    try:
        yield
    finally:
        _present.functions = before
