"""The wheelset of case.py as a body of Drake (``pip install drake``).

    python -m examples.engines.in_drake

The contact is a system between the plant's motion and its applied forces, so that every integrator of Drake
evaluates it wherever it wants.  Drake's world has the axes of the track; its gravity points along z, down.
"""

import numpy as np
from pydrake.common.value import Value
from pydrake.math import RigidTransform, RollPitchYaw
from pydrake.multibody.math import SpatialForce, SpatialVelocity
from pydrake.multibody.plant import ExternallyAppliedSpatialForce, MultibodyPlant
from pydrake.multibody.tree import RotationalInertia, SpatialInertia
from pydrake.systems.analysis import ApplySimulatorConfig, Simulator, SimulatorConfig
from pydrake.systems.framework import DiagramBuilder, LeafSystem

from .case import GRAVITY, INERTIA, MASS, Run, report


class Contact(LeafSystem):
    """Rails and springs: the applied force of one body from its pose and velocity."""

    def __init__(self, wheelset, body):
        super().__init__()
        self.wheelset, self.body = wheelset, body
        self.poses = self.DeclareAbstractInputPort("poses", Value([RigidTransform()]))
        self.rates = self.DeclareAbstractInputPort("velocities", Value([SpatialVelocity()]))
        self.DeclareAbstractOutputPort("force", lambda: Value([ExternallyAppliedSpatialForce()]), self.push)

    def push(self, context, output):
        pose = self.poses.Eval(context)[int(self.body)]
        rate = self.rates.Eval(context)[int(self.body)]
        force, moment = self.wheelset.pushes(
            pose.translation(), pose.rotation().matrix(), rate.translational(), rate.rotational()
        )
        applied = ExternallyAppliedSpatialForce()
        applied.body_index, applied.F_Bq_W = self.body, SpatialForce(moment, force)
        output.set_value([applied])


def run(wheelset, duration, step=2.5e-4, every=20):
    """A :class:`~.case.Run` of ``duration`` [s] in steps of ``step`` [s], every ``every``-th recorded."""
    builder = DiagramBuilder()
    plant = builder.AddSystem(MultibodyPlant(time_step=0.0))
    inertia = SpatialInertia.MakeFromCentralInertia(MASS, np.zeros(3), RotationalInertia(*INERTIA))
    body = plant.AddRigidBody("wheelset", inertia)
    plant.mutable_gravity_field().set_gravity_vector([0, 0, GRAVITY])
    plant.Finalize()
    contact = builder.AddSystem(Contact(wheelset, body.index()))
    builder.Connect(plant.get_body_poses_output_port(), contact.poses)
    builder.Connect(plant.get_body_spatial_velocities_output_port(), contact.rates)
    builder.Connect(contact.get_output_port(), plant.get_applied_spatial_force_input_port())
    simulator = Simulator(builder.Build())
    config = SimulatorConfig(integration_scheme="runge_kutta3", max_step_size=step, use_error_control=False)
    ApplySimulatorConfig(config, simulator)
    state = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    stands = RigidTransform(RollPitchYaw(wheelset.roll, 0, 0), wheelset.position)
    plant.SetFreeBodyPose(state, body, stands)
    moving = np.concatenate([wheelset.angular_velocity, wheelset.velocity])
    plant.SetVelocities(state, moving)  # of a free body in this order, in the axes of the world
    rows = []
    for now in np.arange(0, duration, every * step):
        simulator.AdvanceTo(now)
        rows.append((now, *plant.EvalBodyPoseInWorld(state, body).translation()[:2]))
    return Run(*np.array(rows).T)


if __name__ == "__main__":
    report(run)
