"""Records: named numbers in one block of memory, for Python. (C never sees this file:
tools/lower_records.py.)

    @record
    class Region:
        spacing: float                 # a number
        first: int                     # a whole number, kept as a float
        pressed: bool                  # 1.0 or 0.0
        row: Float * 31                # numbers one after the other
        patches: Patch * 3             # records, likewise
        place: Place                   # one record inside another

A record is where its memory is: ``Region.at(array, offset)`` copies nothing, a record handed on or kept under
another name is the same memory, and what Python writes the compiled kernel reads.

Marks at functions, ``seldom``, ``inlined`` and ``native``, say what C makes of them; in Python they do
nothing.  A compiler inlines only so much of one unit.  What it spends on functions that a usual step does not
enter it takes from the usual step: 4 % when yawed.
"""

import ctypes

import numpy

Float = ctypes.c_double
#: The record classes by name.
CLASSES = {}
#: Length of a run of which only the tables themselves know the end.
OPEN = 1_000_000
WIDTH = ctypes.sizeof(Float)
READ = {int: int, bool: lambda value: value == 1.0}


class Record(ctypes.Structure):
    """Fields by name; any other name is an AttributeError, also when it is written."""

    __slots__ = ()

    @classmethod
    def at(cls, array, offset=0):
        """The record that begins at ``array[offset]``; ``array`` is memory of float64, or a record in it."""
        if isinstance(array, Record) and not array.array:
            return cls.from_address(ctypes.addressof(array) + WIDTH * offset)
        array = getattr(array, "raw", array)
        if cls.open_ended or memoryview(array).readonly:
            found = cls.from_address(numpy.asarray(array).ctypes.data + WIDTH * offset)
        else:
            found = cls.from_buffer(array, WIDTH * offset)
        if cls.array:
            # the whole of the array whose head this is; faster than numpy, plain floats
            found.raw = memoryview(array)
        return found

    def __getitem__(self, index):
        """Number ``index`` of the record, for loops over all of them."""
        return (self.raw if self.array else self.numbers())[index]

    def __setitem__(self, index, value):
        (self.raw if self.array else self.numbers())[index] = value

    def numbers(self):
        return (Float * size(self)).from_buffer(self)


def record(cls):
    """The class whose annotations are ``cls``'s, over memory."""
    kinds = cls.__annotations__
    targets = {name: kind.kind for name, kind in kinds.items() if isinstance(kind, To)}
    scalars = {name: kind for name, kind in kinds.items() if kind in (float, int, bool)}
    fields = [
        (
            "_" + name if kind in READ or name in targets else name,
            Float if name in scalars or name in targets else kind,
        )
        for name, kind in kinds.items()
    ]
    names = {name: converted("_" + name, READ[kind]) for name, kind in scalars.items() if kind in READ}
    names |= {name: pointed("_" + name, kind) for name, kind in targets.items()}
    ends = [kind for _, kind in fields[-1:]]
    made = type(
        cls.__name__,
        (Record,),
        {
            "__slots__": ("raw",) if hasattr(cls, "array") else (),
            "__doc__": cls.__doc__,
            "__module__": cls.__module__,
            "array": getattr(cls, "array", None),
            "scalars": scalars,
            "targets": targets,
            "_fields_": fields,
            **names,
            "open_ended": any(getattr(kind, "_length_", 0) >= OPEN for kind in ends),
        },
    )
    CLASSES[cls.__name__] = made
    return made


class To:
    """The type of a field that says how far from the beginning of its own record
    another, of ``kind``, begins; ``kind`` is its class, or the name of one that follows."""

    def __init__(self, kind):
        self.kind = kind


def pointed(name, kind):
    """A field that reads as the record at the offset that it holds, and is written as an offset."""

    def pointed_at(self):
        found = CLASSES[kind] if isinstance(kind, str) else kind
        return found.from_address(ctypes.addressof(self) + WIDTH * int(getattr(self, name)))

    return property(
        pointed_at,
        lambda self, value: setattr(
            self, name, float(offset(value, self) if isinstance(value, Record) else value)
        ),
    )


def run(length):
    """The type of ``length`` numbers, one after the other, as a type of its own: functions can ask for it."""
    return type("Run", (ctypes.Array,), {"_type_": Float, "_length_": length})


def centred(length, middle):
    """The type of ``length`` numbers that are counted from the one in their
    ``middle``: -1 is the one before it."""
    base = ctypes.Array
    return type(
        "Centred",
        (base,),
        {
            "_type_": Float,
            "_length_": length,
            "middle": middle,
            "__getitem__": lambda self, k: base.__getitem__(self, middle + k),
            "__setitem__": lambda self, k, value: base.__setitem__(self, middle + k, value),
        },
    )


def converted(name, read):
    """A field that reads as another type than the float that it is kept as."""
    return property(
        lambda self: read(getattr(self, name)), lambda self, value: setattr(self, name, float(value))
    )


def size(kind):
    """How many numbers a record is."""
    return ctypes.sizeof(kind) // WIDTH


def copy(record, to):
    """Write all numbers of a record to another of its size."""
    ctypes.memmove(ctypes.addressof(to), ctypes.addressof(record), ctypes.sizeof(record))


def clear(record):
    """Make all numbers of a record zero."""
    ctypes.memset(ctypes.addressof(record), 0, ctypes.sizeof(record))


def offset(part, whole):
    """Where a record begins in the array ``whole``, or in the one whose head is the record ``whole``."""
    first = ctypes.addressof(whole) if isinstance(whole, Record) else numpy.asarray(whole).ctypes.data
    return (ctypes.addressof(part) - first) // WIDTH


def seldom(function):
    """A function that a usual step does not call: it is kept out of line."""
    return function


def inlined(function):
    """A small function of the innermost loops: it is always inlined.  Without it the compiler leaves it out
    where the unit has grown enough, and a rigid step takes up to 5 % more instructions."""
    return function


def native(function):
    """A function that C has by itself (native/spans.h), with the same result."""
    return function
