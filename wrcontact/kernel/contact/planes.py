"""Frames that are set aside: every region of a pressed wheel beside the contact point's has its own, at its
deepest point."""

from ..layout import FRAME_SIZE, REGION_LIMIT, Frame, KeptFrames, Region, Regions, Tables, seldom
from ..surface.locus import outline_x


@seldom
def keep_frame(frame: Frame, frames: KeptFrames, slot: int):
    """Keep the open frame for region ``slot``; REGION_LIMIT is the contact point's."""
    kept = frames[slot]
    for i in range(FRAME_SIZE):
        kept[i] = frame[i]


@seldom
def use_frame(frame: Frame, frames: KeptFrames, slot: int):
    """Open the frame that was kept for ``slot``."""
    kept = frames[slot]
    for i in range(FRAME_SIZE):
        frame[i] = kept[i]


@seldom
def locate_along_track(tables: Tables, frame: Frame, regions: Regions, count: int):
    """Note where along the track every region lies: of a yawed wheel, a flange is some 20 mm ahead of the
    flange root."""
    for index in range(count):
        region = regions[index]
        region.x_track = outline_x(tables, frame.place, region.wheel)


@seldom
def enter_plane(frame: Frame, frames: KeptFrames, region: Region, slot: int):
    """Open the frame of a region with its own plane, kept in ``slot``."""
    if region.own:
        use_frame(frame, frames, slot)


@seldom
def leave_plane(frame: Frame, frames: KeptFrames, region: Region):
    """Open the contact point's frame again."""
    if region.own:
        use_frame(frame, frames, REGION_LIMIT)
