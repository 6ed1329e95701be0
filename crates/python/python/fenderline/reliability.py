"""Rare events: the limit state of a campaign as a function of OpenTURNS, and recipes around it.

A campaign's file has the random variables of a berthing and, in ``[limit.NAME]``, what should seldom be exceeded. This module makes
them a function for OpenTURNS, whose samples are run together on all cores, and estimates how often the limit is exceeded:

    from fenderline import reliability

    state = reliability.LimitState("campaigns/rare_event.toml", "rated")
    near = reliability.form(state)                            # the design point, some hundred runs
    print(reliability.importance_sampling(state, near, runs=2000))
    print(reliability.subset_simulation(state, runs=10_000))

The inputs of the function are independent standard normal scores, one for each variable of the campaign: -1.645, 0 and 1.645 are the
values that 5 %, half and 95 % of the berthings stay below. Needs OpenTURNS: ``pip install "fenderline[reliability]"``.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline import campaign as _campaign
from fenderline._errors import Error
from fenderline._names import unknown
from fenderline._native import Campaign
from fenderline._progress import shown

__all__ = [
    "DesignPoint",
    "Estimate",
    "LimitState",
    "ReliabilityError",
    "along",
    "bound",
    "form",
    "importance_sampling",
    "plain",
    "sorm",
    "subset_simulation",
]

Floats = npt.NDArray[np.float64]

#: Margin where nothing touched: as if the output were 0.
_UNTOUCHED = 1.0
#: Runs of a plain campaign that are made together.
_BLOCK = 50_000


class ReliabilityError(Error, ValueError):
    """A limit state that cannot be computed, or a method that found no result."""


def _openturns() -> Any:
    try:
        import openturns
    except ImportError:
        raise ReliabilityError('rare events need OpenTURNS: pip install "fenderline[reliability]"') from None
    return openturns


class LimitState:
    """The margin of a campaign to one of its limits, ``1 - output / limit``: 0 at the limit, below 0 beyond.

    ``limit`` is the name of a ``[limit.NAME]`` of the campaign's file. ``function``, ``distribution`` and ``event`` are OpenTURNS'
    objects, for methods beyond those of this module. Each point that is computed is one run, and ``runs`` counts them. A run in which
    nothing touches is safe. A run that fails raises :class:`ReliabilityError` with the values that it had.
    """

    def __init__(self, campaign: Campaign | str | os.PathLike[str], limit: str, *, threads: int | None = None) -> None:
        ot = _openturns()
        self.campaign: Campaign = campaign if isinstance(campaign, Campaign) else _campaign.load(campaign)
        self.limit = limit
        self.output, self.value = self._limit(limit)
        self.threads = threads
        #: Number of runs so far.
        self.runs = 0
        #: Number of variables.
        self.dimension: int = len(self.campaign.variables)
        self.function: Any = ot.PythonFunction(self.dimension, 1, func_sample=lambda sample: self.margins(np.asarray(sample, dtype=float)).reshape(-1, 1))
        self.function.setInputDescription(self.campaign.variables)
        self.function.setOutputDescription([f"margin to {limit}"])
        self.distribution: Any = ot.Normal(self.dimension)
        self.event: Any = ot.ThresholdEvent(ot.CompositeRandomVector(self.function, ot.RandomVector(self.distribution)), ot.LessOrEqual(), 0.0)

    def _limit(self, name: str) -> tuple[str, float]:
        """Column and value of a limit, the value in the unit of the column."""
        path, limits = self.campaign.path, {each: (output, value) for each, output, value in self.campaign.limits}
        if name not in limits:
            raise ReliabilityError(f"{path}: {unknown('limit', name, limits)}")
        output, value = limits[name]
        if not value > 0.0:
            raise ReliabilityError(f"{path}: limit.{name}: the value must be above 0, but is {value:g}")
        return output, value

    def margins(self, scores: Floats) -> Floats:
        """Margins at points of standard normal scores: of shape (runs,), from (runs, variables)."""
        if scores.ndim != 2 or scores.shape[1] != self.dimension or not np.isfinite(scores).all():
            raise ReliabilityError(f"scores are numbers of shape (runs, {self.dimension}), but have the shape {scores.shape}")
        flat = [0.5 * math.erfc(-score * math.sqrt(0.5)) for score in scores.ravel().tolist()]
        return self.margins_at(np.reshape(flat, scores.shape))

    def margins_at(self, probabilities: Floats) -> Floats:
        """Margins at points of probabilities, each between 0 and 1: of shape (runs,), from (runs, variables)."""
        points = np.clip(probabilities, 1e-300, 1.0 - 2.0**-53)
        values = _campaign.evaluate(self.campaign, points, [self.output, "fenders_touched"], self.threads)
        self.runs += len(points)
        margins = 1.0 - values[:, 0] / self.value
        untouched = np.isnan(margins) & (values[:, 1] == 0.0)
        margins[untouched] = _UNTOUCHED
        failed = np.flatnonzero(~np.isfinite(margins))
        if len(failed):
            raise ReliabilityError(f"{len(failed)} of {len(points)} runs gave no {self.output}; the first had {self.values(points[failed[0]])}")
        return margins

    def values(self, probabilities: Floats) -> dict[str, float | str | None]:
        """The values of the variables at probabilities."""
        return self.campaign.at([float(value) for value in probabilities])

    def values_at(self, scores: Floats) -> dict[str, float | str | None]:
        """The values of the variables at standard normal scores."""
        return self.values(np.array([min(max(0.5 * math.erfc(-score * math.sqrt(0.5)), 1e-300), 1.0 - 2.0**-53) for score in scores]))


@dataclass(frozen=True)
class Estimate:
    """An estimate of the probability that the limit is exceeded in one berthing."""

    method: str
    """The method."""
    probability: float
    """The probability."""
    low: float
    """Lower edge of the 95 % band; NaN for a method that has no band."""
    high: float
    """Upper edge of the 95 % band; NaN for a method that has no band."""
    runs: int
    """Number of runs, without those that found the design point; of a plain campaign, the number of berthings."""

    @property
    def once_in(self) -> float:
        """Number of berthings in which the limit is exceeded once."""
        return math.inf if self.probability == 0.0 else 1.0 / self.probability

    def __str__(self) -> str:
        band = "no band" if math.isnan(self.low) else f"95 % band {self.low:.2e} to {self.high:.2e}"
        return f"{self.method}: {self.probability:.3e}, once in {self.once_in:,.0f} berthings, {band}, {self.runs:,} runs"


@dataclass(frozen=True)
class DesignPoint:
    """The most likely point at which the limit is reached, and FORM's estimate."""

    scores: Floats
    """Standard normal scores."""
    values: dict[str, float | str | None]
    """Values of the variables."""
    index: float
    """Distance from the median berthing: the reliability index."""
    importance: dict[str, float]
    """Share of each variable in the distance; the shares add up to 1."""
    margin: float
    """Margin at the point: 0 but for the error of the search."""
    estimate: Estimate
    """FORM's estimate."""
    others: list[DesignPoint] = field(default_factory=list)
    """Further design points that other starts found; then FORM counts the nearest alone."""


