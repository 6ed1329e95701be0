"""Least squares with bounds by SciPy, and what the data can tell of each coefficient."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline._errors import Error
from fenderline.identify._errors import IdentifyError
from fenderline.identify._trial import START_STEPS, Trial

Floats = npt.NDArray[np.float64]

#: Step of the finite differences for a factor.
_STEP = 1e-4
#: Typical sizes of the state at the start, for the trust region.
_START_SCALES = np.array([5.0, 5.0, 0.02, 0.1, 0.1, 1e-3])
#: Chi-square of one parameter at 95 %.
_CHI2_95 = 3.841458820694124


@dataclass(frozen=True)
class Chosen:
    """A coefficient that was chosen: a factor on the numbers of its paths."""

    name: str
    """Its name: a path, a pattern or a word."""
    paths: tuple[str, ...]
    """Its paths in the vessel's file."""
    low: float
    """Least factor."""
    high: float
    """Greatest factor."""


@dataclass
class Limits:
    """What is refused."""

    condition: float = 1e3
    """Largest condition number of the scaled Jacobian."""
    deviation: float = 0.25
    """Largest standard error of a factor."""
    weak: float = 0.05
    """Standard error from which on the likelihood is profiled."""
    correlation: float = 0.9
    """Correlation from which on the likelihood is profiled."""


@dataclass
class Profile:
    """The likelihood along one factor, with all others fitted anew."""

    factors: list[float]
    """Factors."""
    rises: list[float]
    """Rise of the sum of squares in units of the noise; 3.84 is the edge of the 95 % band."""
    low: float | None
    """Lower edge of the 95 % band; ``None`` if the band goes beyond the bound."""
    high: float | None
    """Upper edge of the 95 % band; ``None`` if the band goes beyond the bound."""


@dataclass
class Fitted:
    """A fit with some of the chosen coefficients."""

    factors: Floats
    """Factor of each active coefficient."""
    starts: list[Floats]
    """State at the start of each trial."""
    sigmas: Floats
    """Standard deviation of place (m) and heading (rad), the same for each trial: (trials, 2)."""
    covariance: Floats
    """Covariance of the factors."""
    condition: float
    """Condition number of the Jacobian of the factors, without what the states at the start explain, with columns of length 1."""
    directions: Floats
    """Right singular vectors of this Jacobian; the last is the combination that the data tell least."""
    inflation: Floats
    """How many times wider the noise makes the variance because it follows itself: (trials, 2)."""
    misses: list[Floats]
    """Measured less computed, of each trial: (rows, 3)."""
    evaluations: int = 0
    """Number of Jacobians."""
    profiles: dict[str, Profile] = field(default_factory=dict)
    """Profiles by name of the coefficient."""


