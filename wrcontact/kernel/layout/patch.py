"""Records of the room patch: what is solved of each contact patch."""

from typing import Final


ISLAND_BLOCK: Final[int] = 80        # loaded islands of one wheel
