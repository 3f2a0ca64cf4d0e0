"""Track: irregularities from spectra and from measurements, and curves with transitions.

>>> from wrcontact import track
>>> rough = track.generate("ERRI high", length=500.0, seed=1)
>>> inputs = rough.inputs([100.0, 101.0, 102.0])        # keywords of evaluate_many
>>> sorted(inputs)
['left_rail_lateral', 'left_rail_vertical', 'right_rail_lateral', 'right_rail_vertical']
>>> import wrcontact
>>> bool((wrcontact.ContactSystem().evaluate_many(1e-3, **inputs).status == 0).all())
True
"""

from .curves import Curve
from .irregularities import Irregularities, generate, read_irregularities
from .spectra import SPECTRA, Spectrum, spectrum

__all__ = ["SPECTRA", "Curve", "Irregularities", "Spectrum", "generate", "read_irregularities", "spectrum"]
