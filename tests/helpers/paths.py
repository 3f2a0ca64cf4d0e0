"""Folders of the repository that tests read."""

from pathlib import Path

HELPERS = Path(__file__).resolve().parent
TESTS = HELPERS.parent
ROOT = TESTS.parent
#: Stored results of other programs, and the programs.
DATA = ROOT / "data"
