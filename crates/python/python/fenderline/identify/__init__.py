"""Identification: the coefficients of a vessel from trials or approaches with a measured track.

A trial is a scenario with the orders (turning circle, zig-zag, stopping, crabbing, or a free-running approach) and a track that was
measured. Chosen coefficients of the vessel, each as a factor on her own number, are fitted by SciPy's least squares with bounds; the
state at the start of each track is fitted with them. What the data cannot tell is named and left at its start value.

    from fenderline import identify

    found = identify.identify("turning.toml", "turning.csv", ["rudder force", "hull yaw damping"])
    print(found.table())
    found.write("fitted.toml")
    found.report("report.html")

``python -m fenderline.identify`` does the same from a command line. Needs SciPy: ``pip install "fenderline[identify]"``.
"""

from __future__ import annotations

import importlib.util
import math
import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline._errors import Error
from fenderline._native import Scenario
from fenderline._runs import AnyScenario
from fenderline.identify import _fit, _report
from fenderline.identify._errors import IdentifyError, TrackError, missing
from fenderline.identify._fit import Limits, Profile
from fenderline.identify._track import AnyMapping, Track, read_track
from fenderline.identify._trial import Trial
from fenderline.identify._vessel import WORDS, VesselFile

__all__ = [
    "WORDS",
    "Coefficient",
    "Identification",
    "IdentifyError",
    "Limits",
    "Profile",
    "Quality",
    "Track",
    "TrackError",
    "VesselFile",
    "coefficients",
    "identify",
    "read_track",
]

Floats = npt.NDArray[np.float64]
#: Chosen coefficients: names, or names with the bounds of their factors.
Chosen = Iterable[str] | Mapping[str, tuple[float, float]]
#: Bounds of a factor where none are given.
BOUNDS = (0.5, 2.0)


@dataclass(frozen=True)
class Coefficient:
    """A chosen coefficient after the fit."""

    name: str
    """The name under which it was chosen."""
    values: dict[str, tuple[float, float]]
    """By path in the vessel's file, the number before and after, in the unit of the file."""
    bounds: tuple[float, float]
    """Bounds of the factor."""
    factor: float
    """Number after the fit divided by the number before; 1 if it was refused."""
    deviation: float
    """Standard error of the factor; NaN if it was refused."""
    band: tuple[float, float]
    """The 95 % band of the factor: by the profile of the likelihood where there is one, else by the standard error; NaN if it was refused."""
    refused: str | None
    """Why the data cannot tell it; ``None`` if it was fitted."""
    profile: Profile | None
    """The profile of the likelihood, where it was needed."""


@dataclass(frozen=True)
class Quality:
    """How near a run is to a track."""

    label: str
    """File of the track."""
    rows: int
    """Rows of the track."""
    before_m: float
    """Root of the mean squared distance of the run with the start values (m)."""
    after_m: float
    """The same with the fitted values (m)."""
    largest_before_m: float
    """Largest distance with the start values (m)."""
    largest_after_m: float
    """Largest distance with the fitted values (m)."""
    before_deg: float
    """Root of the mean squared error of the heading with the start values (degrees)."""
    after_deg: float
    """The same with the fitted values (degrees)."""
    inflation: float
    """How many times wider the variances are because what is left of the place follows itself; 1 for noise without memory. A large
    number says that the model, and not the noise, is what is left."""


