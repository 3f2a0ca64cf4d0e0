"""Results of an evaluation: names for the kernel's output array, for one pose or for a table of poses."""

import numpy as np

from .kernel import layout


class _View:
    """Named values of an output array (276,) or (n, 276), longer if outlines follow, starting at ``offset``."""

    __slots__ = ("_values", "_offset")

    def __init__(self, values, offset):
        self._values = values
        self._offset = offset

    def __repr__(self):
        names = [name for name in dir(type(self)) if not name.startswith("_")]
        return f"{type(self).__name__}({', '.join(f'{name}={getattr(self, name)!r}' for name in names)})"


def _number(value):
    """A float for one pose, an array (n,) for a table."""
    return float(value) if value.ndim == 0 else value


def _place(offset, unit, text):
    """A property for one value at ``offset``: a float, or (n,) for a table."""

    def read(self):
        return _number(self._values[..., self._offset + offset])

    return property(read, doc=f"{text} [{unit}].")


def _run(number, unit, text):
    """A property for array ``number`` of an outline: (stations,), or (n, stations) for a table."""

    def read(self):
        stations = station_count(self._values)
        start = self._offset + number * stations
        return self._values[..., start:start + stations]

    return property(read, doc=f"{text} [{unit}], one value per station.")


def station_count(values):
    """The number of stations in outlines of this output array."""
    behind = values.shape[-1] - layout.OUTPUT_COUNT
    return behind // 6 if behind else layout.STATION_COUNT


def outline_of(values, first):
    """Stations, half-lengths and pressures (3, stations) of the side of one pose whose outputs begin at ``first``."""
    start, stations = outline_offset(values, first), station_count(values)
    return values[start:start + 3 * stations].reshape(3, stations)


def outline_offset(values, first):
    """Offset of the outline of the side whose outputs begin at ``first``; kernel/patch/outline.py defines the layout."""
    if values.shape[-1] == layout.OUTPUT_COUNT:
        return first + layout.SIDE_STATION
    return layout.OUTPUT_COUNT + (3 * station_count(values) if first == layout.OUT_RIGHT else 0)


class Vector(_View):
    """Three components in the track's axes: x forward, y to the right, z down."""

    __slots__ = ()
    x = _place(0, "N or N m", "component forward")
    y = _place(1, "N or N m", "component to the right")
    z = _place(2, "N or N m", "component down")


class Contact(_View):
    """The contact point of one wheel, in the wheel's, the rail's and the track's frame (wrcontact/conventions.py)."""

    __slots__ = ()
    x_wheel = _place(layout.SIDE_X_WHEEL, "m", "ahead of the wheel's principal profile")
    y_wheel = _place(layout.SIDE_Y_WHEEL, "m", "on the wheel profile, positive to the field side")
    z_wheel = _place(layout.SIDE_Z_WHEEL, "m", "below the running circle")
    y_rail = _place(layout.SIDE_Y_RAIL, "m", "on the rail profile, positive to the field side")
    z_rail = _place(layout.SIDE_Z_RAIL, "m", "below the rail's highest point")
    x_track = _place(layout.SIDE_X_TRACK, "m", "along the track")
    y_track = _place(layout.SIDE_Y_TRACK, "m", "across the track, positive to the right")
    z_track = _place(layout.SIDE_Z_TRACK, "m", "below top of rail")


class Patch(_View):
    """One contact patch."""

    __slots__ = ()
    normal_force = _place(layout.PATCH_NORMAL_FORCE, "N", "its share of the wheel's normal force")
    area = _place(layout.PATCH_AREA, "m^2", "area")
    max_pressure = _place(layout.PATCH_MAX_PRESSURE, "Pa", "largest pressure")
    length = _place(layout.PATCH_LENGTH, "m", "largest extent along the track")
    width = _place(layout.PATCH_WIDTH, "m", "extent across, in the contact plane")
    centroid = _place(layout.PATCH_CENTROID, "m", "centre of pressure, station in the contact plane")
    contact_angle = _place(layout.PATCH_CONTACT_ANGLE, "rad", "angle of the rail at its smallest gap (half-space: at its "
                           "centroid), positive towards the flange")


