"""The constant rail that a changing one is at a pose, against the smallest gap along the frame by brute force."""

import numpy as np
import pytest

from tests.helpers.sections import moved, nose, stepped, stepper_on, waves
from wrcontact import ContactSystem
from wrcontact.kernel import layout
from wrcontact.kernel.changing.nearest_places import valley_at
from wrcontact.profiles.compiled import evaluate_table

RADIUS = 0.46
CASES = {
    "nose": (
        lambda: nose(np.linspace(-0.1, 0.1, 21)),
        0.75,
        dict(track_position=0.01, lateral_shift=-1e-3, yaw=0.01),
    ),
    "waves": (waves, 0.75, dict(track_position=0.31, lateral_shift=2e-3, yaw=-8e-3)),
    "ramp": (
        lambda: moved(np.linspace(-0.3, 0.6, 9), 0.03, 0.02),
        None,
        dict(track_position=0.1, lateral_shift=3e-3),
    ),
}


class InFrame:
    """The right wheel and its rail after a step of a compliant wheelset, in the frame of the step."""

    def __init__(self, system, rail, lateral, inputs, stepper):
        tables = layout.Tables.at(stepper._tables)
        self.system, self.rail, self.lateral, self.inputs = system, rail, lateral, inputs
        self.pair, self.arm, self.centre_height = tables.pairs[1], tables.arm, tables.height
        frame = self.pair.sections.frame
        self.axes = np.array([frame.along[:], frame.aside[:], frame.down[:]])
        self.origin = np.array([frame.x, frame.y, frame.z])
        first, last = (layout.offset(part, tables) for part in (self.pair.rail, self.pair.rail_arc))
        self.rail_table = stepper._tables[first:last].copy()

    def wheel(self, y, angle):
        """Places (3, ...) in the frame of the wheel at abscissae and angles."""
        yaw, roll = self.inputs.get("yaw", 0.0), self.inputs["roll_input"]
        c, s = np.cos(yaw), np.sin(yaw)
        turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]) @ np.array(
            [[1.0, 0.0, 0.0], [0.0, np.cos(roll), -np.sin(roll)], [0.0, np.sin(roll), np.cos(roll)]]
        )
        r = RADIUS + evaluate_table(self.system.profile_tables()[0], y)[0]
        centre = np.array(
            [0.0, self.inputs["lateral_shift"], self.inputs["vertical_shift_input"] - self.centre_height]
        )
        at = np.tensordot(turn, np.stack([r * np.sin(angle), self.arm + y, r * np.cos(angle)]), 1)
        return np.tensordot(self.axes, (at.T + centre - self.origin).T, 1)

    def rail_height(self, x, y):
        """Height in the frame of the rail at places of the frame, by a chord in each step."""
        z = 0.0 * x
        for _ in range(40):
            u, across, down = np.tensordot(self.axes.T, np.stack([x, y, z]), 1) + self.origin[:, None]
            off = self.rail.surface.jet(u + self.inputs["track_position"], across - self.lateral)[0] - down
            z = z + off
            if np.abs(off).max() < 1e-13:
                break
        return z

    def gap(self, across, near):
        """The smallest gap along the frame at the place ``across``, and where; by angles around the wheel, each set finer."""
        low, high, count = -0.25, 0.25, 41
        for _ in range(6):
            angle = np.linspace(low, high, count)
            y = self.abscissa(across, near, angle)
            x, _, z = self.wheel(y, angle)
            gap = self.rail_height(x, np.full(count, across)) - z
            k = int(np.argmin(gap))
            low, high = angle[max(k - 1, 0)], angle[min(k + 1, count - 1)]
        return gap[k], x[k]

    def abscissa(self, across, near, angle):
        """Wheel abscissae at which angles (n,) have the place ``across``, by secants from ``near``."""
        y = np.full(len(angle), near)
        for _ in range(30):
            beside = self.wheel(y, angle)[1]
            move = (beside - across) / ((self.wheel(y + 1e-7, angle)[1] - beside) / 1e-7)
            y = y - move
            if np.abs(move).max() < 1e-13:
                break
        return y


@pytest.mark.parametrize(
    "name", [name if name == "waves" else pytest.param(name, marks=pytest.mark.full) for name in CASES]
)
def test_it_has_the_smallest_gap_along_the_rail(name):
    """At lines of the rail and between them; along a rail that twists the nearest places leave the wheel's outline."""
    make, lateral, inputs = CASES[name]
    rail, system = make(), ContactSystem(rail_inclination=0.0, contact_mode="compliant")
    lateral = system.profile_tables()[2] if lateral is None else lateral
    rigid = stepper_on(ContactSystem(rail_inclination=0.0), rail, lateral=lateral)
    status, touching = stepped(rigid, **inputs)
    assert status == 0
    inputs = inputs | {
        "roll_input": touching["roll"],
        "vertical_shift_input": touching["vertical_shift"] + 5e-5,
    }
    stepper = stepper_on(system, rail, lateral=lateral)
    status, found = stepped(stepper, **inputs)
    assert status == 0
    at = InFrame(system, rail, lateral, inputs, stepper)
    sections, moved_most = at.pair.sections, 0.0
    nodes = [sections.nodes[k] for k in range(sections.first, sections.last + 1)]
    near = [node for node in nodes if abs(node.y) < 8e-3]
    assert len(near) > 10
    for node in near[:: len(near) // 8]:
        gap, x = at.gap(node.y, node.wheel)
        assert node.gap == pytest.approx(gap, abs=2e-10), node.y
        moved_most = max(moved_most, abs(node.move))
    for before, behind in list(zip(near, near[1:]))[:: len(near) // 6]:
        y = 0.5 * (before.y + behind.y)
        height = evaluate_table(at.rail_table, np.array([y]))[0][0]
        # the outline there, whose places are the highest of the wheel along the frame
        angle = np.linspace(-0.2, 0.2, 2001)
        places = at.abscissa(y, 0.5 * (before.wheel + behind.wheel), angle)
        down = at.wheel(places, angle)[2]
        k = int(np.argmax(down))
        a, b, c = np.polyfit(angle[k - 2 : k + 3] - angle[k], down[k - 2 : k + 3], 2)
        outline = c - b * b / (4.0 * a)
        gap, x = at.gap(y, places[k])
        assert height - outline == pytest.approx(gap, abs=5e-9), y
        # between the nodes, 0.4 mm apart, these are taken to be straight, which is within 2e-8 of them
        top = np.array([angle[k] - b / (2.0 * a)])
        x_outline = at.wheel(at.abscissa(y, places[k], top), top)[0][0]
        rail = [at.rail_height(np.array([x + way]), np.array([y]))[0] for way in (0.0, -1e-5, 1e-5)]
        move, rise, lift = valley_at(sections, y)
        assert move == pytest.approx(x - x_outline, abs=1e-7), y
        assert rise == pytest.approx((rail[2] - rail[1]) / 2e-5, abs=1e-7), y
        assert lift == pytest.approx(rail[0] - gap - outline, abs=5e-8), y
    assert (moved_most > 1e-4) == (name == "waves")