@dataclass(frozen=True)
class Identification:
    """The result of :func:`identify`."""

    vessel: str
    """Name of the vessel whose coefficients were the start."""
    coefficients: list[Coefficient]
    """The chosen coefficients, in the order of the choice."""
    fitted: list[str]
    """Names of the coefficients that were fitted, in the order of ``correlation``."""
    correlation: Floats
    """Correlation of the fitted factors."""
    condition: float
    """Condition number of the scaled Jacobian of the fitted factors."""
    quality: list[Quality]
    """Before and after, of each track."""
    remarks: list[str]
    """What was guessed and left out."""
    runs: int
    """Number of runs."""
    trials: list[Trial]
    """The trials."""
    misses_before: list[Floats]
    """Measured less computed with the start values, of each track: (rows, 3) of metres north and east, and radians."""
    misses: list[Floats]
    """Measured less computed with the fitted values, likewise."""

    def factors(self) -> dict[str, float]:
        """Factor of each changed number by its path."""
        found: dict[str, float] = {}
        for own in self.coefficients:
            for path in own.values if own.refused is None else ():
                found[path] = found.get(path, 1.0) * own.factor
        return found

    def vessel_file(self, name: str | None = None) -> str:
        """The text of a vessel file with the fitted numbers, under the name ``NAME-fitted`` or a name of your choice. Each fitted number
        has the fit as its source."""
        sources = {}
        tracks = ", ".join(quality.label for quality in self.quality)
        for own in self.coefficients:
            for path in own.values if own.refused is None else ():
                sources[path] = f"fitted to {tracks} by fenderline.identify: {own.factor:.4g} ± {own.deviation:.2g} times the number before"
        return self.trials[0].vessel.written(name or f"{self.vessel}-fitted", self.factors(), sources)

    def write(self, path: str | os.PathLike[str], name: str | None = None) -> None:
        """Writes :meth:`vessel_file`; a scenario takes it by ``vessel_files``."""
        text = self.vessel_file(name)
        try:
            Path(path).write_text(text, "utf-8")
        except OSError as error:
            raise IdentifyError(f"{path}: the file cannot be written: {error.strerror}") from None

    def table(self) -> str:
        """Coefficients and errors before and after, as text."""
        return _report.text(self)

    def report(self, path: str | os.PathLike[str]) -> None:
        """Writes a page with coefficients, correlations, errors before and after, tracks and what is left over."""
        try:
            Path(path).write_text(_report.page(self), "utf-8")
        except OSError as error:
            raise IdentifyError(f"{path}: the file cannot be written: {error.strerror}") from None


def coefficients(scenario: AnyScenario, body: str | None = None) -> dict[str, object]:
    """The coefficients of a vessel that can be chosen, by their paths in a vessel file: her own, and those that the program estimated."""
    own = Scenario(scenario)
    from fenderline.identify._trial import _only_vessel

    return dict(VesselFile(own, body or _only_vessel(own)).values)


def identify(
    scenario: AnyScenario | Sequence[AnyScenario],
    track: str | os.PathLike[str] | Track | Sequence[str | os.PathLike[str] | Track],
    fit: Chosen,
    *,
    mapping: AnyMapping | Sequence[AnyMapping | None] | None = None,
    body: str | None = None,
    start: str = "fit",
    limits: Limits | None = None,
    profiles: bool = True,
    threads: int = 1,
) -> Identification:
    """Fits chosen coefficients of a vessel to measured tracks.

    ``scenario``: the trial's orders, one scenario for all tracks or one for each; all have the same vessel. ``track``: files, which
    ``mapping`` explains (one for all, or one for each; see :func:`read_track`), or tracks. ``fit``: names of coefficients, as
    ``rudder.lift_gradient``, patterns, as ``sway_polynomial.n_*``, or words of :data:`WORDS`, as ``rudder force``; each is one factor on
    all its numbers, from 0.5 to 2 or between the bounds given. ``start``: ``"fit"`` fits the state of the ship at time 0 with the
    coefficients, ``"scenario"`` takes the scenario's. ``limits``: what is refused. ``profiles=False`` leaves the profiles of the
    likelihood out.

    Raises :class:`TrackError` for a track that cannot be used, with file and line, and :class:`IdentifyError` for the rest.
    """
    if importlib.util.find_spec("scipy") is None:
        raise missing()
    if start not in ("fit", "scenario"):
        raise IdentifyError(f"`start` is {start!r}; there are: \"fit\", \"scenario\"")
    tracks: list[Any] = list(track) if isinstance(track, Sequence) and not isinstance(track, str) else [track]
    scenarios: list[Any] = list(scenario) if isinstance(scenario, list | tuple) else [scenario] * len(tracks)
    mappings: list[Any] = list(mapping) if isinstance(mapping, list | tuple) else [mapping] * len(tracks)
    if not tracks or len(scenarios) != len(tracks) or len(mappings) != len(tracks):
        raise IdentifyError(f"there are {len(scenarios)} scenarios, {len(tracks)} tracks and {len(mappings)} mappings: give one scenario and one mapping, or one for each track")
    trials = []
    for own, measured, one in zip(scenarios, tracks, mappings, strict=True):
        read = measured if isinstance(measured, Track) else read_track(measured, one)
        trials.append(Trial(Scenario(own), read, body, os.path.basename(read.file), threads))
    vessel = trials[0].vessel
    for trial in trials[1:]:
        if trial.vessel.name != vessel.name or trial.vessel.values != vessel.values:
            raise IdentifyError(f"{trial.vessel.scenario.name} has the vessel {trial.vessel.name!r} and {vessel.scenario.name} has {vessel.name!r}: all trials need one vessel")
    chosen = _chosen(vessel, fit)
    problem = _fit.Problem(trials, chosen, start == "fit")
    _refuse_other_ship(problem)
    begin = [trial.guess() if problem.fits_start else np.empty(0) for trial in trials]
    active, found, refused, before = _fit.identify(problem, limits or Limits(), begin, profiles)
    return _result(problem, active, found, refused, before)


