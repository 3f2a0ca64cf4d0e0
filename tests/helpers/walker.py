"""A seeded random walk of a wheelset over tread, flange root and flange: the one of
tests/fmu/native/host.c, number by number."""

#: Lateral shift [m], yaw [rad], roll guess [rad], normal force [N], load transfer: bounds and longest step.
LOWEST = (-8e-3, -0.035, -0.02, 1e3, -0.95)
HIGHEST = (8e-3, 0.035, 0.02, 200e3, 0.95)
STRIDE = (2e-3, 0.01, 5e-3, 50e3, 0.3)
#: Where it comes back to every RETURN steps.
HOME = (5e-3, 2e-3, 0.0, 78.5e3, 0.1)
RETURN = 500


class Walker:
    """Iterate over its rows of inputs; ``at`` is where it is."""

    def __init__(self, seed):
        self.random, self.at = seed, list(HOME)

    def draw(self):
        """The next number from -1 to 1."""
        self.random = (self.random * 6364136223846793005 + 1442695040888963407) % 2**64
        return (self.random >> 11) * 2.0**-52 - 1.0

    def move(self):
        """A step in every direction, mostly a short one, reflected at the bounds."""
        for i, (low, high, stride) in enumerate(zip(LOWEST, HIGHEST, STRIDE)):
            r = self.draw()
            value = self.at[i] + stride * (r * r * r)
            value = low + (low - value) if value < low else value
            self.at[i] = high - (value - high) if value > high else value

    def rows(self, count):
        """``count`` rows of five inputs; at home every RETURN rows."""
        for k in range(count):
            self.move()
            yield HOME if k % RETURN == 0 else self.at
