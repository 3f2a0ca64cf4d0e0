"""The numbers of the kernel's elementary functions: ``python tools/make_elementary.py`` prints them as they
stand in wrcontact/kernel/elementary.

Each polynomial stands for what is left of a function's series when its first terms are taken away, over an
interval that argument reduction leads to.  It has the least squares of errors at Chebyshev's nodes, which is
within a small factor of the least error; its coefficients are rounded one after the other, and those that
follow make good what the rounding took.  Constants of more digits than a float has are split: the first parts
have few enough bits that their products with small whole numbers are exact.
"""

from mpmath import mp, mpf

mp.dps = 60


def polynomials():
    """{name: (function, ends of its interval, number of coefficients)}"""
    quarter = (mp.pi / 4) ** 2 * mpf("1.0001")
    return {
        "SINE": (lambda z: (mp.sin(mp.sqrt(z)) / mp.sqrt(z) - 1) / z, 0, quarter, 6),
        "COSINE": (lambda z: (mp.cos(mp.sqrt(z)) - 1 + z / 2) / z**2, 0, quarter, 6),
        "ARC": (lambda z: (mp.atan(mp.sqrt(z)) / mp.sqrt(z) - 1) / z, 0, mpf(7) ** 2 / 16**2, 11),
        "GROWTH": (
            lambda r: (mp.expm1(r) - r) / r**2,
            -mp.log(2) / 2 * mpf("1.001"),
            mp.log(2) / 2 * mpf("1.001"),
            10,
        ),
        # ln((1 + s)/(1 - s)) = 2 s + s z R(z), z = s^2
        "LOGARITHM": (
            lambda z: (2 * mp.atanh(mp.sqrt(z)) / mp.sqrt(z) - 2) / z,
            0,
            (3 - 2 * mp.sqrt(2)) ** 2 * mpf("1.0001"),
            7,
        ),
        "ROOT": (lambda x: mp.cbrt(x), 1, 8, 4),
    }


def rounded(function, low, high, count):
    """Coefficients (count) as floats, each the best one beside those that are rounded already."""
    nodes = [
        (high + low) / mpf(2) + (high - low) / mpf(2) * mp.cos(mp.pi * (2 * k + 1) / (8 * count))
        for k in range(4 * count)
    ]
    left = [function(z) for z in nodes]
    found = []
    for k in range(count):
        powers = mp.matrix([[z**j for j in range(k, count)] for z in nodes])
        found.append(float(mp.qr_solve(powers, mp.matrix(left))[0][0]))
        left = [value - found[-1] * z**k for value, z in zip(left, nodes)]
    return found


def split(value, *bits):
    """Floats whose sum is ``value``: the first ones of so many bits each, the last one of all."""
    parts = []
    for size in bits:
        scale = mpf(2) ** (size - 1 - int(mp.floor(mp.log(abs(value), 2))))
        parts.append(float(mp.nint(value * scale) / scale))
        value -= parts[-1]
    return [*parts, float(value)]


def constants():
    """{name: float}"""
    found = {"QUARTER_SQUARE": float((mp.pi / 4) ** 2), "PER_QUARTER": float(2 / mp.pi)}
    found |= dict(zip(("TURN_0", "TURN_1", "TURN_2"), split(mp.pi / 2, 33, 33)))
    for name, value in (
        ("HALF_ARC", mp.atan(mpf(1) / 2)),
        ("ONE_ARC", mp.pi / 4),
        ("MORE_ARC", mp.atan(mpf(3) / 2)),
        ("ALL_ARC", mp.pi / 2),
        ("STRAIGHT", mp.pi),
    ):
        found |= dict(zip((name, f"{name}_REST"), (float(value), float(value - mpf(float(value))))))
    found |= dict(zip(("LN2", "LN2_REST"), split(mp.log(2), 32)))
    found |= {"PER_LN2": float(1 / mp.log(2)), "ROOT_OF_2": float(mp.sqrt(2))}
    for name, made in polynomials().items():
        found |= {f"{name}_{k}": value for k, value in enumerate(rounded(*made))}
    return found


if __name__ == "__main__":
    for name, value in constants().items():
        print(f"{name}: Final[float] = {value!r}")
