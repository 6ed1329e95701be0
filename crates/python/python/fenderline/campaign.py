"""Campaigns: thousands of runs of one scenario, with values drawn from distributions.

The campaign's file is that of the program's ``fenderline campaign``; the table is the same, byte for byte, whoever made the runs.

>>> import pathlib, tempfile
>>> from fenderline import campaign
>>> folder = pathlib.Path(tempfile.mkdtemp())
>>> _ = (folder / "tug.toml").write_text(campaign.example_scenario())
>>> _ = (folder / "speeds.toml").write_text('''
... scenario = "tug.toml"
... number = 40
... [variable.speed]
... key = "body.tug.velocity.surge"
... distribution = "lognormal"
... mean = "2 kn"
... standard_deviation = "0.5 kn"
... ''')
>>> speeds = campaign.load(folder / "speeds.toml")
>>> len(speeds), speeds.variables
(40, ['speed'])
>>> campaign.run(speeds, folder / "out")
>>> sorted(path.name for path in (folder / "out").glob("cases.*"))
['cases.csv', 'cases.parquet']

On a cluster each worker must see the campaign's file under the same path. An executor is any object with ``submit``, as those of
``concurrent.futures`` and the client of ``dask.distributed``, or a function that maps a function over a list::

    campaign.run(speeds, out, executor=dask.distributed.Client("scheduler:8786"))
    campaign.run(speeds, out, executor=lambda work, parts: joblib.Parallel(-1)(joblib.delayed(work)(part) for part in parts))
    campaign.run(speeds, out, executor=lambda work, parts: ray.get([ray.remote(work).remote(part) for part in parts]))
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from fenderline._errors import CampaignError
from fenderline._native import Campaign
from fenderline._progress import shown

__all__ = ["Campaign", "evaluate", "example_scenario", "load", "read", "run", "salib_problem"]

#: A part of a campaign's runs: path of its file, fingerprint, first run and the one after the last.
Part = tuple[str, str, int, int]


def load(path: str | os.PathLike[str]) -> Campaign:
    """Reads a campaign's file. Errors are those of the program: ``ScenarioError`` with file and line, or ``CampaignError``."""
    return Campaign(os.fspath(path))


def example_scenario() -> str:
    """The text of a short scenario: a tug that meets a ship."""
    return (Path(__file__).parent / "scenarios" / "tug_4kn.toml").read_text(encoding="utf-8")


#: The campaign that this process made runs of last, by path and fingerprint.
_last: dict[tuple[str, str], Campaign] = {}


def _loaded(path: str, fingerprint: str) -> Campaign:
    key = (path, fingerprint)
    if key not in _last:
        own = load(path)
        if own.fingerprint != fingerprint:
            raise CampaignError(
                f"{path}: the campaign differs from the one that was started: its file, a file that it names or the program is "
                "another here"
            )
        _last.clear()
        _last[key] = own
    return _last[key]


def make_part(part: Part) -> bytes:
    """Makes a part of a campaign's runs on one thread, in whatever process this is called. Returns their rows."""
    path, fingerprint, first, last = part
    return _loaded(path, fingerprint).run(first, last, threads=1)


def run(
    campaign: Campaign | str | os.PathLike[str],
    out: str | os.PathLike[str],
    *,
    executor: Any = None,
    chunk: int | None = None,
    threads: int | None = None,
    progress: bool | Callable[[int, int], object] = False,
    replace: bool = False,
) -> None:
    """Makes all runs and writes ``cases.parquet`` and, for at most 100,000 runs, ``cases.csv`` into the folder ``out``.

    ``executor``: ``None`` for the threads of this machine, an object with ``submit``, or a function that maps a function over a list.
    ``chunk``: runs of one part, by default so many that there are about 200 parts. ``replace``: remove the campaign that the folder
    holds. The rows are held in memory until the end; a campaign that goes on after an interruption is the program's,
    ``fenderline campaign --resume``.
    """
    own = campaign if isinstance(campaign, Campaign) else load(campaign)
    count = len(own)
    folder = os.fspath(out)
    if not replace and (Path(folder) / "campaign.json").exists():
        raise CampaignError(f"{folder}: it holds a campaign already; use replace=True to begin again")
    size = max(1, -(-count // 200)) if chunk is None else chunk
    if size < 1:
        raise CampaignError("chunk must be at least 1")
    starts = range(0, count, size)
    with shown(progress, count) as advance:
        rows: list[bytes] = []
        parts = [(os.path.abspath(own.path), own.fingerprint, first, min(first + size, count)) for first in starts]
        if executor is None:
            made: Iterable[bytes] = (own.run(first, last, threads) for _, _, first, last in parts)
        elif hasattr(executor, "submit"):
            futures = [executor.submit(make_part, part) for part in parts]
            made = (future.result() for future in futures)
        elif callable(executor):
            made = executor(make_part, parts)
        else:
            raise TypeError("executor must be None, an object with `submit`, or a function of a function and a list")
        for (_, _, _, last), own_rows in zip(parts, made, strict=True):
            rows.append(own_rows)
            if advance is not None:
                advance(last)
    own.write(folder, rows, replace)


def read(out: str | os.PathLike[str]) -> Any:
    """The table of a campaign's folder as a ``pandas.DataFrame``; needs pandas and pyarrow."""
    import pandas

    return pandas.read_parquet(Path(out) / "cases.parquet")


def evaluate(
    campaign: Campaign, probabilities: ArrayLike, outputs: Sequence[str], threads: int | None = None
) -> NDArray[np.float64]:
    """Outputs at given probabilities: of shape (runs, outputs), from ``probabilities`` of shape (runs, variables), each between 0
    and 1. A variable's probability becomes its value by its law: 0.5 is the median."""
    points = np.atleast_2d(np.asarray(probabilities, dtype=float))
    return np.column_stack(campaign.evaluate(points, list(outputs), threads))


def salib_problem(campaign: Campaign) -> dict[str, Any]:
    """The problem of a campaign for SALib: its variables as independent probabilities. Sample it with SALib, pass the sample to
    :func:`evaluate`, and the outputs to SALib's analysis."""
    names = campaign.variables
    edge = 1e-12
    return {"num_vars": len(names), "names": names, "bounds": [[edge, 1.0 - edge]] * len(names)}
