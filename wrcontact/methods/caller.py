"""Warnings that point to the line outside the package by which it was entered."""

import os
import sys
import warnings

#: How the names of the package's own files begin.
PACKAGE = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep


def warn_caller(warning, category=None):
    """``warnings.warn`` with the place in the user's code that has called the package."""
    level, frame = 2, sys._getframe(1)
    while frame.f_back is not None and frame.f_code.co_filename.startswith(PACKAGE):
        level, frame = level + 1, frame.f_back
    warnings.warn(warning, category, stacklevel=level)
