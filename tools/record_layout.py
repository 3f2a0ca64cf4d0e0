"""Where the fields of each record are, and in which array each record lives: from the classes of the
room layout.
"""

import re
from ctypes import Array, sizeof


class Refused(Exception):
    """The module cannot be lowered; the message says where and why."""


def constant(name):
    """REGION_LOAD of RegionLoad."""
    return re.sub(r"(?<=[a-z])(?=[A-Z])", "_", name).upper()


class Layout:
    """The record classes of the room layout, which is imported."""

    def __init__(self, module):
        named = {name: kind for name, kind in vars(module).items() if is_record(kind) or is_run(kind)}
        self.classes = {name: kind for name, kind in named.items() if getattr(kind, "_fields_", True)}
        # where each class is in the arrays; values of the constants
        self.places, self.values = {}, {}
        for name, kind in self.classes.items():
            if not is_record(kind):
                continue
            self.values[f"{constant(name)}_SIZE"] = sizeof(kind) // 8
            kind.targets.update(
                {field: named[target] for field, target in kind.targets.items() if isinstance(target, str)}
            )
            for field, _ in kind._fields_:
                self.values[self.offset(kind, field)] = getattr(kind, field).offset // 8
        for name, value in self.values.items():
            if getattr(module, name, value) != value:
                raise Refused(f"layout: {name} is {getattr(module, name)}, and {value} in a record")
        for kind in self.classes.values():
            if getattr(kind, "array", None):
                self.walk(kind, kind.array, [], True)

    def walk(self, kind, array, terms, single):
        self.places.setdefault(kind, []).append((array, terms if single else None))
        if is_run(kind):
            if is_record(kind._type_) or is_run(kind._type_):
                self.walk(kind._type_, array, terms, False)
            return
        for field, inner in kind._fields_:
            if is_record(inner) or is_run(inner):
                self.walk(inner, array, [*terms, self.offset(kind, field)], single)
        for target in kind.targets.values():
            if not is_root(target):
                self.walk(target, array, [], False)

    @staticmethod
    def offset(kind, field):
        return f"{constant(kind.__name__)}_{field.lstrip('_').upper()}"

    def home(self, kind):
        """The array that records of a class live in, and their offset's terms where there is
        only one of them, else None."""
        arrays = {array for array, _ in self.places.get(kind, ())}
        if not arrays:
            raise Refused(f"{kind.__name__} is in none of the arrays")
        if len(arrays) > 1:
            raise Refused(f"{kind.__name__} is in {', '.join(sorted(arrays))}")
        return arrays.pop(), self.places[kind][0][1] if len(self.places[kind]) == 1 else None


def is_record(kind):
    """Whether a type is a class of records."""
    return isinstance(kind, type) and hasattr(kind, "_fields_")


def is_run(kind):
    """Whether a type is a run of numbers or records, one after the other."""
    return isinstance(kind, type) and issubclass(kind, Array) and hasattr(kind, "_length_")


def is_root(kind):
    """Whether a type is the class of records at the head of an array."""
    return getattr(kind, "array", None) is not None
