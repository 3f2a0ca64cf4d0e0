"""Options that are added to a command from a table."""

from functools import wraps
from inspect import Parameter, Signature, signature
from typing import Annotated

import typer


def adding(command, options, fold, made=()):
    """A command with the further ``options``, :class:`inspect.Parameter`; ``fold`` turns all values that are
    given, a dict by name, into the arguments of ``command``, of which those in ``made`` are no options."""

    @wraps(command)
    def with_options(**given):
        return command(**fold(given))

    own = [
        one.replace(kind=Parameter.KEYWORD_ONLY)
        for one in signature(command).parameters.values()
        if one.name not in made
    ]
    with_options.__signature__ = Signature([*own, *options])
    with_options.__annotations__ = {one.name: one.annotation for one in (*own, *options)}
    return with_options


def option(name, kind, default, *flags, **more):
    """The :class:`inspect.Parameter` of one option; ``flags`` and ``more`` are typer's."""
    kind = kind | None if default is None else kind
    return Parameter(
        name,
        Parameter.KEYWORD_ONLY,
        default=default,
        annotation=Annotated[kind, typer.Option(*flags, **more)],
    )
