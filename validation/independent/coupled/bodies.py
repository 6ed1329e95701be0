"""Rigid bodies in the plane, with different added masses in surge and sway."""

import math

from .polygons import edges
from .quantities import si


class Body:
    """A rigid body in the plane. Forces change its `momentum` and `spin`."""

    def __init__(self, name, table):
        self.name = name
        self.outline = [(si(x), si(y)) for x, y in table["outline"]]
        if sum(a[0] * b[1] - a[1] * b[0] for a, b in edges(self.outline)) < 0.0:
            self.outline.reverse()
        self.x, self.y = (si(value) for value in table.get("position", (0.0, 0.0)))
        self.heading = si(table.get("heading", 0.0))
        self.fixed = table.get("fixed", False)
        self.vx = self.vy = self.rate = 0.0
        if not self.fixed:
            added = table.get("added_mass", {})
            mass = si(table["mass"])
            self.surge_mass = mass * (1.0 + si(added.get("surge", 0.0)))
            self.sway_mass = mass * (1.0 + si(added.get("sway", 0.0)))
            self.inertia = mass * si(table["gyradius"]) ** 2 * (1.0 + si(added.get("yaw", 0.0)))
        self.turn_axes()
        speeds = {key: si(value) for key, value in table.get("velocity", {}).items()}
        u, v = speeds.get("surge", 0.0), speeds.get("sway", 0.0)
        self.rate = speeds.get("yaw", 0.0)
        if not self.fixed:
            pu, pv = self.surge_mass * u, self.sway_mass * v
            self.px, self.py = self.cos * pu - self.sin * pv, self.sin * pu + self.cos * pv
            self.spin = self.inertia * self.rate
            self.set_velocity()

    def turn_axes(self):
        """Updates all that depends on the heading: cosine and sine, and the inverse mass matrix in earth-fixed axes."""
        c, s = self.cos, self.sin = math.cos(self.heading), math.sin(self.heading)
        if not self.fixed:
            a, b = 1.0 / self.surge_mass, 1.0 / self.sway_mass
            self.ixx, self.ixy, self.iyy = a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c
            self.irr = 1.0 / self.inertia
        else:
            self.ixx = self.ixy = self.iyy = self.irr = 0.0

    def set_velocity(self):
        self.vx = self.ixx * self.px + self.ixy * self.py
        self.vy = self.ixy * self.px + self.iyy * self.py
        self.rate = self.irr * self.spin

    def to_earth(self, point):
        return (self.x + self.cos * point[0] - self.sin * point[1], self.y + self.sin * point[0] + self.cos * point[1])

    def to_own(self, point):
        dx, dy = point[0] - self.x, point[1] - self.y
        return (self.cos * dx + self.sin * dy, self.cos * dy - self.sin * dx)

    def own_speeds(self):
        """Surge and sway [m/s], yaw rate [rad/s]."""
        return self.cos * self.vx + self.sin * self.vy, self.cos * self.vy - self.sin * self.vx, self.rate

