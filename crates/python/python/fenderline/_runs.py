"""Whole runs, one and many."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import resources
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from fenderline._native import Scenario, Simulation, run_variants
from fenderline._results import Results, Table


def example(name: str) -> Scenario:
    """A scenario included in this package: ``tug_4kn`` or ``docking``.

    >>> example("tug_4kn").bodies
    ['ship', 'tug']
    """
    text = resources.files("fenderline").joinpath("scenarios", f"{name}.toml").read_text("utf-8")
    return Scenario.parse(text, f"{name}.toml")


def run(scenario: Scenario) -> Results:
    """Runs a scenario to its end: the tables of ``fenderline run``, with the same numbers.

    >>> results = run(example("tug_4kn"))
    >>> float(results["contacts"]["depth_m"].max().round(2))
    1.03
    """
    simulation = Simulation(scenario, record=True)
    simulation.run()
    return simulation.results()


class Runs(NamedTuple):
    """The results of :func:`run_many`."""

    states: npt.NDArray[np.float64]
    """States at the end: (runs, bodies, 6), columns as in :attr:`Simulation.states`."""
    pairs: Table
    """One row for every pair of bodies that touched in a run; ``run`` is its number."""
    fenders: Table
    """One row for every fender that was touched in a run; ``run`` is its number."""
    verdicts: Table
    """The verdict on each run: its worst finding, such as ``fender_failed``."""
    findings: Table
    """What was found in each run, the worst first; ``run`` is its number."""


def run_many(
    scenario: Scenario,
    variants: Sequence[Mapping[str, Any]] | Mapping[str, Sequence[Any] | npt.NDArray[Any]],
    *,
    threads: int | None = None,
) -> Runs:
    """Runs many variants of a scenario on all cores, or on the given number of ``threads``.

    ``variants`` is a sequence of dictionaries of keys and values, one per run; or one dictionary that has for each key a
    sequence with one value per run. Results are in the order of the variants and do not depend on the number of
    threads, bit for bit. Other Python threads can run meanwhile.

    >>> runs = run_many(example("tug_4kn"), {"body.tug.velocity.surge": [0.5, 1.0, 2.0]})
    >>> runs.pairs["run"].tolist(), runs.states.shape
    ([0, 1, 2], (3, 2, 6))
    >>> bool((np.diff(runs.pairs["peak_normal_force_n"]) > 0).all())
    True
    >>> runs.verdicts["verdict"].tolist()  # two steel hulls touch: no limit is known
    ['not_rated', 'not_rated', 'not_rated']
    """
    if isinstance(variants, Mapping):
        columns = {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in variants.items()}
        rows = zip(*columns.values(), strict=True)
        variants = [dict(zip(columns, row, strict=True)) for row in rows]
    states, results = run_variants(scenario, variants, threads)
    return Runs(
        states, results["pairs"], results["fenders"], results["verdicts"], results["findings"]
    )