class Problem:
    """The trials with the chosen coefficients."""

    def __init__(self, trials: Sequence[Trial], chosen: Sequence[Chosen], fits_start: bool) -> None:
        self.trials = list(trials)
        self.chosen = list(chosen)
        self.fits_start = fits_start
        self.runs = 0
        #: The noise with which the first fit begins, as the noisiest track has it.
        self._least = np.tile(np.max([trial.noise() for trial in trials], axis=0), (len(trials), 1))

    def factors_of(self, active: Sequence[int], values: Floats) -> dict[str, float]:
        """Factors by path."""
        factors: dict[str, float] = {}
        for index, value in zip(active, values, strict=True):
            for path in self.chosen[index].paths:
                factors[path] = factors.get(path, 1.0) * float(value)
        return factors

    def tables(self, trial: Trial, active: Sequence[int], rows: Sequence[Floats]) -> dict[str, dict[str, Any]]:
        return {f"fit-{number}": trial.vessel.changed(self.factors_of(active, row)) for number, row in enumerate(rows)}

    def run(self, trial: Trial, active: Sequence[int], rows: Sequence[Floats], runs: Sequence[tuple[int, Floats | None]]) -> Floats:
        """Misses of runs, each with the number of its row of factors and its state at the start."""
        self.runs += len(runs)
        try:
            return trial.misses(trial.run(self.tables(trial, active, rows), [(f"fit-{row}", start) for row, start in runs]))
        except Error as error:
            named = [f"{self.chosen[index].name} × {value:.4g}" for index, value in zip(active, rows[0], strict=True)]
            hint = "; narrower bounds may help" if named else ""
            raise IdentifyError(f"{trial.label}: a run with {', '.join(named) or 'the start values'} failed{hint}: {error}") from error

    def misses(self, active: Sequence[int], factors: Floats, starts: Sequence[Floats]) -> list[Floats]:
        """Misses of each trial."""
        return [self.run(trial, active, [factors], [(0, start if self.fits_start else None)])[0] for trial, start in zip(self.trials, starts, strict=True)]

    def slopes(self, active: Sequence[int], factors: Floats, starts: Sequence[Floats]) -> list[Floats]:
        """Derivatives of the misses of each trial: (rows, 3, factors + states at the start), by central differences."""
        rows: list[Floats] = []
        for column in range(len(active)):
            for sign in (1.0, -1.0):
                row = factors.copy()
                row[column] += sign * _STEP
                rows.append(row)
        rows.append(factors)
        slopes = []
        for trial, start in zip(self.trials, starts, strict=True):
            own = start if self.fits_start else None
            runs: list[tuple[int, Floats | None]] = [(number, own) for number in range(2 * len(active))]
            steps = [2.0 * _STEP] * len(active)
            if self.fits_start:
                for column, step in enumerate(START_STEPS):
                    for sign in (1.0, -1.0):
                        moved = start.copy()
                        moved[column] += sign * step
                        runs.append((len(rows) - 1, moved))
                    steps.append(2.0 * step)
            missed = self.run(trial, active, rows, runs) if runs else np.empty((0, len(trial.track), 3))
            slopes.append(np.stack([(missed[2 * i] - missed[2 * i + 1]) / step for i, step in enumerate(steps)], axis=-1) if steps else np.empty((len(trial.track), 3, 0)))
        return slopes

    # The parameters as one vector: factors, then the states at the start of each trial.

    def _split(self, active: Sequence[int], vector: Floats) -> tuple[Floats, list[Floats]]:
        count = len(active)
        if not self.fits_start:
            return vector[:count], [np.empty(0) for _ in self.trials]
        return vector[:count], [vector[count + 6 * i : count + 6 * i + 6] for i in range(len(self.trials))]

    def _weighted(self, misses: Sequence[Floats], sigmas: Floats) -> Floats:
        return np.concatenate([(missed / [sigma[0], sigma[0], sigma[1]]).ravel() for missed, sigma in zip(misses, sigmas, strict=True)])

    def _jacobian(self, active: Sequence[int], factors: Floats, starts: Sequence[Floats], sigmas: Floats) -> Floats:
        count = len(active)
        blocks = []
        for number, (slope, sigma) in enumerate(zip(self.slopes(active, factors, starts), sigmas, strict=True)):
            weighted = (slope / np.array([sigma[0], sigma[0], sigma[1]])[None, :, None]).reshape(slope.shape[0] * 3, slope.shape[2])
            block = np.zeros((len(weighted), count + (6 * len(self.trials) if self.fits_start else 0)))
            block[:, :count] = weighted[:, :count]
            if self.fits_start:
                block[:, count + 6 * number : count + 6 * number + 6] = weighted[:, count:]
            blocks.append(block)
        return np.vstack(blocks)

    def _solve(
        self, active: Sequence[int], factors: Floats, starts: Sequence[Floats], sigmas: Floats, most: int, held: tuple[int, float] | None = None, near: float = 1e-8
    ) -> tuple[Floats, list[Floats], float]:
        """Least squares; ``held`` holds one of the active factors at a value. Returns factors, starts and the sum of squares."""
        from scipy.optimize import least_squares

        free = [place for place in range(len(active)) if held is None or place != held[0]]
        own = [active[place] for place in free]

        def whole(vector: Floats) -> tuple[Floats, list[Floats]]:
            part, own_starts = self._split(own, vector)
            all_factors = np.empty(len(active))
            all_factors[free] = part
            if held is not None:
                all_factors[held[0]] = held[1]
            return all_factors, own_starts

        begin = np.concatenate([factors[free], *([start for start in starts] if self.fits_start else [])])
        if len(begin) == 0:
            total = self._weighted(self.misses(active, *whole(begin)), sigmas)
            return factors.copy(), list(starts), float(total @ total)
        states = 6 * len(self.trials) if self.fits_start else 0
        low = np.concatenate([[self.chosen[index].low for index in own], np.full(states, -np.inf)])
        high = np.concatenate([[self.chosen[index].high for index in own], np.full(states, np.inf)])
        scales = np.concatenate([np.full(len(own), 0.1), np.tile(_START_SCALES, len(self.trials)) if states else []])
        begin = np.clip(begin, low + 1e-9, high - 1e-9)
        columns = [*free, *range(len(active), len(active) + states)]

        def jacobian(vector: Floats) -> Floats:
            return self._jacobian(active, *whole(vector), sigmas)[:, columns]

        def residuals(vector: Floats) -> Floats:
            return self._weighted(self.misses(active, *whole(vector)), sigmas)

        found = least_squares(residuals, begin, jac=jacobian, bounds=(low, high), x_scale=scales, method="trf", xtol=1e-7, ftol=near, gtol=1e-12, max_nfev=most)
        all_factors, own_starts = whole(found.x)
        return all_factors, own_starts, 2.0 * float(found.cost)

    def fit(self, active: Sequence[int], factors: Floats, starts: Sequence[Floats], sigmas: Floats | None = None) -> Fitted:
        """Fits the active factors and the states at the start, with the noise from what is left over."""
        sigma = self._least if sigmas is None else sigmas
        states = list(starts)
        for turn in range(4):
            # The first weights are a guess: their fit need not be exact.
            factors, states, _ = self._solve(active, factors, states, sigma, 40, near=1e-4 if turn == 0 else 1e-8)
            misses = self.misses(active, factors, states)
            new = self._noise(active, misses)
            is_same = bool(np.all(np.abs(new / sigma - 1.0) < 0.05))
            sigma = new
            if is_same:
                break
        return self._told(active, factors, states, sigma, misses)

    def _noise(self, active: Sequence[int], misses: Sequence[Floats]) -> Floats:
        total = sum(missed.size for missed in misses)
        spent = len(active) + (6 * len(self.trials) if self.fits_start else 0)
        left = max(total - spent, 1) / total
        # One noise for all tracks: weights of each track by what is left of it would let the fit give up the track that fits worst.
        every = np.concatenate(list(misses))
        found = (math.sqrt(np.mean(every[:, :2] ** 2) / left), math.sqrt(np.mean(every[:, 2] ** 2) / left))
        # A track without noise, as a run's own result, has none to divide by.
        return np.tile(np.maximum(found, [1e-3, 1e-5]), (len(misses), 1))

    def _told(self, active: Sequence[int], factors: Floats, starts: list[Floats], sigmas: Floats, misses: list[Floats]) -> Fitted:
        """Covariance and condition at a fit."""
        jacobian = self._jacobian(active, factors, starts, sigmas)
        inflation = np.array([[_inflation(missed[:, :2]), _inflation(missed[:, 2:])] for missed in misses])
        # The variance of each track beside the common one.
        own_shares = np.array([[np.mean(missed[:, :2] ** 2), np.mean(missed[:, 2] ** 2)] for missed in misses]) / sigmas**2
        wider = inflation * np.maximum(own_shares, 1e-6)
        spread = np.concatenate([np.tile([own[0], own[0], own[1]], len(missed)) for own, missed in zip(wider, misses, strict=True)])
        count = len(active)
        own, nuisance = jacobian[:, :count], jacobian[:, count:]
        if nuisance.shape[1]:
            # Columns that nothing depends on would leave a direction of rounding errors.
            kept = nuisance[:, np.linalg.norm(nuisance, axis=0) > 0.0]
            basis, _ = np.linalg.qr(kept / np.linalg.norm(kept, axis=0))
            own = own - basis @ (basis.T @ own)
        lengths = np.linalg.norm(own, axis=0)
        safe = np.where(lengths > 0.0, lengths, 1.0)
        if count:
            _, singular, directions = np.linalg.svd(own / safe, full_matrices=False)
            condition = math.inf if singular[-1] <= 1e-12 * singular[0] else float(singular[0] / singular[-1])
            bread = np.linalg.pinv((own / safe).T @ (own / safe)) / np.outer(safe, safe)
            covariance = bread @ (own.T @ (own * spread[:, None])) @ bread
            covariance[lengths == 0.0, lengths == 0.0] = math.inf
        else:
            directions, condition, covariance = np.empty((0, 0)), 1.0, np.empty((0, 0))
        return Fitted(factors, starts, sigmas, covariance, condition, directions, inflation, misses)

    def profile(self, active: Sequence[int], fitted: Fitted, place: int) -> Profile:
        """The likelihood along a factor, from the fit outwards to either bound or to a rise beyond the 95 % band."""
        chosen, best = self.chosen[active[place]], float(fitted.factors[place])
        width = math.sqrt(max(float(fitted.covariance[place, place]), 0.0))
        width = min(width, chosen.high - chosen.low) if math.isfinite(width) else chosen.high - chosen.low
        _, _, least = self._solve(active, fitted.factors, fitted.starts, fitted.sigmas, 8, (place, best))
        spread = self._spread(fitted)
        points, edges = {best: 0.0}, []
        for sign, bound in ((-1.0, chosen.low), (1.0, chosen.high)):
            factors, starts, edge = fitted.factors, fitted.starts, None
            before = (best, 0.0)
            for times in (1.0, 2.0, 3.0, 5.0, math.inf):
                at = best + sign * times * width
                at = max(bound, at) if sign < 0 else min(bound, at)
                if abs(at - before[0]) < 1e-9:
                    break
                moved = factors.copy()
                moved[place] = at
                factors, starts, squares = self._solve(active, moved, starts, fitted.sigmas, 8, (place, at))
                rise = (squares - least) / spread
                points[at] = rise
                if rise > _CHI2_95:
                    # The root of the rise is nearly straight.
                    low, high = math.sqrt(max(before[1], 0.0)), math.sqrt(rise)
                    edge = before[0] + (at - before[0]) * (math.sqrt(_CHI2_95) - low) / (high - low)
                    break
                before = (at, rise)
            edges.append(edge)
        order = sorted(points)
        return Profile(order, [points[at] for at in order], edges[0], edges[1])

    def _spread(self, fitted: Fitted) -> float:
        """The mean inflation of the variance, by which a rise of the sum of squares is divided."""
        rows = np.array([[2 * len(missed), len(missed)] for missed in fitted.misses], dtype=float)
        return float((fitted.inflation * rows).sum() / rows.sum())


