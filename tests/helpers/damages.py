"""Bytes that are no saved state."""

import random


def damages(saved, seed, count):
    """Seeded damages to the bytes of a state, with their names: flipped bits, cut and longer ones,
    bytes of something else."""
    chance = random.Random(seed)
    for k in range(count):
        damaged = bytearray(saved)
        for _ in range(chance.choice((1, 1, 2, 8))):
            # the head is short
            place = chance.randrange(100) if chance.random() < 0.3 else chance.randrange(len(saved))
            damaged[place] ^= 1 << chance.randrange(8)
        if bytes(damaged) != saved:
            yield f"flips of seed {seed}, number {k}", bytes(damaged)
    for length in sorted(
        {0, 1, 15, 16, 17, 64, len(saved) - 8, len(saved) - 1, *chance.sample(range(len(saved)), 20)}
    ):
        yield f"cut at {length}", saved[:length]
    yield "longer", saved + b"\0"
    yield "twice", saved + saved
    yield "zeros", bytes(len(saved))
    yield "noise", chance.randbytes(len(saved))
    yield "head of a state", saved[:100] + chance.randbytes(len(saved) - 100)
