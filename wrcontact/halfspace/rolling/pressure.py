"""Pressure on the cells of a grid: means over each cell of a patch whose rows are half-ellipses."""

from dataclasses import dataclass

import numpy as np

#: Lines along x in each row of cells on which the pressure is integrated in closed form.
LINES = 8


@dataclass(frozen=True)
class PressureField:
    """Mean pressure of each cell of a rectangular grid.

    Attributes
    ----------
    x : middles of the cells along the rolling direction (nx,), evenly spaced [m].
    y : middles of the cells across it (ny,), evenly spaced [m].
    pressure : mean over a cell (ny, nx) [Pa].
    cover : share of a cell that lies in the patch (ny, nx), 0 ... 1.
    """

    x: np.ndarray
    y: np.ndarray
    pressure: np.ndarray
    cover: np.ndarray

    @classmethod
    def of_cells(cls, x, y, pressure):
        """A field of given cells; every cell with a pressure lies in the patch as a whole.

        Raises
        ------
        ValueError
            if the middles are not evenly spaced, the shapes do not fit, or no pressure is positive.
        """
        x, y, pressure = (np.asarray(each, dtype=float) for each in (x, y, pressure))
        for name, middles in (("x", x), ("y", y)):
            steps = np.diff(middles)
            if len(steps) == 0 or np.ptp(steps) > 1e-6 * abs(steps[0]) or steps[0] <= 0.0:
                raise ValueError(f"{name}: the middles of the cells must rise in equal steps [m]")
        if pressure.shape != (len(y), len(x)):
            raise ValueError(f"pressure: shape {pressure.shape}, expected (ny, nx) = {(len(y), len(x))}")
        if not np.all(np.isfinite(pressure)) or np.any(pressure < 0.0) or not np.any(pressure > 0.0):
            raise ValueError("pressure: expected finite values from 0 Pa up, some of them positive")
        return cls(x, y, pressure, np.where(pressure > 0.0, 1.0, 0.0))

    @property
    def steps(self):
        """(dy, dx), the sides of a cell [m]."""
        return float(self.y[1] - self.y[0]), float(self.x[1] - self.x[0])

    @property
    def cell_area(self):
        """Of the whole cell [m^2]."""
        dy, dx = self.steps
        return dy * dx

    @property
    def normal_force(self):
        """Sum of the pressures [N]."""
        return float(self.pressure.sum() * self.cell_area)

    def scaled(self, normal_force):
        """The same field with another normal force [N]."""
        return PressureField(self.x, self.y, self.pressure * (normal_force / self.normal_force), self.cover)


def _half_ellipse_area(t):
    """Integral of sqrt(1 - t^2) from -1, for t cut to -1 ... 1."""
    t = np.clip(t, -1.0, 1.0)
    return 0.5 * (t * np.sqrt(1.0 - t * t) + np.arcsin(t)) + 0.25 * np.pi


@dataclass(frozen=True)
class Outline:
    """A patch by stations: on each, the pressure is half an ellipse along the rolling direction.

    Between stations the square of the half-length, the line load and the middle are straight lines, as they
    are at the end of an ellipse.  The patch ends at the first and the last station.

    Attributes
    ----------
    station : positions across, rising (n,) [m].
    half_length : half of the patch's length there (n,) [m].
    pressure : largest pressure there (n,) [Pa].
    middle : where its middle lies along the rolling direction (n,) [m].
    """

    station: np.ndarray
    half_length: np.ndarray
    pressure: np.ndarray
    middle: np.ndarray

    @classmethod
    def of_stations(cls, station, half_length, pressure, middle=0.0):
        """An outline from arrays (n,); ``middle`` may be one number.

        Raises
        ------
        ValueError
            if the stations do not rise, or a half-length or pressure is negative or not finite.
        """
        station = np.asarray(station, dtype=float)
        values = [
            np.broadcast_to(np.asarray(each, dtype=float), station.shape)
            for each in (half_length, pressure, middle)
        ]
        if station.ndim != 1 or len(station) < 3 or not np.all(np.diff(station) > 0.0):
            raise ValueError("station: expected three or more rising positions [m]")
        for name, value in zip(("half_length", "pressure"), values):
            if not np.all(np.isfinite(value)) or np.any(value < 0.0) or not np.any(value > 0.0):
                raise ValueError(f"{name}: expected finite values from 0 up, some of them positive")
        return cls(station, *values)

    @classmethod
    def of_ellipse(cls, half_length, half_width, normal_force, stations=401):
        """Hertz's ellipse; half-axes along and across the rolling direction [m], force [N]."""
        angle = np.linspace(-0.5 * np.pi, 0.5 * np.pi, stations)
        share = np.cos(angle)
        largest = 1.5 * normal_force / (np.pi * half_length * half_width)
        ellipse = cls(half_width * np.sin(angle), half_length * share, largest * share, np.zeros(stations))
        return ellipse.scaled(normal_force)  # straight lines between the stations lose 1e-5 of it

    def at(self, y):
        """Half-length [m], largest pressure [Pa] and middle [m] at positions y (n,) [m]."""
        square = np.interp(y, self.station, self.half_length**2, left=0.0, right=0.0)
        load = np.interp(y, self.station, self.half_length * self.pressure, left=0.0, right=0.0)
        half_length = np.sqrt(square)
        return (
            half_length,
            np.divide(load, half_length, out=np.zeros_like(y), where=half_length > 0.0),
            np.interp(y, self.station, self.middle),
        )

    @property
    def normal_force(self):
        """Integral of the pressure [N]."""
        return float(0.5 * np.pi * np.trapezoid(self.half_length * self.pressure, self.station))

    def scaled(self, normal_force):
        """The same outline with another normal force [N]."""
        return Outline(
            self.station, self.half_length, self.pressure * (normal_force / self.normal_force), self.middle
        )

    def box(self):
        """(x low, x high, y low, y high) around the loaded part [m]."""
        loaded = np.flatnonzero(self.half_length > 0.0)
        low, high = max(loaded[0] - 1, 0), min(loaded[-1] + 1, len(self.station) - 1)
        inside = slice(loaded[0], loaded[-1] + 1)
        return (
            float((self.middle - self.half_length)[inside].min()),
            float((self.middle + self.half_length)[inside].max()),
            float(self.station[low]),
            float(self.station[high]),
        )

    def on_grid(self, columns, rows):
        """The :class:`PressureField` on a grid that just holds the patch; the normal force is kept.

        Along x the half-ellipses are integrated in closed form, across by LINES lines in each row.
        """
        x_low, x_high, y_low, y_high = self.box()
        edges = np.linspace(x_low, x_high, columns + 1)
        dy = (y_high - y_low) / rows
        lines = y_low + (np.arange(rows * LINES) + 0.5) * dy / LINES
        half_length, largest, middle = self.at(lines)
        length = np.where(half_length > 0.0, half_length, 1.0)[:, None]
        relative = (edges - middle[:, None]) / length
        dx = edges[1] - edges[0]
        pressure = np.diff(_half_ellipse_area(relative), axis=1) * length * largest[:, None] / dx
        cover = np.diff(np.clip(relative, -1.0, 1.0), axis=1) * half_length[:, None] / dx
        pressure, cover = (each.reshape(rows, LINES, columns).mean(axis=1) for each in (pressure, cover))
        field = PressureField(
            0.5 * (edges[1:] + edges[:-1]), y_low + (np.arange(rows) + 0.5) * dy, pressure, cover
        )
        return field.scaled(self.normal_force)
