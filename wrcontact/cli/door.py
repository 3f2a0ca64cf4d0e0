"""Errors of the command line: always one sentence on the error stream and an exit code, usually 2."""

import sys
from contextlib import contextmanager

import typer
from typer.core import TyperGroup

from ..storage.atomic import sentence_of

#: The class that typer raises for a wrong option; its name differs between versions of typer.
UsageError = typer.BadParameter.__base__


class Refused(Exception):
    """A request that cannot be fulfilled, with a sentence that says why, and the exit code ``code``."""

    def __init__(self, sentence, code=2):
        super().__init__(sentence)
        self.code = code


class Door(TyperGroup):
    """The group of commands; it prints errors as one sentence, without usage text or traceback."""

    def main(self, *arguments, standalone_mode=True, **options):
        """Run a command and end the process with its exit code; without ``standalone_mode``, return the
        code."""
        try:
            code = super().main(*arguments, standalone_mode=False, **options)
        except Refused as refusal:
            code = _say(str(refusal), refusal.code)
        except UsageError as wrong:
            code = _say(wrong.format_message(), 2)
        if standalone_mode:
            sys.exit(code)
        return code

    def invoke(self, context):
        """Run the chosen command; Ctrl-C ends it with a sentence and exit code 130."""
        try:
            return super().invoke(context)
        except KeyboardInterrupt:
            raise Refused("interrupted; no file is half written", code=130) from None


def _say(sentence, code):
    """Print ``sentence`` in one line on the error stream, and return ``code``."""
    print(f"wrcontact: {' '.join(sentence.split())}", file=sys.stderr)
    return code


@contextmanager
def sentences():
    """Inside this context, a ValueError of the package or an OSError becomes :class:`Refused`."""
    try:
        yield
    except ValueError as wrong:
        raise Refused(str(wrong)) from None
    except OSError as wrong:
        raise Refused(sentence_of(wrong)) from None
