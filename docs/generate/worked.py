"""The page of worked examples: published berthings beside the runs of the same ships, from the rows of
`fenderline validate --out`."""

import json
from pathlib import Path

from markdown import table
from validation import error, short

SUBJECT = "Worked examples of berthing"

# Heading, scenarios, cases by their beginning, and who is right.
EXAMPLES = [
    (
        "A supply ship broadside on five fenders", ["fleet_ship_broadside"], "T-AKE broadside",
        "The energies agree. The deflections do not, and the calculator is wrong: its polynomials for energy and for reaction "
        "do not belong to each other. The work of its reaction up to its own deflection is 1.8 times the energy that it shows "
        "there.",
    ),
    (
        "The same ship at her quarter point", ["fleet_ship_quarter_point"], "T-AKE at the quarter point",
        "Both are right. The calculator takes K²/(a² + K²) of the energy: that of a fender without friction. With the facing's "
        "friction a fender takes more, up to Ce of a contact that does not slide.",
    ),
    (
        "A ship of 39,000 t at her quarter point, 5°", ["case_study_39000_t"], "39,000 t",
        "The energy agrees. The Ce of 0.5 that the case study prints does not follow from its own formula, which gives 0.565; "
        "its energy was computed with the latter.",
    ),
    (
        "A container ship of 208,000 t at 6°", ["container_ship_vizhinjam"], "208,000 t",
        "The energy agrees for the point of contact that the sheet computes with, 68.9 m from the middle. The sheet calls it the "
        "quarter point, which is at 94 m and would give less energy: the sheet contradicts itself, on the safe side.",
    ),
    (
        "Four fenders of constant reaction", ["textbook_four_fenders"], "12,000 t on four fenders",
        "Both are right: ½ M V² = F δ. The small rest is the first millimetre, over which the fender's reaction rises.",
    ),
    (
        "A bulk carrier at the third point, 5°", ["bulk_carrier_third_point"], "Bulk carrier",
        "Both are right. In the run the arm of the contact changes a little while the fender is compressed.",
    ),
]


def page(validation_json: str) -> str:
    found = json.loads(Path(validation_json).read_text(encoding="utf-8"))
    rows = [row for row in found["numbers"] if row["subject"] == SUBJECT]
    parts = [
        "# Worked examples\n",
        "Published examples of berthing energy, and the same ships in runs of this program. The numbers are the rows of "
        "`fenderline validate`; each scenario runs with `fenderline run`. A formula gives one energy for the whole berthing. "
        "A run gives what each fender takes. Where an example contradicts itself, this page says where.\n",
    ]
    used = []
    for heading, scenarios, begin, verdict in EXAMPLES:
        own = [row for row in rows if row["case"].startswith(begin)]
        if not own:
            raise SystemExit(f"worked examples: no row begins with {begin!r}")
        used += own
        parts.append(f"## {heading}\n")
        parts += [f"```{{literalinclude}} ../../scenarios/worked/{name}.toml\n:language: toml\n:end-before: title\n```\n" for name in scenarios]
        parts.append(table(
            ["case", "published", "ours", "unit", "difference"],
            [[row["case"], short(row["published"]), short(row["ours"]), row["unit"], error(row)] for row in own],
        ))
        parts.append(verdict + "\n")
        parts += [f"Note: {row['note']}\n" for row in own if row["note"]]
        parts.append("Source: " + "; ".join(dict.fromkeys(row["source"] for row in own)) + f". Scenario: `scenarios/worked/{scenarios[0]}.toml`.\n")
    missing = [row["case"] for row in rows if row not in used]
    if missing:
        raise SystemExit(f"worked examples: no section shows {missing}")
    return "\n".join(parts)
