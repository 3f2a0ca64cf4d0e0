"""Start values of parameters and inputs that differ from the usual ones.

Empty here; an FMU that was built with profile files or settings of its own carries its file with them.
"""

STARTS = {}