def form(state: LimitState, *, starts: int = 6, seed: int = 1, step: float = 0.02, most_iterations: int = 60) -> DesignPoint:
    """The design point by FORM (Abdo and Rackwitz), from ``starts`` starts.

    A start is the worst of 60 runs that are drawn wider than the distribution. ``step``: of the finite differences, in standard
    deviations; a limit state with noise or steps needs a larger one. Raises :class:`ReliabilityError` if no start leads to the limit.
    """
    ot = _openturns()
    if starts < 1:
        raise ReliabilityError(f"starts must be at least 1, but is {starts}")
    draw = np.random.default_rng(seed)
    before = state.runs
    function = ot.Function(state.function)
    function.setGradient(ot.CenteredFiniteDifferenceGradient(step, function.getEvaluation()))
    event = ot.ThresholdEvent(ot.CompositeRandomVector(function, ot.RandomVector(state.distribution)), ot.LessOrEqual(), 0.0)
    found: list[tuple[float, Floats, Floats, float]] = []
    reasons = []
    for _ in range(starts):
        tried = 2.0 * draw.standard_normal((60, state.dimension))
        start = tried[int(np.argmin(state.margins(tried)))]
        search = ot.AbdoRackwitz()
        search.setStartingPoint(start.tolist())
        search.setMaximumIterationNumber(most_iterations)
        search.setMaximumAbsoluteError(1e-3)
        search.setMaximumConstraintError(1e-3)
        method = ot.FORM(search, event)
        try:
            method.run()
        except Exception as error:
            # A failed run says what is wrong; a search that stops says only that it stopped.
            if isinstance(error.__cause__, Error) or "gave no" in str(error):
                raise ReliabilityError(str(error)) from error
            reasons.append(str(error).strip().splitlines()[-1])
            continue
        result = method.getResult()
        point = np.array(result.getStandardSpaceDesignPoint())
        margin = float(state.margins(point[None, :])[0])
        if abs(margin) > 0.02:
            reasons.append(f"it ended at a margin of {margin:.3f}")
            continue
        shares = np.array(result.getImportanceFactors())
        found.append((float(np.linalg.norm(point)), point, shares, margin))
    if not found:
        raise ReliabilityError(f"no design point from {starts} starts: {'; '.join(reasons)}. Is the limit reached at all? Use subset simulation, which needs no design point")
    runs = state.runs - before
    distinct: list[tuple[float, Floats, Floats, float]] = []
    for one in sorted(found, key=lambda each: each[0]):
        if all(np.linalg.norm(one[1] - other[1]) > 0.5 for other in distinct):
            distinct.append(one)

    def named(one: tuple[float, Floats, Floats, float], others: list[DesignPoint]) -> DesignPoint:
        index, point, shares, margin = one
        probability = 0.5 * math.erfc(index * math.sqrt(0.5))
        estimate = Estimate("FORM", probability, math.nan, math.nan, runs)
        importance = dict(zip(state.campaign.variables, shares.tolist(), strict=True))
        return DesignPoint(point, state.values_at(point), index, importance, margin, estimate, others)

    return named(distinct[0], [named(one, []) for one in distinct[1:]])


