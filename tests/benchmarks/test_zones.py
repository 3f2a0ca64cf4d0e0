"""Where the wheels of the stored random poses touch."""

from benchmarks import random_poses
from benchmarks.random_poses import Pose


def pose(shift):
    return Pose("UIC60", 0.025, shift, 0.0, 78.5e3)


def test_wheels_are_sorted_by_angle_and_number_of_patches():
    """S1002 on UIC60 1:40: the tread at 0 mm, the flange root at 6 mm and the flange at 7 mm of a right
    wheel, which at 5 mm touches in two places (the table of positions of docs/method.md)."""
    found = random_poses.zones([pose(shift) for shift in (0.0, 5e-3, 6e-3, 7e-3)])
    right = [random_poses.ZONES[number] for number in found[1::2]]
    assert right == ["tread", "two places", "flange root", "flange"]
    # the left wheels are on the field side of their treads
    assert not found[::2].any()


def test_a_mirrored_pose_changes_the_wheels():
    there, back = random_poses.zones([pose(6e-3), pose(-6e-3)]).reshape(2, 2)
    assert there.tolist() == back[::-1].tolist()
