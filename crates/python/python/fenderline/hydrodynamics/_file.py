"""The file that a scenario names, read back."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from fenderline.hydrodynamics._data import FORM, Hydrodynamics, Matrix
from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._text import lines, numbers

Row = dict[str, float]


def read(path: Path) -> Hydrodynamics:
    """Reads a file, for its picture and its motions. The simulation's own reader checks more."""
    head, tables = _tables(path)
    for name in ("ship", "radiation", "infinite", "excitation"):
        if not tables.get(name):
            raise HydrodynamicsError(f"the table `= {name}` is missing or empty", path)
    ship = tables["ship"][0][1]

    def value(row: Row, line: int, key: str) -> float:
        if key not in row:
            raise HydrodynamicsError(f"the column `{key}` is missing", path, line)
        return row[key]

    def of_ship(key: str) -> float:
        return value(ship, tables["ship"][0][0], key)

    c = {key: ship.get(key, 0.0) for key in ("c33", "c34", "c35", "c44", "c45", "c55")}
    excitation = {}
    for line, row in tables["excitation"]:
        key = value(row, line, "omega_radps"), value(row, line, "heading_deg")
        excitation[key] = [complex(value(row, line, f"re{k}"), value(row, line, f"im{k}")) for k in range(1, 7)]
    radiation = [(value(row, line, "omega_radps"), row) for line, row in tables["radiation"]]
    return Hydrodynamics(
        source=head or path.name,
        mass_kg=of_ship("mass_kg"),
        gyradii_m=(of_ship("roll_gyradius_m"), of_ship("pitch_gyradius_m"), of_ship("yaw_gyradius_m")),
        gravity_above_water_m=of_ship("gravity_above_water_m"),
        restoring=[[c["c33"], c["c34"], c["c35"]], [c["c34"], c["c44"], c["c45"]], [c["c35"], c["c45"], c["c55"]]],
        added_mass={w: _symmetric(row, "a") for w, row in radiation} | {math.inf: _symmetric(tables["infinite"][0][1], "a")},
        damping={w: _symmetric(row, "b") for w, row in radiation},
        excitation=excitation,
        drift={
            (value(row, line, "omega_radps"), value(row, line, "heading_deg")): [value(row, line, key) for key in ("surge", "sway", "yaw")]
            for line, row in tables.get("drift", [])
        },
        depth_m=ship.get("depth_m", math.inf),
        water_kgpm3=of_ship("water_kgpm3"),
        reference_m=(ship.get("reference_forward_m", 0.0), ship.get("reference_starboard_m", 0.0), ship.get("reference_up_m", 0.0)),
    )


def _symmetric(row: Row, letter: str) -> Matrix:
    matrix = np.zeros((6, 6))
    for i in range(6):
        for j in range(i, 6):
            matrix[i, j] = matrix[j, i] = row.get(f"{letter}{i + 1}{j + 1}", 0.0)
    found: Matrix = matrix.tolist()
    return found


def _tables(path: Path) -> tuple[str, dict[str, list[tuple[int, Row]]]]:
    """The comment of the head, and the rows of each table with their lines."""
    text = lines(path)
    if not text or text[0].strip() != "= fenderline hydrodynamic data 1":
        raise HydrodynamicsError("the first line must be `= fenderline hydrodynamic data 1`", path, 1)
    tables: dict[str, list[tuple[int, Row]]] = {}
    comment: list[str] = []
    name, columns = "", list[str]()
    for index, line in enumerate(text[1:], 2):
        if line.startswith("#") and not name:
            if line not in FORM:
                comment.append(line.lstrip("# "))
        elif line.startswith("="):
            name, columns = line[1:].strip(), []
            tables[name] = []
        elif line.strip() and not line.startswith("#"):
            if not columns:
                columns = [cell.strip() for cell in line.split(",")]
                continue
            row = numbers(line)
            if row is None or len(row) != len(columns):
                raise HydrodynamicsError(f"a row must have {len(columns)} numbers", path, index)
            tables[name].append((index, dict(zip(columns, row, strict=True))))
    return "\n".join(comment), tables
