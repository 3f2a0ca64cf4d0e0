"""Overlap of the wheel as a surface of revolution with the rail, by dense search."""

import numpy as np


def overlap(track, pose, x, abscissa, iterations=40):
    """How deep the right wheel is below the rail's point at ``abscissa`` and ``x`` along the track
    [m], along the rail's normal, broadcast; the wheel is the surface of revolution hypot(q_x, q_z) =
    R_0 + z(q_y), by Newton's method."""
    z, slope, _ = track.rail(abscissa)
    cosine = 1 / np.sqrt(1 + slope**2)
    turn = pose.rotation()
    start = np.stack(np.broadcast_arrays(x, track.rail_origin + abscissa, z), axis=-1) - pose.centre(track)
    along = np.stack(np.broadcast_arrays(0 * x, -slope * cosine, cosine), axis=-1)
    start, along = start @ turn, along @ turn
    depth = np.zeros(start.shape[:-1])
    for _ in range(iterations):
        q = start + depth[..., None] * along
        height, slope, _ = track.wheel(q[..., 1] - track.half_distance)
        distance = np.hypot(q[..., 0], q[..., 2])
        rate = slope * along[..., 1] - (q[..., 0] * along[..., 0] + q[..., 2] * along[..., 2]) / distance
        move = np.clip(-(track.nominal_radius + height - distance) / rate, -2e-3, 2e-3)
        depth = depth + move
    return np.where(np.abs(move) < 1e-10, depth, -1.0)


def deepest(track, pose, near, reach=1.5e-3, levels=9, iterations=40):
    """Largest overlap, x and abscissa [m] within ``reach`` of the rail's abscissa ``near``:
    grids of ever smaller cells."""
    x, y, wide, high = 0.0, near, 0.06, reach
    for _ in range(levels):
        grid_x, grid_y = x + np.linspace(-wide, wide, 41)[:, None], y + np.linspace(-high, high, 41)[None, :]
        depth = overlap(track, pose, grid_x, grid_y, iterations)
        i, j = np.unravel_index(np.argmax(depth), depth.shape)
        x, y, wide, high = grid_x[i, 0], grid_y[0, j], wide / 5, high / 5
    return depth[i, j], x, y
