"""How notebooks show scenarios, simulations and results."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from html import escape
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from fenderline._native import Scenario, Simulation
    from fenderline._results import Results, Table

#: Rows at the start and the end of a long table.
SHOWN = 5


def _table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    def line(tag: str, cells: Iterable[object]) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(str(cell))}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(line("td", row) for row in rows)
    return f"<table><thead>{line('th', head)}</thead><tbody>{body}</tbody></table>"


def _number(value: object) -> object:
    return f"{value:.6g}" if isinstance(value, float) else value


def table(of: Table) -> str:
    """Name, first and last rows of a table."""
    head = [name if c.unit in "1-" else f"{name} [{c.unit}]" for name, c in of.columns.items()]
    count = of.rows
    which = [*range(min(count, SHOWN)), *range(max(count - SHOWN, min(count, SHOWN)), count)]
    columns = [of[name][which].tolist() for name in of]
    rows: list[Sequence[object]] = [[_number(v) for v in row] for row in zip(*columns, strict=True)]
    if count > 2 * SHOWN:
        rows.insert(SHOWN, ["…"] * len(head))
    return f"<p>{escape(of.name)}: {count} rows</p>" + _table(head, rows)


def results(of: Results) -> str:
    """The tables of a run."""
    rows = [(name, table.rows, ", ".join(table)) for name, table in of.items()]
    return f"<p>{escape(of.title)}</p>" + _table(["table", "rows", "columns"], rows)


def scenario(of: Scenario) -> str:
    """Title, duration, bodies, fenders and notices."""
    rows = [
        ("file", of.name),
        ("duration", f"{of.duration_s:g} s in steps of {of.step_s:g} s"),
        ("bodies", ", ".join(of.bodies)),
        ("fenders", ", ".join(of.fenders) or "none"),
        *(("notice", notice) for notice in of.notices),
    ]
    return f"<p>{escape(of.title)}</p>" + _table(["scenario", ""], rows)


def simulation(of: Simulation) -> str:
    """Time, verdict and states."""
    text = f"<p>{escape(of.title)}: {of.time_s:g} s, {escape(of.verdict)}</p>"
    head = ["body", "north [m]", "east [m]", "heading [rad]", "north [m/s]", "east [m/s]"]
    states = of.states.tolist()
    rows = [[n, *map(_number, s[:5])] for n, s in zip(of.bodies, states, strict=True)]
    return text + _table(head, rows)
