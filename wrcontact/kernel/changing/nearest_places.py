"""Where a wheel is nearest to its rail along the frame, between the nodes of a pose."""

from ..layout import Sections


def valley_at(sections: Sections, y: float):
    """How far the nearest place lies ahead of the outline [m], the slope of both surfaces along the frame [-] there, and how much
    lower than at the outline both are [m], at the place ``y`` [m] across it."""
    low = sections.first
    high = sections.last
    while high - low > 1:
        middle = (low + high) // 2
        if sections.nodes[middle].y <= y:
            low = middle
        else:
            high = middle
    before = sections.nodes[low]
    behind = sections.nodes[high]
    share = min(max((y - before.y) / (behind.y - before.y), 0.0), 1.0)
    return (
        before.move + share * (behind.move - before.move),
        before.rise + share * (behind.rise - before.rise),
        before.lift + share * (behind.lift - before.lift),
    )
