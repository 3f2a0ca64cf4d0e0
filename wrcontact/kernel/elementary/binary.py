"""The bits of floats.  C has these functions in native/spans.h; they are exact."""

from struct import pack, unpack

from ..layout import native


@native
def exponent(x: float) -> int:
    """The exponent of two of a positive ``x``, neither infinite nor subnormal: 1 <= x / 2^exponent < 2."""
    return (unpack("<q", pack("<d", x))[0] >> 52) - 1023


@native
def power_of_two(k: int) -> float:
    """2^k, for k = -1022 ... 1023."""
    return unpack("<d", pack("<q", (k + 1023) << 52))[0]


@native
def counted(x: float) -> int:
    """The whole number n of ``x`` = 2^52 + n, 0 <= n < 2^32, from its lowest bits: so it takes no conversion,
    which an address would wait for."""
    return unpack("<q", pack("<d", x))[0] & 0xFFFFFFFF
