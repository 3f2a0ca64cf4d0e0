"""A digest of all records and constants, by which a compiled library is known to have the same ones."""

import hashlib
import sys


def digest():
    """Hexadecimal digits that change with every constant and with every field's name, place and type."""
    layout = sys.modules[__package__]
    lines = []
    for name, value in sorted(vars(layout).items()):
        numbers = value if isinstance(value, tuple) else (value,)
        if name.isupper() and all(isinstance(number, (int, float)) for number in numbers):
            lines.append(f"{name} = {value!r}")
        elif hasattr(value, "_fields_") and hasattr(value, "scalars"):
            lines += [f"{name}.{field}: {kind.__name__} at {getattr(value, field).offset}"
                      for field, kind in value._fields_]
            lines += [f"{name}.{field}: {kind.__name__}" for field, kind in value.scalars.items()]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()
