"""Force and moment of one wheelset's contacts, and how a solver with a Jacobian by differences gets them
cheaply."""

import numpy as np

import wrcontact

#: Motions that forces follow, and how far off a motion is still answered by derivatives: forces are straight
#: there, and solvers take their differences within it.
NEAR = {
    "lateral_shift": 1e-7,
    "vertical_shift_input": 1e-7,
    "roll_input": 1e-7,
    "yaw": 1e-7,
    "speed": 1e-4,
    "lateral_velocity": 1e-5,
    "vertical_velocity": 1e-5,
    "roll_rate": 1e-5,
    "yaw_rate": 1e-5,
    "wheel_rate": 1e-4,
}
FORCES = ("force.x", "force.y", "force.z", "moment.x", "moment.y", "moment.z")
#: The contact where a run says nothing else.
CONTACT = {"contact_mode": "compliant", "contact_damping": 1.0, "tangential_model": "strips"}
#: What linear theory has in closed form: cones of 1:20 on rails that are inclined alike, Hertz's patches, and
#: friction far from its limit.
CONES = CONTACT | {
    "wheel": "cone20",
    "rail_inclination": 0.05,
    "normal_model": "hertz",
    "contact_damping": 0.0,
}


class Contact:
    """The contacts of a wheelset; counts steps and derivatives.

    ``loads`` (2,) are the vertical forces of the left and the right wheel on the rail [N] in the last step.
    """

    def __init__(self, system, load, friction=0.3):
        self.stepper = system.stepper(outputs="patches")
        given = {"normal_force": load, "left.friction": friction, "right.friction": friction}
        for name, value in given.items():
            self.stepper.inputs[self.stepper.place(name)] = value
        self.vertical = [self.stepper.place(f"{side}.force.z") for side in ("left", "right")]
        self.steps = self.derivatives = self.failed = 0

    @property
    def loads(self):
        return -self.stepper.outputs[self.vertical]

    def resultant(self, motion):
        """Force and moment (6,) at a motion, a dict of inputs."""
        self.steps += 1
        force, moment = self.stepper.resultant(motion)
        self.failed += bool(np.isnan(force[0]))
        return np.concatenate([force, moment])


class Nearby(Contact):
    """Near the last motion, forces follow from their derivatives there."""

    def __init__(self, *given):
        super().__init__(*given)
        self.near = np.array(list(NEAR.values()))
        self.place, self.found, self.slopes = np.full(len(NEAR), np.nan), None, None

    def resultant(self, motion):
        place = np.array([motion[name] for name in NEAR])
        away = place - self.place
        if not (np.abs(away) <= self.near).all():
            self.place, self.found, self.slopes = place, super().resultant(motion), None
            return self.found
        if not away.any():
            return self.found
        if self.slopes is None:  # the stepper still stands at the last motion
            self.derivatives += 1
            self.slopes = self.stepper.derivatives(FORCES, list(NEAR))
        return self.found + self.slopes @ away


def contact_system(**contact):
    """The system of all wheelsets, whose parameters are those of ``CONTACT`` and these."""
    return wrcontact.ContactSystem(**CONTACT | contact)
