"""Start values of parameters that differ from the usual ones.

Empty here; an FMU that was built with profile files of its own carries its file with their names.
"""

STARTS = {}
