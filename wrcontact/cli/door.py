"""Errors of the command line: always one sentence on the error stream and an exit code, usually 2."""

import os
import sys
from contextlib import contextmanager, suppress

import typer
from typer.core import TyperGroup

from ..results.convert import NeedsPackage
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
        _write_any_text()
        try:
            code = super().main(*arguments, standalone_mode=False, **options)
            sys.stdout.flush()
        except Refused as refusal:
            code = _say(str(refusal), refusal.code)
        except UsageError as wrong:
            code = _say(wrong.format_message(), 2)
        except BrokenPipeError:     # the reader has seen enough
            code = _drop_output()
        except OSError as wrong:
            if wrong.filename is not None:
                raise
            code = _drop_output()
            _say(f"the output cannot be written: {wrong.strerror or wrong}", code)
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


def _write_any_text():
    """A character that a stream's encoding does not have is written as "?"."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")


def _drop_output():
    """Write what is still to be written to nowhere, since the output stream failed; the exit code."""
    with suppress(OSError, ValueError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    return 1


@contextmanager
def sentences(words=str, code=2):
    """Inside this context, a ValueError of the package or an OSError becomes :class:`Refused`; ``words`` is
    called with the sentence, ``code`` is the exit code."""
    try:
        yield
    except (ValueError, NeedsPackage) as wrong:
        raise Refused(words(str(wrong)), code) from None
    except BrokenPipeError:
        raise
    except OSError as wrong:
        raise Refused(sentence_of(wrong), code) from None
