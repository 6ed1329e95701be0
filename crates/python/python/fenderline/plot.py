"""Figures of results, by Matplotlib (``pip install matplotlib``).

Each function draws into ``ax``, or into a new figure, and returns the axes.

>>> import fenderline, fenderline.plot
>>> results = fenderline.run(fenderline.example("tug_4kn"))
>>> fenderline.plot.contact_forces(results).get_ylabel()
'normal force [kN]'
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline._names import unknown
from fenderline._results import Results, Table
from fenderline._runs import Runs

__all__ = ["contact_forces", "fenders", "runs", "states", "tracks"]

#: Units that are drawn in larger ones: factor and name.
_LARGER = {"N": (1e-3, "kN"), "J": (1e-3, "kJ"), "N·m": (1e-3, "kN·m"), "rad": (57.29577951308232, "deg")}


def _axes(ax: Any) -> Any:
    if ax is not None:
        return ax
    try:
        import matplotlib.pyplot as plt
    except ImportError as error:
        raise ImportError("figures need Matplotlib: pip install matplotlib") from error
    return plt.subplots(layout="constrained")[1]


def _scaled(table: Table, name: str) -> tuple[npt.NDArray[Any], str]:
    """A column in the unit that is drawn, and that unit."""
    values, unit = table[name], table.columns[name].unit
    factor, larger = _LARGER.get(unit, (1.0, unit))
    return values * factor, larger


def _each(table: Table, by: str, names: Sequence[str] | None) -> dict[str, npt.NDArray[np.bool_]]:
    """The rows of each name in a column of names."""
    own = table[by]
    known = list(dict.fromkeys(own.tolist()))
    for name in names or ():
        if name not in known:
            raise ValueError(unknown(by, name, known))
    return {name: own == name for name in names or known}


def _over_time(
    table: Table, by: str, column: str, label: str, names: Sequence[str] | None, ax: Any
) -> Any:
    ax = _axes(ax)
    values, unit = _scaled(table, column)
    for name, rows in _each(table, by, names).items():
        ax.plot(table["t_s"][rows], values[rows], label=name)
    ax.set(xlabel="time [s]", ylabel=f"{label} [{unit}]")
    if ax.get_legend_handles_labels()[0]:
        ax.legend()
    return ax


def contact_forces(results: Results, *, ax: Any = None) -> Any:
    """Normal force of each pair of bodies over time, the sum of its patches."""
    ax = _axes(ax)
    table = results["contacts"]
    pairs = [f"{a}, {b}" for a, b in zip(table["body_1"], table["body_2"], strict=True)]
    times = np.unique(results["bodies"]["t_s"])
    for pair in dict.fromkeys(pairs):
        rows = np.array([own == pair for own in pairs])
        at = np.searchsorted(times, table["t_s"][rows])
        force_kn = np.bincount(at, table["normal_force_n"][rows], len(times)) * 1e-3
        ax.plot(times, force_kn, label=pair)
    ax.set(xlabel="time [s]", ylabel="normal force [kN]")
    if pairs:
        ax.legend()
    return ax


def fenders(
    results: Results,
    column: str = "reaction_n",
    *,
    names: Sequence[str] | None = None,
    ax: Any = None,
) -> Any:
    """A column of the fenders' table over time: ``reaction_n``, ``deflection_m``, ``stored_j``. ``names`` chooses fenders."""
    label = column.rpartition("_")[0].replace("_", " ")
    return _over_time(results["fenders"], "fender", column, label, names, ax)


def states(
    results: Results, column: str = "v_mps", *, names: Sequence[str] | None = None, ax: Any = None
) -> Any:
    """A column of the bodies' table over time, as ``u_mps`` (surge), ``v_mps`` (sway), ``r_radps`` or ``heading_rad``."""
    label = results["bodies"].columns[column].meaning if column in results["bodies"] else column
    return _over_time(results["bodies"], "body", column, label, names, ax)


def tracks(results: Results, *, names: Sequence[str] | None = None, ax: Any = None) -> Any:
    """Tracks of the bodies in plan, north up; an arrow at the end points ahead."""
    ax = _axes(ax)
    table = results["bodies"]
    for name, rows in _each(table, "body", names).items():
        north, east, heading = (table[c][rows] for c in ("x_m", "y_m", "heading_rad"))
        (line,) = ax.plot(east, north, label=name)
        ahead = {"angles": "uv", "color": line.get_color(), "width": 0.004}
        ax.quiver(east[-1], north[-1], np.sin(heading[-1]), np.cos(heading[-1]), **ahead)
    ax.set(xlabel="east [m]", ylabel="north [m]")
    ax.set_aspect("equal", adjustable="datalim")
    ax.legend()
    return ax


def runs(many: Runs, x: str, y: str = "peak_normal_force_n", *, ax: Any = None) -> Any:
    """A column of ``many.to_pandas()`` over another, a point for each run, coloured by its verdict; needs pandas."""
    ax = _axes(ax)
    frame = many.to_pandas()
    for column in (x, y):
        if column not in frame:
            raise ValueError(unknown("column of the runs", column, frame.columns))
    for verdict in dict.fromkeys(frame["verdict"].tolist()):
        own = frame[frame["verdict"] == verdict]
        ax.scatter(own[x].to_numpy(), own[y].to_numpy(), s=12, label=verdict)
    ax.set(xlabel=x, ylabel=y)
    ax.legend()
    return ax
