"""How many numbers each array has."""

from typing import Final

from .interface import Inputs, Outputs, Parameters
from .record import size
from .tables import Setup, Tables
from .tangential import RollingTable
from .wheelset import State
from .work import Work

INPUT_COUNT: Final[int] = size(Inputs)
OUTPUT_COUNT: Final[int] = size(Outputs)
WORK_SIZE: Final[int] = size(Work)
STATE_SIZE: Final[int] = size(State)
SETTING_COUNT: Final[int] = size(Tables)
SETUP_SIZE: Final[int] = size(Setup)
PARAMETERS_SIZE: Final[int] = size(Parameters)
ROLLING_TABLE_SIZE: Final[int] = size(RollingTable)
