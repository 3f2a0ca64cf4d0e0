"""Models that a user gives as Python functions (docs/guides/own_model.md)."""

#: Parameters that may be a function, and the method of the kernel in whose place it is called.
STAND_INS = {"normal_model": "hertz", "tangential_model": "polach"}


def functions_in(given):
    """The functions among the values ``given`` by keyword: {parameter: function}; classes are none.

    Raises
    ------
    ValueError
        where the other model is the half-space's, which works outside the kernel.
    """
    found = {name: given[name] for name in STAND_INS if is_function(given.get(name))}
    for name in found:
        for other in STAND_INS.keys() - found.keys():
            if getattr(given.get(other), "name", given.get(other)) == "halfspace":
                raise ValueError(
                    f"{other} is 'halfspace', but {name} is a function, which the kernel calls; permitted are "
                    "other models"
                )
    return found


def is_function(value):
    """Whether ``value`` is a model as a function."""
    return callable(value) and not isinstance(value, type)
