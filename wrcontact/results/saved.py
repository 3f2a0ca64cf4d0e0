"""A pickle can only be read by the version that wrote it, because the order of the outputs changes between versions."""

from functools import cache

from ..kernel import layout
from ..version import __version__


@cache
def version_mark():
    """The version, and what tells its records from those of another one."""
    return __version__, layout.digest()


def check_mark(mark, what):
    """Raise a ValueError, in a sentence, if the ``mark`` of ``what`` was pickled is not this version's."""
    if mark != version_mark():
        own, _ = version_mark()
        other = ", with other records" if mark[0] == own else ""
        raise ValueError(
            f"{what} was saved by wrcontact {mark[0]}, this is {own}{other}; permitted is the "
            "same version: keep results as tables, to_pandas or to_xarray"
        )
