"""A trial: a scenario with the orders, and the track that was measured."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline._errors import Error
from fenderline._native import Fleet, Scenario
from fenderline._tree import _key
from fenderline.identify._errors import IdentifyError, TrackError
from fenderline.identify._track import Track
from fenderline.identify._vessel import VesselFile

Floats = npt.NDArray[np.float64]

#: Steps of the finite differences for the state at the start: places (m), heading (rad), velocities ahead and to starboard (m/s), rate
#: of turn (rad/s).
START_STEPS = np.array([0.05, 0.05, 1e-4, 1e-3, 1e-3, 1e-6])
#: Rows over which the state at the start is guessed (s).
_FIRST_S = 30.0


class Trial:
    """A trial with its runs."""

    def __init__(self, scenario: Scenario, track: Track, body: str | None, label: str, threads: int) -> None:
        self.label = label
        self.threads = threads
        self.vessel = VesselFile(scenario, body or _only_vessel(scenario))
        self.body = scenario.bodies.index(self.vessel.body)
        self.length_m = self.vessel.length_m
        place = scenario_place(scenario, self.vessel.body)
        if not track.is_placed:
            track = track.moved(*(place if place is not None else (0.0, 0.0)))
        elif place is not None:
            away_m = math.hypot(track.north_m[0] - place[0], track.east_m[0] - place[1])
            if away_m > max(20.0 * self.length_m, 500.0):
                raise TrackError(
                    f"the track begins {away_m:.0f} m from where {self.vessel.body!r} begins in {scenario.name}: another berth, another ship, or a wrong origin",
                    track.file,
                    int(track.lines[0]),
                )
        self.track = track
        self.step_s = scenario.step_s
        spacing_s = float(np.median(np.diff(track.time_s)))
        self.stride = max(1, int(min(spacing_s, 2.0) / self.step_s))
        self.strides = math.ceil(float(track.time_s[-1]) / (self.step_s * self.stride) - 1e-9) + 1
        if self.strides * self.stride > 2_000_000:
            raise IdentifyError(f"{label}: a run would take {self.strides * self.stride} steps; shorten the track by `end` of its mapping")
        self.measured = np.column_stack([track.north_m, track.east_m, track.heading_rad])
        first = Fleet(scenario, [{}])
        for name in track.controls:
            if name not in first.control_names:
                raise TrackError(f"the scenario has no control {name!r}; there are: {', '.join(first.control_names)}", track.file)
        self._controls = [(first.control_names.index(name), values) for name, values in track.controls.items()]
        antenna = track.antenna_m
        self.antenna_m = (antenna[0] - self.vessel.gravity_m, antenna[1])

    def guess(self) -> Floats:
        """The state at the start, by parabolas through the first rows."""
        track = self.track
        rows = np.flatnonzero(track.time_s <= track.time_s[0] + _FIRST_S)
        if len(rows) < 6:
            rows = np.arange(min(6, len(track)))
        degree = 2 if len(rows) >= 6 else 1
        fits = [np.polynomial.Polynomial.fit(track.time_s[rows], self.measured[rows, column], degree) for column in range(3)]
        north, east, heading = (float(fit(0.0)) for fit in fits)
        rates = [float(fit.deriv()(0.0)) for fit in fits]
        sine, cosine = math.sin(heading), math.cos(heading)
        ahead, aside = self.antenna_m
        north -= cosine * ahead - sine * aside
        east -= sine * ahead + cosine * aside
        surge = cosine * rates[0] + sine * rates[1] + rates[2] * aside
        sway = -sine * rates[0] + cosine * rates[1] - rates[2] * ahead
        return np.array([north, east, heading, surge, sway, rates[2]])

    def noise(self) -> tuple[float, float]:
        """Standard deviations of place (m) and heading (rad), from the second differences of the readings."""
        spans = np.diff(self.track.time_s)
        regular = np.abs(spans[1:] - spans[:-1]) < 0.01 * spans[1:]
        second = np.diff(self.measured, 2, axis=0)[regular]
        if len(second) < 10:
            return 1.0, math.radians(0.5)
        # The median holds off what the ship herself does, such as the first turn of the rudder.
        spread = np.median(np.abs(second - np.median(second, axis=0)), axis=0) / 0.6745 / math.sqrt(6.0)
        return max(float(np.hypot(spread[0], spread[1]) / math.sqrt(2.0)), 1e-3), max(float(spread[2]), 1e-5)

    def run(self, tables: Mapping[str, Mapping[str, Any]], runs: Sequence[tuple[str, Floats | None]]) -> Floats:
        """Places of the antenna (m) and headings (rad) at the times of the track: (runs, rows, 3). Each run has the name of its vessel in
        ``tables``, and its state at the start, or ``None`` for that of the scenario."""
        # A variant that changes the vessel reads her file again, one that changes the start does not: a fleet for each vessel.
        groups: dict[str, list[int]] = {}
        for number, (name, _) in enumerate(runs):
            groups.setdefault(name, []).append(number)

        def one(group: tuple[str, list[int]]) -> Floats:
            name, numbers = group
            return self._fleet(tables[name], [runs[number][1] for number in numbers])

        found = np.empty((len(runs), len(self.track), 3))
        if self.threads == 1 or len(groups) == 1:
            done = list(map(one, groups.items()))
        else:
            with ThreadPoolExecutor(self.threads) as pool:
                done = list(pool.map(one, groups.items()))
        for numbers, own in zip(groups.values(), done, strict=True):
            found[numbers] = own
        return found

    def _fleet(self, table: Mapping[str, Any], starts: Sequence[Floats | None]) -> Floats:
        """Runs of one vessel from several states at the start."""
        vessel = self.vessel
        end_s = (self.strides * self.stride + 1) * self.step_s
        scenario = vessel.scenario_with(table, {"time.duration": f"{end_s!r} s"})
        body = f"body.{_key(vessel.body)}"
        variants: list[dict[str, Any]] = []
        for start in starts:
            if start is None:
                variants.append({})
                continue
            north, east, heading, surge, sway, yaw = start.tolist()
            velocity = {"surge": surge, "sway": sway, "yaw": yaw}
            variants.append({f"{body}.position": [north, east], f"{body}.heading": math.remainder(heading, 2.0 * math.pi), f"{body}.velocity": velocity})
        fleet = Fleet(scenario, variants)
        states: Floats = np.empty((self.strides + 1, len(starts), 6))
        times: Floats = np.arange(self.strides + 1, dtype=np.float64) * (self.stride * self.step_s)
        orders = [(column, np.interp(times + 0.5 * self.stride * self.step_s, self.track.time_s, values)) for column, values in self._controls]
        for sample in range(self.strides + 1):
            states[sample] = fleet.states[:, self.body]
            if sample < self.strides:
                for column, values in orders:
                    fleet.controls[:, column] = values[sample]
                fleet.step(self.stride)
        return self._at_times(times, states)

    def _at_times(self, times: Floats, states: Floats) -> Floats:
        from scipy.interpolate import CubicHermiteSpline

        states[:, :, 2] = np.unwrap(states[:, :, 2], axis=0)
        at = CubicHermiteSpline(times, states[:, :, :3], states[:, :, 3:])(self.track.time_s)
        ahead, aside = self.antenna_m
        sine, cosine = np.sin(at[:, :, 2]), np.cos(at[:, :, 2])
        at[:, :, 0] += cosine * ahead - sine * aside
        at[:, :, 1] += sine * ahead + cosine * aside
        return np.moveaxis(at, 1, 0)

    def misses(self, predicted: Floats) -> Floats:
        """Measured less predicted: (rows, 3) of metres, metres and radians; a whole turn of the heading does not count."""
        missed = self.measured - predicted
        turns = np.round(np.median(missed[..., :, 2], axis=-1) / (2.0 * math.pi))
        missed[..., :, 2] -= 2.0 * math.pi * np.asarray(turns)[..., None]
        return missed


def scenario_place(scenario: Scenario, body: str) -> tuple[float, float] | None:
    """Where the body begins (m); ``None`` where the scenario has no run."""
    try:
        states = Fleet(scenario, [{}]).states
    except Error as error:
        raise IdentifyError(f"{scenario.name} does not run: {error}") from error
    row = states[0, scenario.bodies.index(body)]
    return float(row[0]), float(row[1])


def _only_vessel(scenario: Scenario) -> str:
    bodies = scenario.tree().get("body", {})
    vessels = [name for name in scenario.bodies if "vessel" in bodies.get(name, {})]
    if len(vessels) != 1:
        found = f"has {len(vessels)} vessels: {', '.join(vessels)}" if vessels else "has no vessel"
        raise IdentifyError(f"{scenario.name} {found}; name the one of the track by `body`")
    return vessels[0]