def sorm(state: LimitState, near: DesignPoint, *, step: float = 0.1) -> Estimate:
    """Breitung's estimate, with the curvature of the limit at the design point."""
    ot = _openturns()
    before = state.runs
    function = ot.Function(state.function)
    function.setGradient(ot.CenteredFiniteDifferenceGradient(step, function.getEvaluation()))
    function.setHessian(ot.CenteredFiniteDifferenceHessian(step, function.getEvaluation()))
    slope = np.array(function.gradient(near.scores.tolist()))[:, 0]
    length = float(np.linalg.norm(slope))
    if length == 0.0:
        raise ReliabilityError("the margin has no slope at the design point: the limit state has a step there")
    hessian = np.array(function.hessian(near.scores.tolist()))[:, :, 0]
    # Axes whose last points from the median to the design point.
    axes, _ = np.linalg.qr(np.column_stack([near.scores, np.eye(state.dimension)]))
    across = axes[:, 1 : state.dimension]
    curvatures = np.linalg.eigvalsh(across.T @ hessian @ across / length) if state.dimension > 1 else np.empty(0)
    factors = 1.0 + near.index * curvatures
    if (factors <= 0.0).any():
        raise ReliabilityError("the limit bends towards the median more than a sphere about it: Breitung's formula does not hold. Use importance sampling")
    probability = near.estimate.probability / math.sqrt(float(np.prod(factors)))
    return Estimate("SORM (Breitung)", probability, math.nan, math.nan, state.runs - before)


