"""The chapter of validation, from the rows of `fenderline validate --out`."""

import json
from pathlib import Path

from markdown import table


def page(validation_json: str) -> str:
    found = json.loads(Path(validation_json).read_text(encoding="utf-8"))
    parts = [
        "# Validation\n",
        "This page is made from the rows that `fenderline validate --out DIR` writes: results of this program beside "
        "published, computed and closed-form references.\n",
        f"{found['rows_within_tolerance']} of {found['rows']} numbers are within their tolerance, and "
        f"{found['statements_that_hold']} of {found['statements']} statements of the sources hold. A row with **no** does "
        "not match for a known reason, which its note gives. Any other mismatch fails the tests. "
        "[How the cases are described](validation/README.md) explains the standing of a reference, its uncertainty and the "
        "tolerance.\n",
    ]
    subjects = list(dict.fromkeys(row["subject"] for row in found["numbers"] + found["statement_rows"]))
    for subject in subjects:
        parts.append(f"## {subject}\n")
        numbers = [row for row in found["numbers"] if row["subject"] == subject]
        if numbers:
            parts.append(without_empty_notes(
                ["case", "standing", "reference", "ours", "unit", "error", "tolerance", "within", "note"],
                [[r["case"], r["standing"], short(r["published"]), short(r["ours"]), r["unit"], error(r), tolerance(r), yes(r), r["note"] or ""] for r in numbers],
            ))
        statements = [row for row in found["statement_rows"] if row["subject"] == subject]
        if statements:
            parts.append(without_empty_notes(
                ["case", "the source says", "holds if", "ours", "unit", "holds", "note"],
                [[r["case"], r["statement"], r["holds_if"], short(r["ours"]), r["unit"], yes(r), r["note"] or ""] for r in statements],
            ))
        sources = list(dict.fromkeys(row["source"] for row in numbers + statements))
        parts.append("Sources: " + "; ".join(sources) + ".\n")
    return "\n".join(parts)


def without_empty_notes(head: list[str], rows: list[list[str]]) -> str:
    """The table, without its last column where no row has a note."""
    if any(row[-1] for row in rows):
        return table(head, rows)
    return table(head[:-1], [row[:-1] for row in rows])


def short(value) -> str:
    if isinstance(value, list):
        return ", ".join(short(one) for one in value)
    return f"{value:.4g}" if isinstance(value, (int, float)) else str(value)


def error(row) -> str:
    return f"{100 * row['error']:.2g} %" if row["tolerance_kind"] == "relative" else short(row["error"])


def tolerance(row) -> str:
    return f"{100 * row['tolerance']:.2g} %" if row["tolerance_kind"] == "relative" else short(row["tolerance"])


def yes(row) -> str:
    return "yes" if row["ok"] else "**no**"
