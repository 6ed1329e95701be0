"""Folders of HAMS, which writes files as WAMIT does."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

from fenderline.hydrodynamics import _wamit
from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._panel import Panel
from fenderline.hydrodynamics._text import lines, number, numbers, sibling


def read(
    folder: Path, *, output: str, body: int | str | None, gravity_mps2: float | None, water_kgpm3: float | None
) -> Panel:
    """Reads the folder of a case, with `Input` and the folder of its output."""
    source = sibling(folder, "Input")
    results = sibling(folder, output)
    wamit = sibling(results, "Wamit_format") if results else None
    control = sibling(source, "ControlFile.in") if source else None
    if wamit is None or control is None:
        raise HydrodynamicsError(f"there must be Input/ControlFile.in and {output}/Wamit_format", folder)
    bases = [entry for entry in sorted(wamit.iterdir()) if entry.suffix == ".1"]
    if len(bases) != 1:
        raise HydrodynamicsError(f"there must be one file .1, but there are {len(bases)}", wamit)
    column = depth = length = None
    place = (0.0, 0.0, 0.0)
    for index, line in enumerate(lines(control), 1):
        cells = line.split()
        if len(cells) < 2 or cells[1].lower().startswith("options"):
            continue
        key = cells[0].lower()
        try:
            if key == "waterdepth":
                value = number(cells[1])
                # A negative depth is infinite.
                depth = value if value > 0.0 else math.inf
            elif key == "output_frequency_type":
                column = _wamit.HAMS_COLUMNS.get(int(cells[1]))
                if column is None:
                    raise HydrodynamicsError(f"Output_frequency_type must be 1 to 5, but is {cells[1]}", control, index)
            elif key == "reference_body_length":
                length = number(cells[1])
            elif key == "reference_body_center":
                place = (number(cells[1]), number(cells[2]), number(cells[3]))
        except (ValueError, IndexError):
            raise HydrodynamicsError(f"{cells[0]} must have numbers", control, index) from None
    for key, given in (("Waterdepth", depth), ("Output_frequency_type", column), ("Reference_body_length", length)):
        if given is None:
            raise HydrodynamicsError(f"there is no {key}", control)
    panel = _wamit.read(
        bases[0].with_name(bases[0].name[: -len(".1")]),
        body=body,
        length_m=length,
        depth_m=depth,
        gravity_mps2=gravity_mps2,
        water_kgpm3=water_kgpm3,
        first_column=column,
        body_at_m=None,
        told=f"{control.name} says so",
    )
    panel.source = f"HAMS, {folder.name}"
    hydrostatic = sibling(source, "Hydrostatic.in") if source else None
    if hydrostatic is not None:
        _hydrostatic(panel, hydrostatic, place)
    return panel


def _hydrostatic(panel: Panel, path: Path, place: tuple[float, float, float]) -> None:
    """Centre of gravity, mass and restoring; moorings are left out."""
    parts: dict[str, list[list[float]]] = {}
    now = ""
    for line in lines(path):
        row = numbers(line)
        if row is None:
            now = line.strip().rstrip(":").lower()
        elif row:
            parts.setdefault(now, []).append(row)
    centre = next((rows[0] for name, rows in parts.items() if name.startswith(("center of", "centre of"))), None)
    mass = parts.get("body mass matrix", [])
    if len(mass) == 6 and all(len(row) == 6 for row in mass) and mass[0][0] > 0.0:
        panel.mass_kg = mass[0][0]
        # The mass matrix is about the reference point: its couplings have the centre of gravity.
        x, z = -mass[2][4] / mass[0][0], mass[0][4] / mass[0][0]
        squared = [mass[3][3] / mass[0][0] - z * z, mass[4][4] / mass[0][0] - x * x - z * z, mass[5][5] / mass[0][0] - x * x]
        roll, pitch, yaw = (math.sqrt(max(value, 0.0)) for value in squared)
        panel.gyradii_m = (roll, pitch, yaw)
        if centre is not None and len(centre) == 3 and max(abs(place[0] + x - centre[0]), abs(place[2] + z - centre[2])) > 1e-3:
            panel.notes.append(
                f"Supposed: the centre of gravity is {x:.4g} m forward and {z:.4g} m above the reference point, by the couplings of the mass "
                f"matrix of {path.name}, which contradict its line Center of Gravity."
            )
            centre = [place[0] + x, place[1], place[2] + z]
    if centre is not None and len(centre) == 3:
        panel.gravity_above_water_m = centre[2]
        panel.reference_m = (place[0] - centre[0], -(place[1] - centre[1]), place[2] - centre[2])
    external = np.array([row for row in parts.get("external restoring matrix", []) if len(row) == 6])
    if external.size and np.abs(external).max() > 0.0:
        panel.notes.append(f"Left out: the external restoring of {path.name} (moorings); give lines to the scenario.")
    drag = [rows for name, rows in parts.items() if name.startswith("external") and "damping" in name]
    if any(abs(x) > 0.0 for rows in drag for row in rows for x in row):
        panel.notes.append(f"Left out: the external damping of {path.name}.")
