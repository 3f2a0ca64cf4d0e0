"""First estimates of penetrations, from pose and force alone; they are smooth in both, and so is the
result."""

from typing import Final

from ..contact.frame import open_contact_region
from ..elementary.powers import cube_root
from ..layout import Contact, Pair, Regions
from .coefficients import FLOOR, hertz_coefficients, hertz_stiffness
from ..contact.widths import measure_widths

#: Lateral over longitudinal curvature of the first guess; penetration goes with (A + B)^(1/3).
TYPICAL_RATIO: Final[float] = 2.0
#: Largest lateral over longitudinal curvature of the estimate; a width cut short by a profile's end gives no
#: curvature.
CEILING: Final[float] = 1e3
#: A region begins with no less than this share of the penetration.
LEAST_SHARE: Final[float] = 0.1


def guess_penetration(force: float, A: float, contact_modulus: float):
    """((3 N / 4 E*)^2 (A + B))^(1/3) [m], Hertz's eq. (2.8) with r = 1 and a typical B."""
    share = 0.75 * force / contact_modulus
    return cube_root(share * share * (1.0 + TYPICAL_RATIO) * A)


def estimate_penetration(pair: Pair, contact: Contact, force: float):
    """Hertz's penetration [m] for the interpenetration's own width: B = penetration / width^2 at a guessed
    penetration.

    Exact for constant curvatures; within 12 % for nine of ten poses of S1002 on UIC60.
    """
    region = contact.regions[0]
    A = 0.5 * region.curvature
    guess = guess_penetration(force, A, pair.tables.contact_modulus)
    measure_widths(pair, contact, region, guess)
    width = 0.5 * (region.width_low + region.width_high)
    B = FLOOR * A
    if guess > CEILING * A * width * width:
        B = CEILING * A
    elif guess > B * width * width:
        B = guess / (width * width)
    one_alpha, one_beta, nr = hertz_coefficients(pair.tables.hertz, A, B)
    stiffness = hertz_stiffness(one_beta, nr, B, pair.tables.contact_modulus)
    root = cube_root(force / stiffness)
    return root * root


def first_penetration(pair: Pair, contact: Contact, force: float):
    """Estimate of the penetration [m] under the prescribed ``force`` [N]."""
    open_contact_region(pair.tables, contact.frame, contact.regions[0])
    region = contact.regions[0]
    region.width_penetration = 0.0
    return estimate_penetration(pair, contact, force / region.share)


def start_penetrations(regions: Regions, count: int, penetration: float):
    """Local penetrations before any interaction is known; a region that is hardly reached still gets nodes
    for LEAST_SHARE of the penetration."""
    for i in range(count):
        region = regions[i]
        local = max(region.alignment * penetration - region.gap, LEAST_SHARE * penetration)
        region.local_penetration = local
