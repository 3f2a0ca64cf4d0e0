"""The wheelset of case.py as a body of MuJoCo (``pip install mujoco``).

    python -m examples.engines.in_mujoco

The contact is MuJoCo's callback for passive forces, which its Runge-Kutta method calls in each stage.  MuJoCo's
world has the axes of the track; its gravity points along z, down.  Its own contacts are switched off.
"""

import math

import mujoco
import numpy as np

from .case import GRAVITY, INERTIA, MASS, Run, report

MODEL = """
<mujoco>
  <option gravity="0 0 {gravity}" timestep="{step}" integrator="RK4"><flag contact="disable"/></option>
  <worldbody><body name="wheelset"><freejoint/>
    <inertial pos="0 0 0" mass="{mass}" diaginertia="{roll} {pitch} {yaw}"/>
  </body></worldbody>
</mujoco>
"""


def run(wheelset, duration, step=2.5e-4, every=20):
    """A :class:`~.case.Run` of ``duration`` [s] in steps of ``step`` [s], every ``every``-th recorded."""
    roll, pitch, yaw = INERTIA
    model = mujoco.MjModel.from_xml_string(
        MODEL.format(gravity=GRAVITY, step=step, mass=MASS, roll=roll, pitch=pitch, yaw=yaw)
    )
    data = mujoco.MjData(model)
    data.qpos[:] = [*wheelset.position, math.cos(wheelset.roll / 2), math.sin(wheelset.roll / 2), 0, 0]
    # of a free joint linear velocities are in the axes of the world, angular ones in those of the body
    data.qvel[:] = [*wheelset.velocity, *wheelset.angular_velocity]

    def push(_, data):
        rotation = data.xmat[1].reshape(3, 3)
        force, moment = wheelset.pushes(data.qpos[:3], rotation, data.qvel[:3], rotation @ data.qvel[3:])
        data.qfrc_passive[:] = [*force, *(moment @ rotation)]

    rows = []
    mujoco.set_mjcb_passive(push)
    try:
        for count in range(round(duration / step)):
            mujoco.mj_step(model, data)
            if count % every == 0:
                rows.append((data.time, *data.qpos[:2]))
    finally:
        mujoco.set_mjcb_passive(None)
    return Run(*np.array(rows).T)


if __name__ == "__main__":
    report(run)
