"""Checks of arguments that are one of several names."""


def check_choice(name, value, choices):
    """ValueError, in a sentence that lists them, unless ``value`` is one of ``choices``."""
    if value not in tuple(choices):  # a value need not have a hash
        permitted = ", ".join(repr(choice) for choice in choices)
        raise ValueError(f"{name} is {value!r}; permitted are {permitted}" if len(choices) > 1 else
                         f"{name} is {value!r}; permitted is {permitted}")
