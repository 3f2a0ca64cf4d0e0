"""Errors of the command line: always one sentence on the error stream and an exit code, usually 2."""

import errno
import os
import re
import signal
import sys
import threading
from contextlib import contextmanager, suppress
from pathlib import Path

import typer
from typer.core import TyperGroup

from ..kernel.binding.compiler import CompilerProblem
from ..methods.words import PROPOSAL, did_you_mean
from ..results.convert import NeedsPackage
from ..storage.atomic import sentence_of
from .help import write_help

#: The class that typer raises for a wrong option; its name differs between versions of typer.
UsageError = typer.BadParameter.__base__


#: The message after Ctrl-C, and its exit code.
INTERRUPTION, INTERRUPTED = "interrupted; no file is half written", 130


class Refused(Exception):
    """A request that cannot be fulfilled, with a sentence that says why, and the exit code ``code``."""

    def __init__(self, sentence, code=2):
        super().__init__(sentence)
        self.code = code


class CommandGroup(TyperGroup):
    """The group of commands; it prints errors as one sentence, without usage text or traceback."""

    def format_help(self, context, formatter):
        """The help text, in groups."""
        write_help(self, context, formatter)

    def main(self, *arguments, standalone_mode=True, **options):
        """Run a command and end the process with its exit code; without ``standalone_mode``, return the
        code."""
        _write_any_text()
        try:
            code = super().main(*arguments, standalone_mode=False, **options)
            sys.stdout.flush()
            if code == INTERRUPTED:  # before the command was known: typer says nothing
                code = _say(INTERRUPTION, INTERRUPTED)
        except Refused as refusal:
            code = _say(str(refusal), refusal.code)
        except UsageError as wrong:
            code = _say(_words_of(wrong), 2)
        except BrokenPipeError:  # the reader has seen enough
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
        """Run the chosen command; Ctrl-C ends it with a sentence and exit code 130, a request to terminate
        with 143."""
        try:
            with ended_by_signals():
                return super().invoke(context)
        except KeyboardInterrupt:
            raise Refused(INTERRUPTION, INTERRUPTED) from None


@contextmanager
def ended_by_signals():
    """Inside this context, requests to terminate and the loss of the terminal raise :class:`Refused`, so that
    files that are half written are removed."""
    if threading.current_thread() is not threading.main_thread():  # only that receives signals
        yield
        return
    numbers = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]
    before = {
        number: signal.signal(number, _end)
        for number in numbers
        if signal.getsignal(number) is signal.SIG_DFL
    }
    try:
        yield
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)


def _end(number, frame):
    raise Refused("terminated; no file is half written", code=128 + number)


def _words_of(wrong):
    """The sentence on a wrong option, with those that are spelled like it."""
    unknown, command = getattr(wrong, "option_name", None), wrong.ctx and wrong.ctx.command
    extra = re.match(r"Got unexpected extra argument.*? \((.*)\)$", wrong.format_message())
    if command and extra:
        return f"{command.name} takes no {extra[1]!r}; --help says what it takes"
    if not hasattr(wrong, "possibilities") or not unknown or not command:
        return wrong.format_message()
    names = [name.strip("-") for option in command.params for name in (*option.opts, *option.secondary_opts)]
    meant = did_you_mean(unknown.strip("-").replace("_", "-"), names)
    hint = meant.replace(PROPOSAL, PROPOSAL + "--").replace(" or ", " or --")
    return f"{command.name} has no option {unknown}{hint or '; --help-all lists its options'}"


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


#: What is wrong with a path that the user gave; other errors of a file are failures, such as a full disk.
WRONG_PATHS = {
    errno.ENOENT,
    errno.ENOTDIR,
    errno.EISDIR,
    errno.EACCES,
    errno.EPERM,
    errno.EROFS,
    errno.EEXIST,
    errno.ENAMETOOLONG,
    errno.ELOOP,
    errno.EINVAL,
}


@contextmanager
def sentences(words=str):
    """Inside this context, a ValueError of the package or an OSError becomes :class:`Refused`; ``words`` is
    called with the sentence.  The exit code is 2 for wrong input, 1 where a compiler or a disk failed."""
    try:
        yield
    except (ValueError, NeedsPackage) as wrong:
        raise Refused(words(str(wrong)), 1 if isinstance(wrong, CompilerProblem) else 2) from None
    except BrokenPipeError:
        raise
    except OSError as wrong:
        raise Refused(sentence_of(wrong), 2 if wrong.errno in WRONG_PATHS else 1) from None


def check_folder(folder):
    """Refuse a ``folder`` that cannot be written to, or not made, before any work."""
    with sentences():
        place = Path(folder)
        while not place.exists() and place != place.parent:
            place = place.parent
        _check_writable(place, folder)


def check_file(file):
    """Refuse a path at which no file can be written, before any work."""
    with sentences():
        if Path(file).is_dir():
            raise _trouble(errno.EISDIR, file)
        if not Path(file).parent.exists():
            raise _trouble(errno.ENOENT, file)
        if not Path(file).exists():
            _check_writable(Path(file).parent, file)
        elif not os.access(file, os.W_OK):
            raise _trouble(errno.EACCES, file)


def _check_writable(folder, asked):
    if not folder.is_dir():
        raise _trouble(errno.ENOTDIR, asked)
    if not os.access(folder, os.W_OK):
        raise _trouble(errno.EACCES, asked)


def _trouble(number, path):
    return OSError(number, os.strerror(number), os.fspath(path))
