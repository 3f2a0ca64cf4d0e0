"""How the command line refuses: one sentence on the error stream and exit code 2, whoever noticed what is wrong."""

import sys
from contextlib import contextmanager

import typer
from typer.core import TyperGroup

from ..storage.atomic import sentence_of

#: What typer raises for a wrong option, under whatever name its version keeps it.
UsageError = typer.BadParameter.__base__


class Refused(Exception):
    """What was asked for cannot be done; the sentence says why, ``code`` is the exit code."""

    def __init__(self, sentence, code=2):
        super().__init__(sentence)
        self.code = code


class Door(TyperGroup):
    """The commands; a refusal is a sentence, never a picture of the usage or a traceback."""

    def main(self, *arguments, standalone_mode=True, **options):
        """Run a command and end the process with its exit code; without ``standalone_mode`` return it."""
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
        """The chosen command; Ctrl-C is a refusal too."""
        try:
            return super().invoke(context)
        except KeyboardInterrupt:
            raise Refused("interrupted; a file is whole, or as it was before", code=130) from None


def _say(sentence, code):
    """Print the sentence in one line; the exit code that goes with it."""
    print(f"wrcontact: {' '.join(sentence.split())}", file=sys.stderr)
    return code


@contextmanager
def sentences():
    """Inside, a ValueError (the package's sentences) and a file that cannot be read or written are refusals."""
    try:
        yield
    except ValueError as wrong:
        raise Refused(str(wrong)) from None
    except OSError as wrong:
        raise Refused(sentence_of(wrong)) from None