def _chosen(vessel: VesselFile, fit: Chosen) -> list[_fit.Chosen]:
    names = dict(fit) if isinstance(fit, Mapping) else dict.fromkeys([fit] if isinstance(fit, str) else fit, BOUNDS)
    if not names:
        raise IdentifyError("no coefficient is chosen")
    chosen: list[_fit.Chosen] = []
    taken: dict[str, str] = {}
    for name, bounds in names.items():
        low, high = bounds
        if not (0.0 < low < 1.0 < high < math.inf):
            raise IdentifyError(f"{name}: the bounds of a factor must lie to both sides of 1 and above 0, but are {low:g} and {high:g}")
        paths = vessel.paths(name)
        for path in paths:
            if path in taken:
                raise IdentifyError(f"{path} is in both {taken[path]!r} and {name!r}: two factors on one number cannot be told apart")
            taken[path] = name
        chosen.append(_fit.Chosen(name, tuple(paths), float(low), float(high)))
    return chosen


def _refuse_other_ship(problem: _fit.Problem) -> None:
    """Refuses a vessel that no vessel file can state: with all coefficients written out she must run as she is."""
    for trial in problem.trials:
        begin = trial.guess() if problem.fits_start else None
        ones = {path: 1.0 for own in problem.chosen for path in own.paths}
        try:
            runs = [trial.run({"fit-0": trial.vessel.changed(factors)}, [("fit-0", begin)]) for factors in ({}, ones)]
        except Error as error:
            raise IdentifyError(f"{trial.label}: the trial does not run from the start of the track: {error}") from error
        away_m = float(np.abs(runs[0] - runs[1])[..., :2].max())
        if away_m > 1e-4 * trial.length_m:
            raise IdentifyError(
                f"{trial.vessel.name}: with the chosen numbers written into a vessel file she goes another way, by {away_m:.3g} m: "
                "the program estimates her hull in a form that a file cannot state. Give her coefficients in a vessel file"
            )


def _result(problem: _fit.Problem, active: list[int], found: _fit.Fitted, refused: list[_fit.Refused], before: _fit.Fitted) -> Identification:
    reasons = {own.chosen.name: own.why for own in refused}
    vessel = problem.trials[0].vessel
    deviations = np.sqrt(np.diag(found.covariance)) if active else np.empty(0)
    coefficients = []
    for index, chosen in enumerate(problem.chosen):
        is_fitted = index in active
        place = active.index(index) if is_fitted else 0
        factor = float(found.factors[place]) if is_fitted else 1.0
        deviation = float(deviations[place]) if is_fitted else math.nan
        profile = found.profiles.get(chosen.name) if is_fitted else None
        band = (factor - 1.96 * deviation, factor + 1.96 * deviation)
        if profile is not None and profile.low is not None and profile.high is not None:
            band = (profile.low, profile.high)
        values = {path: (vessel.number(path), vessel.number(path) * factor) for path in chosen.paths}
        coefficients.append(Coefficient(chosen.name, values, (chosen.low, chosen.high), factor, deviation, band, reasons.get(chosen.name), profile))

    def sizes(missed: Floats) -> tuple[float, float, float]:
        away = np.hypot(missed[:, 0], missed[:, 1])
        return float(np.sqrt(np.mean(away**2))), float(away.max()), math.degrees(float(np.sqrt(np.mean(missed[:, 2] ** 2))))

    quality, remarks = [], []
    for number, trial in enumerate(problem.trials):
        (old_m, old_largest_m, old_deg), (new_m, new_largest_m, new_deg) = sizes(before.misses[number]), sizes(found.misses[number])
        inflation = float(found.inflation[number].max())
        quality.append(Quality(trial.label, len(trial.track), old_m, new_m, old_largest_m, new_largest_m, old_deg, new_deg, inflation))
        remarks += [f"{trial.label}: {remark}" for remark in trial.track.remarks]
    return Identification(
        vessel=vessel.name,
        coefficients=coefficients,
        fitted=[problem.chosen[index].name for index in active],
        correlation=found.covariance / np.outer(deviations, deviations),
        condition=found.condition,
        quality=quality,
        remarks=remarks,
        runs=problem.runs,
        trials=problem.trials,
        misses_before=before.misses,
        misses=found.misses,
    )
