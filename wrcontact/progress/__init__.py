"""A sign of life on the error stream: what is being done, how far it is, and the time left.

It appears after two seconds, if the error stream is a terminal, and disappears when the work is done.
Elsewhere the command line writes a line every ten seconds (:func:`in_lines`), and Python nothing.
``WRCONTACT_PROGRESS=off`` in the environment switches both off.

>>> with working("poses", 100) as advance:
...     for _ in range(100):
...         advance()
"""

import contextlib
import os
import sys
import threading

#: Time after which the sign appears, and between lines [s].
DELAY, INTERVAL = 2.0, 10.0

_lock = threading.RLock()
_silent = threading.local()  # .on: this thread shows nothing
_board = None  # the only one: a terminal has room for one display
_prefix = None  # of lines, where there is no terminal


@contextlib.contextmanager
def in_lines(prefix):
    """Inside this context, an error stream that is no terminal gets a line "prefix: ..." every INTERVAL."""
    global _prefix
    before, _prefix = _prefix, prefix
    try:
        yield
    finally:
        _prefix = before


@contextlib.contextmanager
def silently():
    """Inside this context, this thread shows nothing: its work is a part of what another one shows."""
    _silent.on = True
    try:
        yield
    finally:
        _silent.on = False


@contextlib.contextmanager
def working(words, total=None, alone=False):
    """Show work of ``total`` steps (None: unknown) described by ``words`` while the ``with`` block runs.

    Yields a function ``advance(steps=1, words=None)``.  Work inside other work gets a line of its own, unless
    it is to be shown ``alone``.
    """
    if not _is_wanted() or (alone and _board is not None):
        yield _ignore
        return
    board, line = _enter(words, total)
    try:
        yield lambda steps=1, words=None: board.advance(line, steps, words)
    finally:
        _leave(board, line)


def tracked(items, words, total=None, alone=False):
    """The ``items`` themselves, while the work with them is shown as by :func:`working`."""
    if total is None and hasattr(items, "__len__"):
        total = len(items)
    with working(words, total, alone) as advance:
        for item in items:
            yield item
            advance()


def _is_wanted():
    """Whether somebody can see it: in lines, or on a terminal that can move its cursor."""
    if os.environ.get("WRCONTACT_PROGRESS") == "off" or sys.stderr is None or getattr(_silent, "on", False):
        return False
    return _moves_cursor() or _prefix is not None


def _moves_cursor():
    """Whether the error stream is a terminal that can move its cursor."""
    return is_terminal(sys.stderr) and os.environ.get("TERM") != "dumb"


def is_terminal(stream):
    """Whether a stream is a terminal; not where there is none, or where it is closed."""
    try:
        return stream.isatty()
    except (AttributeError, ValueError):
        return False


def _ignore(steps=1, words=None):
    """Advance what nobody sees."""


def _enter(words, total):
    global _board
    with _lock:
        if _board is None:
            from .board import Lines, Screen  # rich is not needed before

            _board = Screen(DELAY, is_terminal(sys.stdout)) if _moves_cursor() else Lines(INTERVAL, _prefix)
        return _board, _board.add(words, total)


def _leave(board, line):
    global _board
    with _lock:
        if board.remove(line) == 0:
            board.close()
            if _board is board:
                _board = None
