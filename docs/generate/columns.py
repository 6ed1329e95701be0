"""The reference of result columns, from the table that the program writes its files by."""

import json
from pathlib import Path

from markdown import table


def page(columns_json: str) -> str:
    parts = [
        "# Result columns\n",
        "`fenderline run` writes these tables, as csv or, with `--format parquet`, as Parquet. Tables of fenders, vessels, "
        "thrusters, azimuth units, tugs and lines exist only where the scenario has any. `summary.json` and `report.html` "
        "stand beside them.\n",
        "A row stands for one output interval: one time step, or as many as `[output] interval` of the scenario says (in runs of "
        "more than 10 000 steps several by default). States are those at its start, forces are means over it, columns that begin "
        "with `peak_` hold the largest of any step, works are sums.\n",
        "This page is made from what `fenderline columns --json` prints. A unit of `1` is a pure "
        "number; `-` is a text or a truth value.\n",
    ]
    for name, columns in json.loads(Path(columns_json).read_text(encoding="utf-8")).items():
        parts.append(f"## `{name}`\n")
        parts.append(table(["column", "unit", "meaning"], [[f"`{c}`", unit, meaning] for c, unit, meaning in columns]))
    return "\n".join(parts)
