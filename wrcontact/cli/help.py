"""Help texts: options in groups, the usual ones with ``--help`` and all of them with ``--help-all``."""

import re
from inspect import cleandoc
from textwrap import wrap

import typer
from typer.core import TyperCommand

from .adding import adding, option
from .groups import ORDER

#: Width of the column of names; a longer name has a line of its own.
NAMES = 28
#: Group of options and of commands without one.
OWN, COMMANDS = "Options", "Commands"
EXAMPLE = re.compile(r"Examples?:\s+(.+)", re.DOTALL)


class Command(TyperCommand):
    """A command with this help."""

    def format_help(self, context, formatter):
        write_help(self, context, formatter)


def write_help(command, context, formatter):
    """Write usage, words, example, and groups of options and commands to click's ``formatter``."""
    command.format_usage(context, formatter)
    text, lines = cleandoc(command.help or ""), []
    example = EXAMPLE.search(text)
    for paragraph in EXAMPLE.sub("", text).strip().split("\n\n"):
        lines += ["", *_wrapped(paragraph, formatter.width)]
    if example:
        lines += ["", "Example:", f"  {' '.join(example[1].split())}"]
    for title, rows in [*_options(command, context), *_commands(command)]:
        lines += ["", f"{title}:", *_columns(rows, formatter.width)]
    formatter.write("\n".join(lines) + "\n")


def _wrapped(words, width):
    """Lines of at most ``width`` letters; names of options are not divided."""
    return wrap(" ".join(words.split()), width, break_on_hyphens=False, break_long_words=False)


def _columns(rows, width):
    """Lines with the names and words of ``rows``; a name of more than NAMES letters has a line of its own."""
    first = max((len(name) for name, _ in rows if len(name) <= NAMES), default=NAMES) + 4
    for name, words in rows:
        lines = _wrapped(words, width - first) or [""]
        if len(name) > NAMES:
            yield f"  {name}"
        else:
            yield f"  {name:{first - 2}}{lines.pop(0)}".rstrip()
        yield from (" " * first + line for line in lines)


def _options(command, context):
    """Title and rows (name, words) of every group of options that is shown."""
    found = {title: [] for title in (OWN, *ORDER)}
    for one in command.get_params(context):
        if not getattr(one, "hidden", False) and one.param_type_name == "option":
            found[getattr(one, "rich_help_panel", None) or OWN].append(_row(one))
    return [(title, rows) for title, rows in found.items() if rows]


def _row(one):
    """An option with what it takes, and its words."""
    flag = getattr(one, "is_flag", False) or not one.metavar
    names = " / ".join((*one.opts, *one.secondary_opts)) + ("" if flag else f" {one.metavar}")
    start = "" if flag or one.default in (None, "") else f" (default: {one.default})"
    return names, " ".join((one.help or "").split()) + start


def _commands(command):
    """Title and rows of every group of commands."""
    found = {}
    for name, one in getattr(command, "commands", {}).items():
        found.setdefault(one.rich_help_panel or COMMANDS, []).append((name, one.get_short_help_str(200)))
    return sorted(found.items())


# --- all options --------------------------------------------------------------------------------------------


def _show_all(context, wanted):
    """Print the help with every option, and end."""
    if wanted and not context.resilient_parsing:
        for one in context.command.params:
            one.hidden = False
        print(context.get_help())
        raise typer.Exit


def with_all(command):
    """Decorator that adds ``--help-all`` to a command with options that --help does not show."""

    more = {"is_eager": True, "callback": _show_all, "help": "Show all options and exit"}
    shown = option("help_all", bool, False, "--help-all", **more)
    return adding(command, [shown], lambda given: {name: given[name] for name in given if name != "help_all"})
