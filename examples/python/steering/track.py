"""A track of waypoints, and an autopilot that keeps a ship on it with the rudder.

The autopilot knows what a bridge knows: position, heading, rate of turn, course and speed over ground. It steers to
the course of the track, less the drift angle that it estimates, plus an angle towards the track; in turns it leads.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

Place = tuple[float, float]
"""North and east (m)."""


def wrapped(angle_rad: float) -> float:
    """The same direction from −π up to π."""
    return math.remainder(angle_rad, 2 * math.pi)


def course(start: Place, end: Place) -> float:
    """Course from one place to another (rad)."""
    return math.atan2(end[1] - start[1], end[0] - start[0])


@dataclass(frozen=True)
class Leg:
    """A part of a track: a straight line, or an arc where ``curvature`` is not 0."""

    start: Place
    course_rad: float
    curvature: float
    """Change of course along the leg, positive to starboard (rad/m)."""
    length_m: float

    def beside(self, place: Place) -> tuple[float, float]:
        """How far a place is along the leg from its start, and to starboard of it (m)."""
        north, east = place[0] - self.start[0], place[1] - self.start[1]
        ahead = north * math.cos(self.course_rad) + east * math.sin(self.course_rad)
        right = east * math.cos(self.course_rad) - north * math.sin(self.course_rad)
        if self.curvature == 0:
            return ahead, right
        # From the middle of the arc, which lies abeam.
        radius = 1 / self.curvature
        swept = math.atan2(ahead, radius - right) if radius > 0 else math.atan2(ahead, right - radius)
        return swept * abs(radius), math.copysign(1, radius) * (abs(radius) - math.hypot(ahead, radius - right))

    def course_at(self, along_m: float) -> float:
        """Course of the leg at a distance from its start (rad)."""
        return self.course_rad + self.curvature * along_m


class Track:
    """Legs and arcs through waypoints, each with the radius of its turn (m)."""

    def __init__(self, waypoints: list[Place], radius_m: float) -> None:
        self.legs: list[Leg] = []
        start = waypoints[0]
        for before, at, after in zip(waypoints, waypoints[1:], waypoints[2:], strict=False):
            turn = wrapped(course(at, after) - course(before, at))
            back_m = radius_m * math.tan(abs(turn) / 2)
            way = course(before, at)
            begin = (at[0] - back_m * math.cos(way), at[1] - back_m * math.sin(way))
            self.legs.append(Leg(start, way, 0.0, math.dist(start, begin)))
            if turn != 0:
                self.legs.append(Leg(begin, way, math.copysign(1 / radius_m, turn), radius_m * abs(turn)))
            way = course(at, after)
            start = (at[0] + back_m * math.cos(way), at[1] + back_m * math.sin(way))
        self.legs.append(Leg(start, course(*waypoints[-2:]), 0.0, math.dist(start, waypoints[-1])))
        self._now = 0

    def beside(self, place: Place) -> tuple[float, float]:
        """Where a ship is that goes along the track: the distance from its start, and to starboard of it (m)."""
        while True:
            leg = self.legs[self._now]
            along, right = leg.beside(place)
            if along < leg.length_m or self._now + 1 == len(self.legs):
                return self.length_to(self._now) + along, right
            self._now += 1

    def length_to(self, index: int) -> float:
        """Distance of the start of a leg from the start of the track (m)."""
        return sum(leg.length_m for leg in self.legs[:index])

    def _leg_at(self, along_m: float) -> tuple[Leg, float]:
        for leg in self.legs[:-1]:
            if along_m < leg.length_m:
                return leg, along_m
            along_m -= leg.length_m
        return self.legs[-1], along_m

    def course_at(self, along_m: float) -> float:
        """Course at a distance from the start (rad)."""
        leg, along_m = self._leg_at(along_m)
        return leg.course_at(along_m)

    def curvature_at(self, along_m: float) -> float:
        """Change of course at a distance from the start, positive to starboard (rad/m)."""
        return self._leg_at(along_m)[0].curvature

    @property
    def length_m(self) -> float:
        """Length of the track (m)."""
        return sum(leg.length_m for leg in self.legs)

    def polyline(self, step_m: float) -> list[Place]:
        """Places on the track at equal distances."""
        places = []
        for leg in self.legs:
            count = max(1, round(leg.length_m / step_m))
            places += [_on(leg, leg.length_m * index / count) for index in range(count)]
        return [*places, _on(self.legs[-1], self.legs[-1].length_m)]


def _on(leg: Leg, along_m: float) -> Place:
    half = leg.curvature * along_m / 2
    chord = along_m if half == 0 else along_m * math.sin(half) / half
    way = leg.course_rad + half
    return leg.start[0] + chord * math.cos(way), leg.start[1] + chord * math.sin(way)


@dataclass(frozen=True)
class Seen:
    """What the instruments show."""

    t_s: float
    position_m: Place
    heading_rad: float
    turn_radps: float
    velocity_mps: Place
    """Over ground, north and east."""
    log_mps: float
    """Speed ahead through the water."""


@dataclass(frozen=True)
class Bend:
    """A track as a ship can follow it."""

    way: float
    """Course (rad)."""
    curvature: float
    """Change of course, positive to starboard (rad/m)."""
    change: float
    """Change of the curvature (rad/m²)."""


@dataclass
class TrackPilot:
    """An autopilot that keeps a track; :meth:`rudder` is to be called about once a second."""

    track: Track
    length_m: float
    """Length of the ship."""
    stop_rad: float = math.radians(25)
    """Largest rudder angle that the autopilot uses."""
    gain: float = 5.0
    """Rudder angle for an angle off the wanted heading."""
    rate_gain_lengths: float = 6.0
    """Rate gain: the time in which the ship sails this many lengths."""
    integral_s: float = 300.0
    """Integral time of the rudder angle that holds the ship against a steady moment of the wind."""
    lookahead_lengths: float = 2.0
    """Distance ahead at which the ship aims for the track."""
    drift_s: float = 30.0
    """Time over which the drift is averaged."""
    bend_lengths: float = 1.5
    """Length of track over which the rate of turn grows from nothing at the start of a bend."""
    lead_lengths: float = 0.15
    """How far ahead the rudder is ordered for: the steering gear takes its time."""
    pivot_lengths: float = 0.5
    """Place about which the ship turns, ahead of her middle: in a turn, she slides outwards."""
    slide_lengths: float = 0.6
    """Length that she sails until she slides, and until she slides no longer."""
    turn_gain: float = 1.6
    """Rate of turn for a rudder angle, in lengths a ship's length: K of Nomoto's model times length over speed."""
    turn_time_lengths: float = 5.0
    """T of Nomoto's model, in the time for a length."""
    cross_track_m: float = 0.0
    """Distance to starboard of the track."""
    drift_mps: Place = (0.0, 0.0)
    """The estimated drift by stream and wind, north and east."""
    _held: float = field(default=0.0, repr=False)
    _slide_mps: float = field(default=0.0, repr=False)
    _before: float | None = field(default=None, repr=False)

    def rudder(self, seen: Seen) -> float:
        """The rudder order (rad), positive to starboard."""
        passed = 0.0 if self._before is None else min(max(seen.t_s - self._before, 0.0), 20.0)
        self._estimate_drift(seen, passed)
        ground = max(math.hypot(*seen.velocity_mps), 0.5)
        along, self.cross_track_m = self.track.beside(seen.position_m)
        bend = self._bend(along)
        across = self.drift_mps[1] * math.cos(bend.way) - self.drift_mps[0] * math.sin(bend.way)
        across += self._slide_mps
        upstream = math.asin(max(-0.7, min(0.7, across / max(seen.log_mps, 0.5))))
        towards = math.atan2(self.cross_track_m, self.lookahead_lengths * self.length_m)
        error = wrapped(bend.way - upstream - towards - seen.heading_rad)
        # Rates and times in lengths: the same numbers serve at every speed.
        turning = seen.turn_radps * self.length_m / ground
        soon = self._bend(along + self.lead_lengths * self.length_m)
        wanted = soon.curvature * self.length_m
        changing = soon.change * self.length_m**2
        ask = (
            self.gain * error
            + self.rate_gain_lengths * (bend.curvature * self.length_m - turning)
            + (wanted + self.turn_time_lengths * changing) / self.turn_gain
            + self._held
        )
        if abs(ask) < self.stop_rad and bend.curvature == 0:
            self._held += self.gain * error * passed / self.integral_s
        return max(-self.stop_rad, min(self.stop_rad, ask))

    def _bend(self, along_m: float) -> Bend:
        """Course and curvature of the track, averaged over some length, so that both change gradually."""
        half = self.bend_lengths * self.length_m / 2
        start, end = along_m - half, along_m + half
        courses = [self.track.course_at(along_m + half * part / 4) for part in range(-4, 5)]
        first = courses[0]
        way = first + sum(wrapped(course - first) for course in courses) / len(courses)
        curvature = wrapped(self.track.course_at(end) - self.track.course_at(start)) / (2 * half)
        change = (self.track.curvature_at(end) - self.track.curvature_at(start)) / (2 * half)
        return Bend(way, curvature, change)

    def _estimate_drift(self, seen: Seen, passed: float) -> None:
        """Drift is what the velocity over ground has beyond the way through the water: ahead by the log, and sideways in
        a turn, because a ship turns about a place ahead of her middle."""
        sin, cos = math.sin(seen.heading_rad), math.cos(seen.heading_rad)
        slide_s = self.slide_lengths * self.length_m / max(seen.log_mps, 0.5)
        steady = -self.pivot_lengths * self.length_m * seen.turn_radps
        self._slide_mps += (1 - math.exp(-passed / slide_s)) * (steady - self._slide_mps)
        sideways = self._slide_mps
        north = seen.velocity_mps[0] - seen.log_mps * cos + sideways * sin
        east = seen.velocity_mps[1] - seen.log_mps * sin - sideways * cos
        share = 1.0 if self._before is None else 1 - math.exp(-passed / self.drift_s)
        self._before = seen.t_s
        self.drift_mps = (
            self.drift_mps[0] + share * (north - self.drift_mps[0]),
            self.drift_mps[1] + share * (east - self.drift_mps[1]),
        )


def waypoints_of(plan: dict[str, object]) -> list[Place]:
    """The waypoints of a passage plan of the protocol (``PlanInfo``)."""
    waypoints = plan["waypoints"]
    assert isinstance(waypoints, list)
    return [(float(way["at_m"][0]), float(way["at_m"][1])) for way in waypoints]
