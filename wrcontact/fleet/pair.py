"""The work on one pair, in any process."""

import warnings

from ..conditioning.report import check
from ..conditioning.text import check_text
from ..system import ContactSystem
from .table import empty_row, numbers_of

#: Which pairs have a picture.
PICTURES = ("remarks", "all", "none")


def examine(wheel, rail, parameters, with_text, pictures):
    """Row, JSON and picture of a pair of profiles; None for what is not wanted.

    Parameters
    ----------
    parameters : other keywords of :class:`~wrcontact.ContactSystem`.
    with_text : whether the JSON is wanted.
    pictures : one of PICTURES.
    """
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # what a warning says is a remark of the report
        try:
            report = check(ContactSystem(wheel, rail, **parameters))
        except ValueError as wrong:
            return empty_row(error=str(wrong)), None, None
        text, drawn = check_text(report) if with_text else None, None
        if pictures == "all" or pictures == "remarks" and report.remarks:
            from .picture import picture  # matplotlib is not needed otherwise

            drawn = picture(report)
        row = empty_row(usable=report.usable, **numbers_of(report), remarks=list(report.remarks))
        return row, text, drawn
