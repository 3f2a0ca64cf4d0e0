"""Tests, in rooms as the package has them; what several of them use is in ``helpers``."""
