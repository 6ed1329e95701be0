"""Writes the generated pages and figures of the book into docs/_generated, which git ignores.

    python docs/generate PROGRAM VALIDATION.json SWEEPS.json COLUMNS.json

PROGRAM is the built `fenderline`, VALIDATION.json what `fenderline validate --out` wrote, SWEEPS.json what `fenderline
validate --sweeps --out` wrote, with its pictures beside it, and COLUMNS.json what `fenderline columns --json` printed.
`cargo xtask book` calls this script.
"""

import shutil
import sys
from pathlib import Path

import columns
import commands
import figures
import keys
import pages
import protocol
import sweeps
import validation
import worked

FOLDER = Path(__file__).resolve().parent.parent / "_generated"


def main() -> None:
    program, validation_json, sweeps_json, columns_json = sys.argv[1:5]
    if FOLDER.exists():
        shutil.rmtree(FOLDER)
    for made in ["reference", "figures"]:
        (FOLDER / made).mkdir(parents=True)
    for name, text in {
        **keys.pages(program),
        "reference/columns.md": columns.page(columns_json),
        "reference/commands.md": commands.page(program),
        "reference/protocol.md": protocol.page(),
        "validation.md": validation.page(validation_json),
        "sweeps.md": sweeps.page(sweeps_json, FOLDER / "figures"),
        "worked_examples.md": worked.page(validation_json),
        **pages.from_repository(),
    }.items():
        path = FOLDER / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    figures.draw_all(program, FOLDER / "figures")


if __name__ == "__main__":
    main()
