"""Witnesses for outputs that follow the motion of the wheelset, and for the equilibrium; a part of
output_witnesses.py."""

from tests.helpers.motion import creepages, sliding
from wrcontact import ContactSystem


def equilibrium(name):
    """Of a wheelset that is told its height and roll: where an elastic one stands under the load; of others
    their own."""
    def witness(scene):
        value = scene.values[name]
        if scene.mode == "compliant":
            load = {key: scene.inputs[key] for key in ("lateral_shift", "yaw", "normal_force")}
            value = getattr(ContactSystem(contact_mode="elastic").evaluate(**load), name)
        yield value, 1e-12
    return witness


def motion(wheel, k):
    """What :func:`tests.helpers.motion.sliding` asks for, of patch ``k``."""
    given = wheel.inputs
    names = {"lateral": "lateral_velocity", "vertical": "vertical_velocity", "yaw_rate": "yaw_rate",
             "roll_rate": "roll_rate", "curvature": "track_curvature"}
    return dict(place=[wheel[f"patch[{k}].{axis}_track"] for axis in "xyz"], sign=wheel.sign,
                radius=wheel[f"patch[{k}].rolling_radius"], centre=wheel.centre,
                angle=wheel[f"patch[{k}].contact_angle"], yaw=given["yaw"], roll=wheel.values["roll"],
                speed=given["speed"], wheel_rate=given["wheel_rate"],
                **{name: given[key] for name, key in names.items()})


def patch_creepage(index):
    """Of the wheel's surface that is moved with the wheelset; none of a wheelset that stands still."""
    def witness(wheel, k):
        if not wheel.inputs.get("speed"):
            yield 0.0, 0.0
            return
        yield creepages(**motion(wheel, k))[index], 1e-6
    return witness


def patch_moves(wheel, k):
    """Velocity of the wheel's surface against the rail (3,) [m/s], and rotation about the normal [rad/s]."""
    slide, _, turning, _ = sliding(**motion(wheel, k))
    return slide, turning
