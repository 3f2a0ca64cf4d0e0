"""Bounds of the surface's derivatives, against samples between those that they were made of, and the kernel's surface
against the one of Python."""

import warnings

import numpy as np
import pytest

from tests.helpers.sections import moved, nose, waves
from wrcontact import ProfileWarning
from wrcontact.kernel import layout
from wrcontact.kernel.sections.section_bounds import section_bounds
from wrcontact.kernel.sections.section_surface import section_edges, section_jet
from wrcontact.sections.kernel_table import section_table


def quietly(made):
    """What is ``made``, without what is told of it."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ProfileWarning)
        return made()


RAILS = {
    "nose": lambda: nose(np.linspace(-0.1, 0.1, 21)),
    "moving": lambda: moved(np.linspace(-0.1, 0.1, 4), rate=0.1, rise=0.02),
    "waves": lambda: quietly(waves),
}


@pytest.fixture(scope="module", params=RAILS)
def rail(request):
    made = RAILS[request.param]()
    table = section_table(made.surface)
    return made, table, layout.Sections.at(table)


def test_bounds_hold_between_the_samples(rail):
    """Of parts of many sizes, also beyond the slices."""
    made, _, sections = rail
    generator, found = np.random.default_rng(5), layout.SectionBounds.from_buffer(np.zeros(12))
    names = ("along", "across", "bend_along", "twist", "bend_across", "lean")
    for _ in range(300):
        u, half = generator.uniform(-0.15, 0.65), 10.0 ** generator.uniform(-5.0, -1.0)
        y, wide = generator.uniform(*made.edges(u)), 10.0 ** generator.uniform(-6.0, -2.5)
        section_bounds(sections, found, u - half, u + half, y - wide, y + wide)
        at = generator.uniform([u - half, y - wide], [u + half, y + wide], (200, 2)).T
        at = at[:, (at[1] > sections.across_start) & (at[1] < sections.across_stop)]
        _, z_u, z_y, z_uu, z_uy, z_yy, _, _ = made.surface.jet(*at)
        lean = -z_u / np.sqrt(1.0 + z_u**2 + z_y**2)
        for name, values in zip(names, (z_u, z_y, z_uu, z_uy, z_yy, lean)):
            low, high = getattr(found, f"least_{name}"), getattr(found, f"most_{name}")
            assert (values >= low).all() and (values <= high).all(), (name, u, half, y, wide)


def test_bounds_of_small_parts_are_close(rail):
    """Within 10 mm along and 1 mm across the middle of the head: those of its own curvature."""
    made, _, sections = rail
    found = layout.SectionBounds.from_buffer(np.zeros(12))
    middle = float(np.mean(made.edges(0.0)))
    section_bounds(sections, found, -5e-3, 5e-3, middle - 5e-4, middle + 5e-4)
    y = np.linspace(middle - 2e-3, middle + 2e-3, 401)
    bend = made.evaluate(0.0, y)["z_yy"]
    assert bend.min() - 0.1 * np.ptp(bend) - 1.0 < found.least_bend_across
    assert found.most_bend_across < bend.max() + 0.1 * np.ptp(bend) + 1.0


def test_the_kernel_reads_the_surface(rail):
    made, _, sections = rail
    generator = np.random.default_rng(6)
    for _ in range(300):
        u = generator.uniform(-0.2, 0.7)
        first, last = (float(edge) for edge in made.edges(u))
        y = generator.uniform(first - 4e-3, last + 4e-3)
        own, other = np.array(section_jet(sections, u, y)), made.surface.jet(u, y)[:6]
        assert own == pytest.approx(other, rel=1e-9, abs=1e-9), (u, y)
        assert section_edges(sections, u) == pytest.approx((first, last), abs=1e-15)


def test_the_highest_place_is_not_lower_than_any(rail):
    made, _, sections = rail
    u, y = np.meshgrid(np.linspace(-0.15, 0.65, 201), np.linspace(-0.05, 0.05, 2001))
    height = made.height(u, y)
    assert -1e-4 < sections.top - np.nanmin(height) <= 0.0
