"""A contact system that a session builds without the kernel."""

import numpy as np

from wrcontact.kernel import layout


class FakeStepper:
    """Outputs count up from the sum of the inputs, plus what the memory holds; a
    negative force is invalid."""

    def __init__(self):
        self.inputs, self.outputs, self.state = (
            np.zeros(layout.INPUT_COUNT),
            np.zeros(layout.OUTPUT_COUNT),
            np.zeros(3),
        )

    def step(self):
        if not np.isfinite(self.inputs).all() or self.inputs[layout.IN_NORMAL_FORCE] < 0:
            return layout.INVALID_INPUT
        self.state[0] += 0.1
        self.outputs[:] = self.inputs.sum() + np.arange(layout.OUTPUT_COUNT) + self.state[0]
        return layout.VALID


class FakeSystem:
    """Accepts a gauge from 1 to 2 m, and keeps what it was made with."""

    made = []

    def __init__(self, **arguments):
        if not 1.0 <= arguments["gauge"] <= 2.0:
            raise ValueError(f"gauge is {arguments['gauge']} m, permitted is 1 to 2 m")
        self.made.append(arguments)

    def stepper(self):
        return FakeStepper()
