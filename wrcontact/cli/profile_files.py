"""Options such as ``--rail-mirror-y``, which say how a file of points is read."""

from typing import Annotated

import typer

from ..interface.index import KINDS
from ..profiles.files import SMOOTHING
from ..profiles.options import ENDINGS, ProfileFile, parsed
from ..profiles.options import WORDS as FILE_WORDS
from .adding import adding, option
from .errors import Refused, sentences
from .groups import FILES
from .options import number


def reads_files(command):
    """Decorator that adds these options to a command with ``--wheel`` and ``--rail``; the command receives a
    :class:`~wrcontact.ProfileFile` if one of them is given.  Where the command has ``--batch``, they may be
    those of its files."""

    def fold(given):
        if given.get("batch"):
            if given["wheel"] or given["rail"]:
                raise Refused("--wheel or --rail is given; permitted is that only without --batch")
            given["wheel"], given["rail"] = given["batch"]
        for kind in KINDS:
            chosen = {name: given.pop(f"{kind}_{name}") for name in _names(kind)}
            chosen = {name: value for name, value in chosen.items() if value is not None}
            if chosen and given[kind] is None:
                name = _file_option_name(kind, next(iter(chosen)))
                raise Refused(f"{name} is given; it is permitted only with --{kind} FILE")
            if chosen:
                with sentences():
                    given[kind] = ProfileFile(given[kind], **chosen)
        return given

    return adding(command, [_file_option(kind, name) for kind in KINDS for name in _names(kind)], fold)


def with_left_side(command):
    """Decorator that adds the profiles of the left side to a command with ``--wheel`` and ``--rail``; the
    command receives each as a pair (left, right)."""

    def fold(given):
        return given | {kind: (given.pop(f"left_{kind}"), given[kind]) for kind in KINDS}

    words = "{} profile of the left side, where it differs"
    return adding(
        command,
        [
            option(f"left_{kind}", str, None, metavar="FILE", help=words.format(kind.capitalize()))
            for kind in KINDS
        ],
        fold,
    )


def _names(kind):
    """The options of a ``kind`` of profile; a wheel has no inclination."""
    return [name for name in ENDINGS if kind == "rail" or name != "file_inclination"]


def _file_option_name(kind, name):
    return f"--{kind}-{ENDINGS[name]}"


def _file_option(kind, name):
    """The command's parameter for one option; None if it is not given."""
    words = f"{kind.capitalize()}: {FILE_WORDS[name][0].lower()}{FILE_WORDS[name][1:]}"
    flags, reading, value = _file_option_name(kind, name), {}, str
    if name.startswith("mirror"):
        flags, value = f"{flags}/--no-{flags[2:]}", bool
    elif name == "select":
        reading = {"metavar": "NUMBER|NAME", "parser": lambda text: int(text) if text.isdecimal() else text}
    else:
        reading = {
            "metavar": {"shift": "Y,Z", "y_range": "FROM,TO"}.get(name, "NUMBER"),
            "parser": _parser(name),
        }
    return option(
        f"{kind}_{name}",
        value,
        None,
        flags,
        help=words,
        show_default=False,
        hidden=True,
        rich_help_panel=FILES,
        **reading,
    )


def _parser(name):
    def parse(text):
        try:
            return parsed(name, text)
        except ValueError as wrong:
            raise typer.BadParameter(str(wrong)) from None

    return parse


def micrometres(text):
    """A smoothing in um; typer's BadParameter outside its range."""
    value, limit = number(text), SMOOTHING.high * 1e6
    if not SMOOTHING.low <= value <= limit:
        raise typer.BadParameter(f"{text!r} is out of range; permitted is {SMOOTHING.low:g} ... {limit:g} um")
    return value


Smoothing = Annotated[
    float | None,
    typer.Option(
        "--smoothing-um",
        parser=micrometres,
        metavar="NUMBER",
        hidden=True,
        rich_help_panel=FILES,
        help="Smoothing of profile files: root mean square distance between the curve and the points, in um; 0 "
        "goes through every point (default: the estimated noise of the points)",
    ),
]
