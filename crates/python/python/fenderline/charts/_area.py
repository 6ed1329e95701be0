"""The area that is cut out, and the origin of the scenario in it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from fenderline.charts._errors import ChartError

EARTH_M = 6_371_000.0
"""Radius of the earth, for sizes in words (m)."""

LARGEST_M = 200_000.0
"""Largest side of an area: the program refuses places that are farther from the origin (m)."""


@dataclass(frozen=True)
class Area:
    """A rectangle of longitude and latitude on WGS 84 (degrees)."""

    west: float
    south: float
    east: float
    north: float

    @classmethod
    def of(cls, text: str) -> Area:
        """An area from ``"W,S,E,N"``, in degrees.

        >>> Area.of("-76.47,38.97,-76.43,39.00").east
        -76.43
        """
        parts = text.split(",")
        try:
            numbers = [float(part) for part in parts]
        except ValueError:
            numbers = []
        if len(numbers) != 4 or not all(math.isfinite(number) for number in numbers):
            raise ChartError(f"the area is west, south, east, north in degrees, such as -76.47,38.97,-76.43,39.00, but is {text!r}")
        return cls(*numbers).checked()

    def checked(self) -> Area:
        """The area itself, if it is one."""
        west, south, east, north = self.bounds
        if not (-180 <= west <= 180 and -180 <= east <= 180 and -84 <= south <= 84 and -84 <= north <= 84):
            raise ChartError(f"the area {self} is not west, south, east, north in degrees: longitudes are within 180, latitudes within 84")
        if west >= east or south >= north:
            raise ChartError(f"the area {self} is empty: it is west, south, east, north")
        if max(self.size_m) > LARGEST_M:
            raise ChartError(f"the area {self} is larger than {LARGEST_M / 1e3:.0f} km")
        return self

    @property
    def bounds(self) -> tuple[float, float, float, float]:
        """West, south, east, north (degrees)."""
        return self.west, self.south, self.east, self.north

    @property
    def origin(self) -> tuple[float, float]:
        """Latitude and longitude of the scenario's origin: the middle of the area (degrees)."""
        return round((self.south + self.north) / 2, 4), round((self.west + self.east) / 2, 4)

    @property
    def size_m(self) -> tuple[float, float]:
        """Extent to the north and to the east, about (m)."""
        per_degree = math.radians(1.0) * EARTH_M
        return (self.north - self.south) * per_degree, (self.east - self.west) * per_degree * math.cos(math.radians(self.origin[0]))

    def __str__(self) -> str:
        return ",".join(f"{degrees:g}" for degrees in self.bounds)