def _inflation(missed: Floats) -> float:
    """How much wider the variance of a mean is because the noise follows itself: 1 for noise without memory.

    The sum of the autocorrelations, until it first falls below what noise without memory has.
    """
    total = 1.0
    count = len(missed)
    left = missed - missed.mean(axis=0)
    own = float((left**2).sum())
    if own == 0.0:
        return 1.0
    for lag in range(1, count // 3):
        share = float((left[lag:] * left[:-lag]).sum()) / own
        if share < 2.0 / math.sqrt(count):
            break
        total += 2.0 * share
    return total


@dataclass
class Refused:
    """A chosen coefficient that the data cannot tell."""

    chosen: Chosen
    """The coefficient, which stays at its start value."""
    why: str
    """The reason."""


def identify(problem: Problem, limits: Limits, starts: list[Floats], profiles: bool) -> tuple[list[int], Fitted, list[Refused], Fitted]:
    """Fits what the data can tell: the active coefficients, their fit, what is refused, and the fit without any coefficient."""
    before = problem.fit([], np.empty(0), starts)
    active = list(range(len(problem.chosen)))
    refused: list[Refused] = []
    # What no run depends on, and what is the same as another, can be told before any fit.
    while active:
        told = problem._told(active, np.ones(len(active)), before.starts, problem._least, before.misses)
        bad = _untold(problem, active, told, Limits(condition=1e6, deviation=math.inf))
        if bad is None:
            break
        refused.append(Refused(problem.chosen[active[bad[0]]], bad[1]))
        del active[bad[0]]
    factors, fitted = np.ones(len(active)), before
    starts = before.starts
    while active:
        fitted = problem.fit(active, factors, starts)
        bad = _untold(problem, active, fitted, limits)
        if bad is None and profiles:
            bad = _profiled(problem, active, fitted, limits)
        if bad is None:
            break
        refused.append(Refused(problem.chosen[active[bad[0]]], bad[1]))
        del active[bad[0]]
        factors, starts = np.delete(fitted.factors, bad[0]), fitted.starts
    if not active:
        fitted = before
    return active, fitted, refused, before


def _untold(problem: Problem, active: Sequence[int], fitted: Fitted, limits: Limits) -> tuple[int, str] | None:
    """The place of the coefficient that is told least, if it is told too little, and why."""
    deviations = np.sqrt(np.diag(fitted.covariance))
    idle = np.flatnonzero(~np.isfinite(deviations))
    if len(idle):
        return int(idle[0]), "no run depends on it"
    worst = int(np.argmax(deviations))
    if fitted.condition > limits.condition:
        mixed = np.argsort(-np.abs(fitted.directions[-1]))
        both = [place for place in mixed if abs(fitted.directions[-1][place]) > 0.2]
        worst = int(max(both, key=lambda place: deviations[place]))
        others = ", ".join(problem.chosen[active[place]].name for place in both if place != worst)
        return worst, f"the track does not tell it apart from {others or 'the state at the start'}: condition number {fitted.condition:.3g}, limit {limits.condition:g}"
    if deviations[worst] > limits.deviation:
        return worst, f"its standard error is {100 * deviations[worst]:.0f} %, limit {100 * limits.deviation:g} %"
    for place, index in enumerate(active):
        chosen, value = problem.chosen[index], fitted.factors[place]
        if limits.deviation < math.inf and (value - chosen.low < 1e-4 or chosen.high - value < 1e-4):
            return place, f"the fit runs into its bound, a factor of {value:.4g}: the bound decides and not the track"
    return None


def _profiled(problem: Problem, active: Sequence[int], fitted: Fitted, limits: Limits) -> tuple[int, str] | None:
    deviations = np.sqrt(np.diag(fitted.covariance))
    correlations = fitted.covariance / np.outer(deviations, deviations)
    np.fill_diagonal(correlations, 0.0)
    for place in np.argsort(-deviations):
        is_weak = deviations[place] > limits.weak or np.abs(correlations[place]).max() > limits.correlation
        if not is_weak:
            continue
        name = problem.chosen[active[place]].name
        profile = problem.profile(active, fitted, int(place))
        fitted.profiles[name] = profile
        if profile.low is None or profile.high is None:
            side = "both bounds" if profile.low is None and profile.high is None else "its lower bound" if profile.low is None else "its upper bound"
            return int(place), f"its 95 % band by the profile of the likelihood reaches {side}"
    return None

