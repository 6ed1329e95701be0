"""Whole runs, one and many."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from importlib import resources
from os import PathLike
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
import numpy.typing as npt

from fenderline._html import _table
from fenderline._names import unknown
from fenderline._native import Scenario, Simulation, run_variants
from fenderline._progress import shown
from fenderline._results import Results, Table

if TYPE_CHECKING:
    import pandas as _pandas

#: What functions take as a scenario: a scenario, a path, a text of TOML, or a tree of dictionaries.
AnyScenario = Scenario | str | PathLike[str] | Mapping[str, Any]


def _examples() -> list[str]:
    files = resources.files("fenderline").joinpath("scenarios").iterdir()
    return sorted(file.name.removesuffix(".toml") for file in files if file.name.endswith(".toml"))


def example(name: str) -> Scenario:
    """A scenario included in this package: ``tug_4kn`` or ``docking``.

    >>> example("tug_4kn").bodies
    ['ship', 'tug']
    """
    if name not in _examples():
        raise ValueError(unknown("example", name, _examples()))
    text = resources.files("fenderline").joinpath("scenarios", f"{name}.toml").read_text("utf-8")
    return Scenario.parse(text, f"{name}.toml")


def run(
    scenario: AnyScenario, set: Mapping[str, Any] | Iterable[str] | None = None
) -> Results:
    """Runs a scenario to its end: the tables of ``fenderline run``, with the same numbers.

    ``scenario`` is a :class:`Scenario` or what ``Scenario(...)`` takes: a path, a text of TOML, or a tree of dictionaries.
    ``set`` replaces keys, as ``--set`` does.

    >>> results = run(example("tug_4kn"), {"time.step": "0.05 s"})
    >>> float(results["contacts"]["depth_m"].max().round(2))
    0.94
    """
    simulation = Simulation(Scenario(scenario, set), record=True)
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
    dolphins: Table
    """One row for every flexible dolphin in a run; ``run`` is its number."""
    berthings: Table
    """The berthing energy of each run by the formula and in the fenders, first and later hits apart, where the
    scenario has a ``[berthing]``; ``run`` is its number."""
    verdicts: Table
    """The verdict on each run: its worst finding, such as ``fender_failed``."""
    findings: Table
    """What was found in each run, the worst first; ``run`` is its number."""
    variants: list[dict[str, Any]]
    """The keys and values of each run."""

    def to_pandas(self) -> _pandas.DataFrame:
        """A data frame with one row for each run: its keys, its verdict, the hardest contact, the worst fender and the berthing
        energies; needs ``pandas``. The tables have ``to_pandas`` too.

        >>> runs = run_many(example("tug_4kn"), {"body.tug.velocity.surge": [1.0, 2.0]})
        >>> runs.to_pandas()[["body.tug.velocity.surge", "verdict"]].values.tolist()
        [[1.0, 'not_rated'], [2.0, 'not_rated']]
        """
        import pandas as pd

        keys = list(dict.fromkeys(key for variant in self.variants for key in variant))
        frame = pd.DataFrame(
            {key: [variant.get(key) for variant in self.variants] for key in keys},
            index=pd.RangeIndex(len(self.states), name="run"),
        )
        frame["verdict"] = self.verdicts["verdict"]
        frame["gravity"] = self.verdicts["gravity"]
        pairs = self.pairs.to_pandas().groupby("run")
        frame["peak_normal_force_n"] = pairs["peak_normal_force_n"].max()
        if self.fenders.rows:
            fenders = self.fenders.to_pandas().astype({"fender": "str"})
            fenders = fenders.sort_values("peak_energy_j").groupby("run").last()
            shown = ["peak_deflection_m", "peak_reaction_n", "peak_energy_j"]
            shown += ["share_of_rated_energy", "share_of_rated_reaction", "failed"]
            frame["fender"] = fenders["fender"]
            frame[shown] = fenders[shown]
        if self.berthings.rows:
            frame = frame.join(self.berthings.to_pandas().set_index("run").add_prefix("berthing_"))
        return frame

    def _repr_html_(self) -> str:
        verdicts = self.verdicts["verdict"].tolist()
        rows = [(kind, verdicts.count(kind)) for kind in sorted({*verdicts})]
        return f"<p>{len(verdicts)} runs</p>" + _table(["verdict", "runs"], rows)


def run_many(
    scenario: AnyScenario,
    variants: Sequence[Mapping[str, Any]] | Mapping[str, Sequence[Any] | npt.NDArray[Any]],
    *,
    threads: int | None = None,
    progress: bool | Callable[[int, int], object] = False,
) -> Runs:
    """Runs many variants of a scenario on all cores, or on the given number of ``threads``.

    ``variants`` is a sequence of dictionaries of keys and values, one per run; or one dictionary that has for each key a
    sequence with one value per run. Results are in the order of the variants and do not depend on the number of
    threads, bit for bit. Other Python threads can run meanwhile.

    ``progress=True`` shows a bar of tqdm if that is installed, else a line on the standard error; a function is called
    with the number of runs that are done and that of all. Ctrl-C stops at once. A run that fails stops the others: the
    exception names its number, in its message and as ``error.run``.

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
        lengths = {key: len(values) for key, values in columns.items()}
        if len({*lengths.values()}) > 1:
            raise ValueError(f"each key needs one value per run, but their numbers are {lengths}")
        rows = zip(*columns.values(), strict=True)
        sets = [dict(zip(columns, row, strict=True)) for row in rows]
    else:
        sets = [dict(variant) for variant in variants]
    given = dict(variants) if isinstance(variants, Mapping) else sets
    with shown(progress, len(sets)) as advance:
        states, results = run_variants(Scenario(scenario), given, threads, advance)
    return Runs(
        states,
        results["pairs"],
        results["fenders"],
        results["dolphins"],
        results["berthings"],
        results["verdicts"],
        results["findings"],
        sets,
    )