class Outline(_View):
    """Outline and pressure at evenly spaced stations across, from the first loaded place to the last."""

    __slots__ = ()
    station = _run(0, "m", "lateral coordinate in the contact plane, positive to the field side")
    half_length = _run(1, "m", "half the patch's length along the track")
    pressure = _run(2, "Pa", "pressure on the patch's centre line")


class Side(_View):
    """One wheel on its rail."""

    __slots__ = ()
    contact_angle = _place(layout.SIDE_CONTACT_ANGLE, "rad", "angle of the contact plane, positive towards the flange")
    rolling_radius = _place(layout.SIDE_ROLLING_RADIUS, "m", "radius of the wheel profile at the contact point")
    curvature_x = _place(layout.SIDE_CURVATURE_X, "1/m", "relative longitudinal curvature 1/R_x at the contact point")
    curvature_y = _place(layout.SIDE_CURVATURE_Y, "1/m", "relative lateral curvature 1/R_y at the contact point")
    penetration = _place(layout.SIDE_PENETRATION, "m", "approach of the bodies")
    normal_force = _place(layout.SIDE_NORMAL_FORCE, "N", "sum over the patches")
    area = _place(layout.SIDE_AREA, "m^2", "area of all patches")
    max_pressure = _place(layout.SIDE_MAX_PRESSURE, "Pa", "largest pressure of all patches")
    patch_length = _place(layout.SIDE_PATCH_LENGTH, "m", "largest extent along the track")
    patch_width = _place(layout.SIDE_PATCH_WIDTH, "m", "extent from the first loaded station to the last")
    patch_centroid = _place(layout.SIDE_PATCH_CENTROID, "m", "centre of pressure, station in the contact plane")

    @property
    def patch_count(self):
        """Number of patches; ``patches`` has the three with the largest load."""
        count = self._values[..., self._offset + layout.SIDE_PATCH_COUNT]
        if count.ndim:
            return count
        return int(count) if np.isfinite(count) else 0

    @property
    def contact(self):
        """The contact point."""
        return Contact(self._values, self._offset)

    @property
    def patches(self):
        """Patches by decreasing load; in a table always three, with zeros for missing ones."""
        start, size = self._offset + layout.SIDE_PATCH, layout.PATCH_SIZE
        count = layout.PATCH_LIMIT if self._values.ndim > 1 else min(self.patch_count, layout.PATCH_LIMIT)
        return tuple(Patch(self._values, start + size * k) for k in range(count))

    @property
    def outline(self):
        """Outline and pressure over the loaded width."""
        return Outline(self._values, outline_offset(self._values, self._offset))


class WheelsetState:
    """Result of an evaluation: ``status``, ``roll`` [rad], ``vertical_shift`` [m, positive down], ``left``, ``right``.

    ``force`` [N] and ``moment`` about the wheelset's centre [N m] are the resultant of the contact forces on the wheelset.
    ``inputs`` are the seven inputs and ``values`` the kernel's outputs; all are (n, ...) for a table.
    """

    __slots__ = ("values", "status", "inputs")

    def __init__(self, values, status, inputs):
        self.values = values
        self.status = status
        self.inputs = inputs

    @property
    def roll(self):
        """Roll of the wheelset [rad], right wheel down positive."""
        return _number(self.values[..., layout.OUT_ROLL])

    @property
    def vertical_shift(self):
        """Vertical shift of the wheelset [m], positive down."""
        return _number(self.values[..., layout.OUT_VERTICAL_SHIFT])

    @property
    def force(self):
        """Resultant of the normal contact forces on the wheelset [N]."""
        return Vector(self.values, layout.OUT_FORCE)

    @property
    def moment(self):
        """Their moment about the wheelset's centre [N m]."""
        return Vector(self.values, layout.OUT_MOMENT)

    @property
    def left(self):
        """The left wheel."""
        return Side(self.values, layout.OUT_LEFT)

    @property
    def right(self):
        """The right wheel."""
        return Side(self.values, layout.OUT_RIGHT)

    def __len__(self):
        if self.values.ndim == 1:
            raise TypeError("the state of one pose has no length")
        return len(self.values)

    def __repr__(self):
        if self.values.ndim > 1:
            return f"WheelsetState({len(self.values)} poses)"
        return (f"WheelsetState(status={self.status!r}, roll={self.roll:.6g} rad, "
                f"vertical_shift={self.vertical_shift:.6g} m)")
