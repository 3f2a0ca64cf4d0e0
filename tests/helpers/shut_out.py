"""Packages that an FMU must do without are refused to the process that runs it."""

import sys


class Shut:
    """An import hook that refuses the packages which an FMU must not need."""

    names = frozenset({"wrcontact", "scipy", "matplotlib", "typer", "rich", "hypothesis"})

    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] in self.names:
            raise ImportError(f"{name} is shut out: the FMU has to do without")


def shut_out():
    """Refuse them from now on."""
    sys.meta_path.insert(0, Shut())