def importance_sampling(state: LimitState, near: DesignPoint, *, runs: int = 2000, seed: int = 1, block: int = 250) -> Estimate:
    """Importance sampling about the design point: normal scores with the design point as mean, each run with the ratio of the densities
    as its weight. Where there are further design points the scores are drawn about each of them alike."""
    ot = _openturns()
    if runs < block or block < 2:
        raise ReliabilityError(f"importance sampling needs at least a block of {block} runs, but has {runs}")
    before = state.runs
    ot.RandomGenerator.SetSeed(seed)
    about = [ot.Normal(point.scores.tolist(), ot.CovarianceMatrix(state.dimension)) for point in (near, *near.others)]
    density = about[0] if len(about) == 1 else ot.Mixture(about)
    experiment = ot.ImportanceSamplingExperiment(density)
    method = ot.ProbabilitySimulationAlgorithm(state.event, experiment)
    method.setBlockSize(block)
    method.setMaximumOuterSampling(runs // block)
    method.setMaximumCoefficientOfVariation(-1.0)
    method.run()
    result = method.getResult()
    probability, share = float(result.getProbabilityEstimate()), float(result.getCoefficientOfVariation())
    return Estimate("importance sampling", probability, max(0.0, probability * (1.0 - 1.96 * share)), probability * (1.0 + 1.96 * share), state.runs - before)


def subset_simulation(state: LimitState, *, runs: int = 10_000, seed: int = 1, most_steps: int = 8) -> Estimate:
    """Subset simulation: the limit is approached in steps, each of which one in ten runs passes. Needs no design point.

    ``runs`` of one step are so many that all ``most_steps`` steps take no more than ``runs``; a probability below 10 to the power of minus
    ``most_steps`` is not reached. The band is lognormal. Its coefficient of variation takes the steps after the first as wholly dependent,
    which is the upper bound: OpenTURNS' own coefficient takes them as independent, and its band is too narrow.
    """
    ot = _openturns()
    each = runs // most_steps // 10 * 10
    if each < 100:
        raise ReliabilityError(f"subset simulation needs at least 100 runs a step, that is {100 * most_steps}, but has {runs}")
    before = state.runs
    # OpenTURNS stops where its estimate of a variance comes out negative, once in some hundred tries: then the next stream is taken.
    for stream in range(4):
        ot.RandomGenerator.SetSeed(seed + 1_000_000 * stream)
        method = ot.SubsetSampling(state.event)
        method.setBlockSize(each // 10)
        method.setMaximumOuterSampling(10)
        method.setMinimumProbability(10.0**-most_steps)
        try:
            method.run()
            break
        except (RuntimeError, TypeError) as error:
            if isinstance(error.__cause__, Error) or "gave no" in str(error):
                raise ReliabilityError(str(error)) from error
            reason = str(error).strip().splitlines()[-1]
            if stream == 3 or "variance estimate" not in reason:
                raise ReliabilityError(f"subset simulation stopped: {reason}. Below {10.0**-most_steps:g} take more runs and more steps") from error
    result = method.getResult()
    probability = float(result.getProbabilityEstimate())
    if not probability > 0.0:
        raise ReliabilityError(f"the limit was not reached in {most_steps} steps: its probability is below {10.0**-most_steps:g}")
    share = bound(np.array(method.getCoefficientOfVariationPerStep()), each)
    spread = 1.96 * math.sqrt(math.log1p(share**2))
    return Estimate("subset simulation", probability, probability * math.exp(-spread), probability * math.exp(spread), state.runs - before)


def bound(shares: Floats, each: int) -> float:
    """The upper bound of the coefficient of variation of subset simulation, from OpenTURNS' coefficients up to each step and the number of
    runs of a step. OpenTURNS takes the first step as exact, and each further step as independent of the steps before."""
    rises = np.sqrt(np.maximum(np.diff(shares**2), 0.0))
    # One in ten runs passes the first step.
    return math.hypot(float(rises.sum()), math.sqrt(9.0 / each))


def plain(
    state: LimitState,
    *,
    runs: int,
    seed: int = 1,
    safe: Callable[[Floats], npt.NDArray[np.bool_]] | None = None,
    progress: bool | Callable[[int, int], object] = False,
) -> Estimate:
    """A plain campaign: ``runs`` berthings that are drawn at random, with the band of Clopper and Pearson.

    ``safe`` takes probabilities of shape (runs, variables) and says which of these berthings cannot exceed the limit, by a bound such as
    that of the ship's energy: they are counted without a run.
    """
    ot = _openturns()
    if runs < 1:
        raise ReliabilityError(f"runs must be at least 1, but is {runs}")
    beyond = 0
    with shown(progress, runs) as advance:
        for block, first in enumerate(range(0, runs, _BLOCK)):
            # A stream for each block: a campaign that is made in parts has the same berthings.
            draw = np.random.default_rng([seed, block])
            drawn = draw.random((min(_BLOCK, runs - first), state.dimension))
            if safe is not None:
                drawn = drawn[~safe(drawn)]
            beyond += int(np.count_nonzero(state.margins_at(drawn) <= 0.0)) if len(drawn) else 0
            if advance is not None:
                advance(min(first + _BLOCK, runs))
    low = 0.0 if beyond == 0 else float(ot.Beta(beyond, runs - beyond + 1, 0.0, 1.0).computeQuantile(0.025)[0])
    high = 1.0 if beyond == runs else float(ot.Beta(beyond + 1, runs - beyond, 0.0, 1.0).computeQuantile(0.975)[0])
    return Estimate("plain campaign", beyond / runs, low, high, runs)


def along(state: LimitState, near: DesignPoint, *, points: int = 41, to: float = 1.5) -> Mapping[str, Floats]:
    """Margins on the way from the median berthing through the design point and beyond, ``to`` times as far: a look at them shows steps and
    noise, which mislead FORM. Returns ``share`` (1 at the design point) and ``margin``."""
    share = np.linspace(0.0, to, points)
    return {"share": share, "margin": state.margins(share[:, None] * near.scores[None, :])}
