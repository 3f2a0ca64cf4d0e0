"""The bodies in exudyn: a bogie below a car body that keeps its way, or the whole vehicle.

All is in one frame that does not move: x along the track's beginning, y to the right, z down, gravity +z.

What exudyn wants: the axle is the third axis of its body, so that coordinates of the type Rxyz have no
singularity while it spins; the contact is a connector from the ground, whose user function returns minus the
force; the orientation comes from ``GetObjectOutputBody``, since the rotation that the user function gets is
of no use for a body that spins.
"""

import time

import exudyn
import numpy as np
from exudyn.utilities import (
    Force,
    MarkerBodyRigid,
    ObjectConnectorRigidBodySpringDamper,
    ObjectGround,
    RigidBodyInertia,
)

import wrcontact

from . import manchester as data
from .contact import Contact, contact_system
from .record import Run
from .track import Track

#: Columns are the axes of an exudyn body: ahead, up, and the axle to the right.
AXES = np.array([[1.0, 0, 0], [0, 0, 1.0], [0, -1.0, 0]])
OF = exudyn.OutputVariableType
#: A car body that nothing moves off its way [kg, kg m2].
KEPT = data.Body(1e12, (1e12, 1e12, 1e12), data.CAR.height)


class Vehicle:
    """The vehicle, or one bogie below a car body that is kept on its way.

    Parameters
    ----------
    speed : [m/s] at the beginning.
    bogies : 1 or 2.
    track : a :class:`~examples.vehicle.track.Track`.
    start : lateral shift of all bodies at the beginning [m].
    primary : suspension of an axle box.
    friction : coefficient of both rails.
    answer : :class:`~examples.vehicle.contact.Contact` or ``Nearby``.
    contact : parameters of the ContactSystem.
    """

    def __init__(
        self,
        speed,
        bogies=2,
        track=None,
        start=0.0,
        primary=data.PRIMARY,
        friction=0.3,
        answer=Contact,
        **contact,
    ):
        self.speed, self.track, self.start = speed, track or Track(), start
        system = contact_system(**contact)
        stand = system.evaluate(start, normal_force=data.LOAD / 2).equilibrium
        self.height, self.roll = data.WHEEL_RADIUS - stand.vertical_shift, stand.roll
        self.container = exudyn.SystemContainer()
        self.mbs = self.container.AddSystem()
        self.ground = self.mbs.AddObject(ObjectGround())
        pivots = [data.HALF_PIVOTS, -data.HALF_PIVOTS] if bogies == 2 else [0.0]
        self.ways = [pivot + way for pivot in pivots for way in (data.HALF_BASE, -data.HALF_BASE)]
        self.contacts = [answer(system, data.LOAD / 2, friction) for _ in self.ways]
        self.axles = [self.axle(number, way) for number, way in enumerate(self.ways)]
        self.frames = [self.body(data.FRAME, pivot) for pivot in pivots]
        self.car = self.body(data.CAR if bogies == 2 else KEPT, 0.0, falls=bogies == 2)
        for number, axle in enumerate(self.axles):
            self.hang(axle, self.frames[number // 2], self.ways[number] - pivots[number // 2], primary)
        for frame, pivot in zip(self.frames, pivots):
            self.support(frame, pivot)
        self.bodies = [*self.axles, *self.frames, self.car]
        self.mbs.Assemble()

    def body(self, given, way, falls=True):
        """A body that does not spin, at ``way`` along the track."""
        return self.mbs.CreateRigidBody(
            referencePosition=[way, self.start, -given.height],
            initialVelocity=[self.speed, 0, 0],
            inertia=RigidBodyInertia(given.mass, np.diag(given.inertia)),
            nodeType=exudyn.NodeType.RotationRxyz,
            gravity=[0, 0, data.GRAVITY if falls else 0.0],
        )

    def axle(self, number, way):
        """A wheelset that rolls, at rest on the rails, and the connector that is its contact."""
        cosine, sine = np.cos(self.roll), np.sin(self.roll)
        lean = np.array([[1, 0, 0], [0, cosine, -sine], [0, sine, cosine]])
        rolling, pitching, yawing = data.WHEELSET.inertia
        rate = -self.speed / data.WHEEL_RADIUS * lean[:, 1]  # forward is minus the axle
        body = self.mbs.CreateRigidBody(
            referencePosition=[way, self.start, -self.height],
            referenceRotationMatrix=lean @ AXES,
            initialVelocity=[self.speed, 0, 0],
            initialAngularVelocity=rate,
            inertia=RigidBodyInertia(data.WHEELSET.mass, np.diag([rolling, yawing, pitching])),
            nodeType=exudyn.NodeType.RotationRxyz,
            gravity=[0, 0, data.GRAVITY],
        )

        def pushed(mbs, now, item, shift, turn, velocity, angular_velocity, *_):
            return -self.push(number, velocity, angular_velocity)

        ends = [self.marker(self.ground, [way, self.start, -self.height]), self.marker(body)]
        self.mbs.AddObject(
            ObjectConnectorRigidBodySpringDamper(markerNumbers=ends, springForceTorqueUserFunction=pushed)
        )
        return body

    def marker(self, body, place=(0, 0, 0)):
        return self.mbs.AddMarker(MarkerBodyRigid(bodyNumber=body, localPosition=list(place)))

    def spring(self, ends, stiffness, damping, load):
        """A spring between two markers, in the axes of the first, and the load that it carries at rest.

        This is a vertical force.  As an offset of the spring it would turn with the first body, and exudyn
        gives no moment for that.
        """
        self.mbs.AddObject(
            ObjectConnectorRigidBodySpringDamper(
                markerNumbers=ends, stiffness=np.diag(stiffness), damping=np.diag(damping)
            )
        )
        for end, down in zip(ends, (-load, load)):
            self.mbs.AddLoad(Force(markerNumber=end, loadVector=[0, 0, down]))

    def hang(self, axle, frame, way, primary):
        """The axle boxes of a wheelset in the frame."""
        load = (data.LOAD - data.WHEELSET.mass * data.GRAVITY) / 2
        for side in (-data.HALF_BOXES, data.HALF_BOXES):
            ends = [
                self.marker(frame, [way, side, data.FRAME.height - self.height]),
                self.marker(axle, [0, 0, side]),
            ]
            self.spring(ends, [*primary.stiffness, 0, 0, 0], [*primary.damping, 0, 0, 0], load)

    def support(self, frame, pivot):
        """The car body on a frame: two springs, roll bar, traction rod."""
        (k_x, k_y, k_z), (_, d_y, d_z) = data.SECONDARY.stiffness, data.SECONDARY.damping
        arm = data.HALF_SPRINGS**2
        stiffness = [
            2 * k_x + data.ROD[0],
            2 * k_y,
            2 * k_z,
            2 * k_z * arm + data.ROLL_BAR,
            data.PITCH,
            2 * k_x * arm,
        ]
        damping = [data.ROD[1], 2 * d_y, 2 * d_z, 2 * d_z * arm, 0, 0]
        ends = [
            self.marker(self.car, [pivot, 0, data.CAR.height - data.SECONDARY_HEIGHT]),
            self.marker(frame, [0, 0, data.FRAME.height - data.SECONDARY_HEIGHT]),
        ]
        self.spring(ends, stiffness, damping, data.CAR.mass / 2 * data.GRAVITY)

    def motion(self, number, velocity, angular_velocity):
        """The motion of a wheelset against the track, and the heading of the track [rad]."""
        body = self.axles[number]
        x, y, z = self.mbs.GetObjectOutputBody(body, OF.Position)
        turned = np.reshape(self.mbs.GetObjectOutputBody(body, OF.RotationMatrix), (3, 3)) @ AXES.T
        _, shift, heading, curvature = self.track.at(x, y)
        cosine, sine = np.cos(heading), np.sin(heading)
        into = np.array([[cosine, sine, 0], [-sine, cosine, 0], [0, 0, 1.0]])
        ahead, right, down = into @ velocity
        speed = ahead / (1 - curvature * shift)  # along the middle of the track
        turning = into @ angular_velocity - [0, 0, curvature * speed]
        motion = wrcontact.motion_of([0, shift, z], into @ turned, [speed, right, down], turning)
        return motion | {"track_curvature": curvature}, into

    def push(self, number, velocity, angular_velocity):
        """Force and moment (6,) of the rails on a wheelset."""
        motion, into = self.motion(number, velocity, angular_velocity)
        acting = self.contacts[number].resultant(motion)
        return np.concatenate([acting[:3] @ into, acting[3:] @ into])

    def look(self):
        """A row of a run: of each wheelset what ``RECORDED`` says."""
        rows = []
        for number, (body, contact) in enumerate(zip(self.axles, self.contacts)):
            moving = [self.mbs.GetObjectOutputBody(body, kind) for kind in (OF.Velocity, OF.AngularVelocity)]
            motion, _ = self.motion(number, *moving)
            acting = Contact.resultant(contact, motion)
            rows.append([motion["lateral_shift"], motion["yaw"], *contact.loads, acting[1]])
        return rows, [self.mbs.GetObjectOutputBody(body, OF.Position) for body in self.bodies]

    def run(self, duration, step, solver="RK44", every=4, full_newton=False):
        """A :class:`Run`, of which every ``every``-th step is recorded.

        ``full_newton`` lets an implicit solver renew its Jacobian in each iteration.
        """
        steps, seen, count = round(duration / step), [], iter(range(10**9))
        settings = exudyn.SimulationSettings()
        settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = steps, duration
        newton = settings.timeIntegration.newton
        newton.useModifiedNewton = not full_newton
        # rounding of a place of 30 m, times mass by step squared, is 1e-4 N
        newton.relativeTolerance, newton.absoluteTolerance = 1e-6, 1e-4
        newton.numericalDifferentiation.relativeEpsilon = 1e-9  # of places of 100 m: within NEAR
        newton.numericalDifferentiation.minimumCoordinateSize = 10.0
        settings.solution.file.write = False

        def before(mbs, now):
            if next(count) % every == 0:
                seen.append((now, *self.look()))
            return True

        self.mbs.SetPreStepUserFunction(before)
        began = time.process_time()
        self.mbs.SolveDynamic(settings, solverType=getattr(exudyn.DynamicSolverType, solver))
        used = time.process_time() - began
        now, wheelsets, places = (np.array(column) for column in zip(*seen))
        recorded = len(now) * len(self.axles)
        return Run(
            now,
            wheelsets,
            places,
            next(count),
            sum(c.steps for c in self.contacts) - recorded,
            sum(c.derivatives for c in self.contacts),
            sum(c.failed for c in self.contacts),
            used,
        )
