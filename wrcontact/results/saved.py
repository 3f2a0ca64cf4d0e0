"""What is pickled belongs to one version: its numbers have places that others have elsewhere."""

from functools import cache

from ..kernel import layout


@cache
def version_mark():
    """The version, and what tells its records from those of another one."""
    from .. import __version__  # an FMU has none, and pickles nothing

    return __version__, layout.digest()


def check_mark(mark, what):
    """Refuse ``what`` was pickled with a ``mark`` that is not the one of this version, with a ValueError."""
    if mark != version_mark():
        own, _ = version_mark()
        raise ValueError(f"{what} was saved by wrcontact {mark[0]}, this is {own}"
                         f"{', with other records' if mark[0] == own else ''}; permitted is the same version: "
                         "keep results as tables, to_pandas or to_xarray")
