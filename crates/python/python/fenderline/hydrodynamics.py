"""Hydrodynamic data of panel codes, as the file that ``vessel.NAME.hydrodynamics`` of a scenario names.

- :func:`from_capytaine`: a dataset of Capytaine, or its NetCDF file.
- :func:`from_wamit`: files ``.1`` and ``.3``, and ``.8`` or ``.9`` if there is one.
- :func:`from_nemoh`: the folder of results of Nemoh 2 or 3.

Each returns :class:`Hydrodynamics`, whose :meth:`~Hydrodynamics.write` writes the file.

All three codes have x forward, y to port and z up. The file has forward, to starboard and down: sway, heave, pitch and yaw
change their signs, headings turn clockwise, and phases are of the form e^(i omega t) with the crest at the reference point.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

__all__ = ["Hydrodynamics", "from_capytaine", "from_nemoh", "from_wamit"]

Matrix = list[list[float]]

_DOFS = ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")
_SIGNS = (1, -1, -1, 1, -1, -1)
_MIRROR = (1, -1, 1, -1, 1, -1)
_DRIFTS = ("drift_force_surge", "drift_force_sway", "drift_force_yaw")
_GRAVITY = 9.80665


@dataclass
class Hydrodynamics:
    """Hydrodynamic data of a ship about a reference point: surge, sway, heave down, roll to starboard, pitch bow up, yaw to
    starboard, in SI units."""

    source: str
    """Where the data come from: program, mesh, who ran it."""
    mass_kg: float
    """Displacement."""
    gyradii_m: tuple[float, float, float]
    """Radii of gyration in roll, pitch and yaw about the centre of gravity, without added mass."""
    gravity_above_water_m: float
    """Centre of gravity above the still water; negative below it."""
    restoring: Matrix
    """Restoring in heave, roll and pitch about the reference point, gravity included (N/m, N, N m)."""
    added_mass: dict[float, Matrix]
    """Added mass by frequency (rad/s); infinity is one of them."""
    damping: dict[float, Matrix]
    """Damping by frequency (rad/s)."""
    excitation: dict[tuple[float, float], list[complex]]
    """Exciting force in a wave of amplitude 1 m by frequency (rad/s) and heading (degrees, where the wave runs to, clockwise
    from the bow)."""
    drift: dict[tuple[float, float], list[float]] = field(default_factory=dict)
    """Mean drift in surge, sway and yaw over the square of the amplitude, likewise; may be empty."""
    depth_m: float = math.inf
    """Depth of the water."""
    water_kgpm3: float = 1025.0
    """Density of the water."""
    reference_m: tuple[float, float, float] = (0.0, 0.0, 0.0)
    """The reference point from the centre of gravity: forward, to starboard, up."""

    def text(self) -> str:
        """The file's text."""
        lines = ["= fenderline hydrodynamic data 1", *(f"# {line}" for line in self.source.splitlines())]
        lines += _NOTES
        head = {
            "mass_kg": self.mass_kg,
            "gravity_above_water_m": self.gravity_above_water_m,
            "roll_gyradius_m": self.gyradii_m[0],
            "pitch_gyradius_m": self.gyradii_m[1],
            "yaw_gyradius_m": self.gyradii_m[2],
            "reference_forward_m": self.reference_m[0],
            "reference_starboard_m": self.reference_m[1],
            "reference_up_m": self.reference_m[2],
            "water_kgpm3": self.water_kgpm3,
        }
        if math.isfinite(self.depth_m):
            head["depth_m"] = self.depth_m
        for i in range(3):
            for j in range(i, 3):
                head[f"c{i + 3}{j + 3}"] = 0.5 * (self.restoring[i][j] + self.restoring[j][i])
        lines += _table("ship", list(head), [list(head.values())])
        omegas = sorted(w for w in self.damping if math.isfinite(w) and w > 0)
        infinite = self.added_mass[math.inf]
        pairs = [
            (i, j)
            for i in range(6)
            for j in range(i, 6)
            if _matters(i, j, [self.added_mass[w] for w in [*omegas, math.inf]])
            or _matters(i, j, [self.damping[w] for w in omegas])
        ]
        names = [f"{letter}{i + 1}{j + 1}" for i, j in pairs for letter in "ab"]
        rows = [
            [w, *(_mean(m[w], i, j) for i, j in pairs for m in (self.added_mass, self.damping))] for w in omegas
        ]
        lines += _table("radiation", ["omega_radps", *names], rows)
        lines += _table(
            "infinite", [f"a{i + 1}{j + 1}" for i, j in pairs], [[_mean(infinite, i, j) for i, j in pairs]]
        )
        names = [f"{part}{k + 1}" for k in range(6) for part in ("re", "im")]
        most = [max((abs(x[k]) for x in self.excitation.values()), default=0.0) for k in range(6)]
        rows = []
        for (w, heading), forces in sorted(self.excitation.items()):
            parts = [part for k, x in enumerate(forces) for part in _clean(x, most[k])]
            rows.append([w, heading, *parts])
        lines += _table("excitation", ["omega_radps", "heading_deg", *names], rows)
        if self.drift:
            most = [max(abs(x[k]) for x in self.drift.values()) for k in range(3)]
            rows = [
                [w, heading, *(0.0 if abs(x) < 1e-6 * m else x for x, m in zip(forces, most, strict=True))]
                for (w, heading), forces in sorted(self.drift.items())
            ]
            lines += _table("drift", ["omega_radps", "heading_deg", "surge", "sway", "yaw"], rows)
        return "\n".join(lines) + "\n"

    def write(self, path: str | Path) -> None:
        """Writes the file."""
        Path(path).write_text(self.text(), encoding="utf-8")


_NOTES = [
    "# Motions 1 to 6: surge forward, sway to starboard, heave down, roll to starboard, pitch bow up, yaw to starboard.",
    "# kg, m, s, N. a: added mass, b: damping, c: restoring. A force in a wave of 1 m amplitude with its crest at the reference",
    "# point at time 0 is Re((re + i im) e^(i omega t)); heading_deg is where the wave runs to, clockwise from the bow.",
]


def _table(name: str, columns: list[str], rows: Iterable[Sequence[float]]) -> list[str]:
    return ["", f"= {name}", ",".join(columns), *(",".join(_number(x) for x in row) for row in rows)]


def _number(value: float) -> str:
    text = f"{value:.5g}"
    return text.replace("e+0", "e").replace("e+", "e").replace("e-0", "e-")


def _mean(matrix: Matrix, i: int, j: int) -> float:
    return 0.5 * (matrix[i][j] + matrix[j][i])


def _clean(value: complex, most: float) -> tuple[float, float]:
    real, imaginary = (0.0 if abs(part) < 1e-5 * most else part for part in (value.real, value.imag))
    return real, imaginary


def _matters(i: int, j: int, matrices: list[Matrix]) -> bool:
    """Whether a pair of motions is coupled by more than the noise of a mesh."""
    scale = math.sqrt(max(abs(m[i][i]) for m in matrices) * max(abs(m[j][j]) for m in matrices))
    return i == j or max(abs(_mean(m, i, j)) for m in matrices) > 5e-3 * scale


def _turned(matrix: Any) -> Matrix:
    return [[_SIGNS[i] * _SIGNS[j] * float(matrix[i][j]) for j in range(6)] for i in range(6)]


def _heading(port_rad: float) -> float:
    """From a direction that turns to port (rad) to one that turns to starboard, above -180 to 180 degrees."""
    degrees = -math.degrees(port_rad) % 360.0
    return round(degrees - 360.0 if degrees > 180.0 + 1e-6 else degrees, 6)


def _folded(table: dict[tuple[float, float], list[Any]]) -> dict[tuple[float, float], list[Any]]:
    """Waves from starboard as the mirror image of those from port, where all headings are to one side: the ship is alike to both."""
    sides = {heading < 0 for _, heading in table if abs(heading) not in (0.0, 180.0)}
    if sides != {True}:
        return table
    mirror = _MIRROR if len(next(iter(table.values()))) == 6 else [_MIRROR[k] for k in (0, 1, 5)]
    return {
        (w, abs(heading)): [sign * x for sign, x in zip(mirror, forces, strict=True)]
        for (w, heading), forces in table.items()
    }


def from_capytaine(
    dataset: Any,
    *,
    gravity_above_water_m: float,
    gyradii_m: tuple[float, float, float],
    mass_kg: float | None = None,
    reference_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From a dataset of Capytaine, or the path of its NetCDF file (xarray and h5netcdf or netCDF4 read it).

    The dataset needs `added_mass` with infinite frequency, `radiation_damping`, `excitation_force` (or its two parts), and
    `hydrostatic_stiffness`. Mean drift is taken from what `capytaine.post_pro.far_field_mean_drift_force` gives, if it was merged into the
    dataset. `mass_kg` is that of `inertia_matrix` if it is not given. `reference_m` is the rotation centre of its
    motions from the centre of gravity: forward, starboard, up. `fold` takes waves from starboard as the mirror image of those from
    port, for a hull that is alike to both sides in open water.
    """
    if isinstance(dataset, (str, Path)):
        import xarray

        with xarray.open_dataset(dataset) as opened:
            dataset = opened.load()

    def matrices(name: str) -> dict[float, Matrix]:
        data = dataset[name].sel(radiating_dof=list(_DOFS), influenced_dof=list(_DOFS))
        data = data.transpose("omega", "influenced_dof", "radiating_dof")
        return {float(w): _turned(data.sel(omega=w).values) for w in dataset["omega"].values}

    def force(name: str) -> Any:
        data = dataset[name]
        if "complex" in data.dims:
            data = data.sel(complex="re") + 1j * data.sel(complex="im")
        return data

    if "excitation_force" in dataset:
        forces = force("excitation_force")
    else:
        forces = force("Froude_Krylov_force") + force("diffraction_force")
    forces = forces.sel(influenced_dof=list(_DOFS)).transpose("omega", "wave_direction", "influenced_dof")
    excitation = {}
    for w in dataset["omega"].values:
        if not math.isfinite(w) or w <= 0:
            continue
        for direction in dataset["wave_direction"].values:
            # Capytaine's e^(-i omega t) is the conjugate.
            values = forces.sel(omega=w, wave_direction=direction).values
            excitation[float(w), _heading(float(direction))] = [
                sign * complex(value).conjugate() for sign, value in zip(_SIGNS, values, strict=True)
            ]
    drift: dict[tuple[float, float], list[float]] = {}
    if all(name in dataset for name in _DRIFTS):
        for w in dataset["omega"].values:
            for direction in dataset["wave_direction_k"].values:
                at = {"omega": w, "wave_direction_k": direction, "wave_direction_l": direction}
                values = [float(force(name).sel(at).values.real) for name in _DRIFTS]
                if all(math.isfinite(value) for value in values):
                    signs = (_SIGNS[k] for k in (0, 1, 5))
                    drift[float(w), _heading(float(direction))] = [
                        sign * value for sign, value in zip(signs, values, strict=True)
                    ]
    stiffness = dataset["hydrostatic_stiffness"].sel(influenced_dof=list(_DOFS), radiating_dof=list(_DOFS))
    stiffness = _turned(stiffness.transpose("influenced_dof", "radiating_dof").values)
    if mass_kg is None:
        mass_kg = float(dataset["inertia_matrix"].sel(influenced_dof="Surge", radiating_dof="Surge"))
    depth = float(dataset["water_depth"].values.flat[0])
    return Hydrodynamics(
        source=source or "Capytaine",
        mass_kg=mass_kg,
        gyradii_m=gyradii_m,
        gravity_above_water_m=gravity_above_water_m,
        restoring=[row[2:5] for row in stiffness[2:5]],
        added_mass=matrices("added_mass"),
        damping=matrices("radiation_damping"),
        excitation=_folded(excitation) if fold else excitation,
        drift=_folded(drift) if fold else drift,
        depth_m=depth,
        water_kgpm3=float(dataset["rho"].values.flat[0]),
        reference_m=reference_m,
    )


def from_wamit(
    path: str | Path,
    *,
    restoring: Matrix,
    mass_kg: float,
    gravity_above_water_m: float,
    gyradii_m: tuple[float, float, float],
    length_m: float = 1.0,
    depth_m: float = math.inf,
    gravity_mps2: float = _GRAVITY,
    water_kgpm3: float = 1025.0,
    reference_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From files of WAMIT in its form without dimensions: `path` with ``.1`` (added mass and damping), ``.3`` or ``.2`` (exciting
    forces) and, if there is one, ``.8`` or ``.9`` (mean drift).

    `length_m` is WAMIT's ULEN. `restoring` is in heave (down), roll and pitch, gravity included (N/m, N, N m). Periods of zero are infinite
    frequency, negative ones zero frequency. `reference_m` is the origin of the body's axes from the centre of gravity.
    """
    base = Path(path)
    added: dict[float, Matrix] = {}
    damping: dict[float, Matrix] = {}
    for row in _rows(base.with_suffix(".1")):
        period, i, j = row[0], int(row[1]) - 1, int(row[2]) - 1
        if period < 0:
            continue
        omega = math.inf if period == 0 else 2 * math.pi / period
        scale = water_kgpm3 * length_m ** (3 + (i > 2) + (j > 2)) * _SIGNS[i] * _SIGNS[j]
        added.setdefault(omega, _zero())[i][j] = row[3] * scale
        if math.isfinite(omega):
            damping.setdefault(omega, _zero())[i][j] = row[4] * scale * omega
    forces_file = next((f for f in (base.with_suffix(".3"), base.with_suffix(".2")) if f.exists()), None)
    if forces_file is None:
        raise FileNotFoundError(f"{base.with_suffix('.3')}: there is no file of exciting forces")
    excitation: dict[tuple[float, float], list[complex]] = {}
    for period, beta, mode, _, _, real, imaginary in _rows(forces_file):
        k = int(mode) - 1
        scale = water_kgpm3 * gravity_mps2 * length_m ** (2 + (k > 2)) * _SIGNS[k]
        key = (2 * math.pi / period, _heading(math.radians(beta)))
        excitation.setdefault(key, [0j] * 6)[k] = scale * complex(real, imaginary)
    drift: dict[tuple[float, float], list[float]] = {}
    drift_file = next((f for f in (base.with_suffix(".8"), base.with_suffix(".9")) if f.exists()), None)
    for period, beta, other, mode, _, _, real, _ in _rows(drift_file) if drift_file else []:
        k = int(mode) - 1
        if beta == other and k in (0, 1, 5):
            scale = water_kgpm3 * gravity_mps2 * length_m ** (1 + (k > 2)) * _SIGNS[k]
            key = (2 * math.pi / period, _heading(math.radians(beta)))
            drift.setdefault(key, [0.0] * 3)[(0, 1, 5).index(k)] = scale * real
    return Hydrodynamics(
        source=source or f"WAMIT, {base.name}",
        mass_kg=mass_kg,
        gyradii_m=gyradii_m,
        gravity_above_water_m=gravity_above_water_m,
        restoring=restoring,
        added_mass=added,
        damping=damping,
        excitation=_folded(excitation) if fold else excitation,
        drift=_folded(drift) if fold else drift,
        depth_m=depth_m,
        water_kgpm3=water_kgpm3,
        reference_m=reference_m,
    )


def from_nemoh(
    folder: str | Path,
    *,
    restoring: Matrix,
    mass_kg: float,
    gravity_above_water_m: float,
    gyradii_m: tuple[float, float, float],
    infinite: Matrix | None = None,
    depth_m: float = math.inf,
    water_kgpm3: float = 1025.0,
    reference_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From the folder of results of Nemoh: ``RadiationCoefficients.tec`` and ``ExcitationForce.tec`` of one body with six motions.

    The form of these files is recalled, not read in Nemoh's documents. Nemoh does not give infinite frequency there: `infinite` is the
    added mass at it, in Nemoh's axes; without it that at the last frequency is written, and the simulation finds its own from the damping.
    `restoring` is in heave (down), roll and pitch, gravity included.
    """
    base = Path(folder)
    added: dict[float, Matrix] = {}
    damping: dict[float, Matrix] = {}
    for j, (_, rows) in enumerate(_zones(base / "RadiationCoefficients.tec")):
        for row in rows:
            for i in range(6):
                sign = _SIGNS[i] * _SIGNS[j]
                added.setdefault(row[0], _zero())[i][j] = sign * row[1 + 2 * i]
                damping.setdefault(row[0], _zero())[i][j] = sign * row[2 + 2 * i]
    added[math.inf] = _turned(infinite) if infinite is not None else added[max(added)]
    excitation: dict[tuple[float, float], list[complex]] = {}
    for title, rows in _zones(base / "ExcitationForce.tec"):
        beta = float(title.split("beta")[1].replace("=", " ").split()[0])
        for row in rows:
            # Nemoh's e^(-i omega t) is the conjugate.
            excitation[row[0], _heading(math.radians(beta))] = [
                _SIGNS[k] * cmath.rect(row[1 + 2 * k], -row[2 + 2 * k]) for k in range(6)
            ]
    return Hydrodynamics(
        source=source or "Nemoh",
        mass_kg=mass_kg,
        gyradii_m=gyradii_m,
        gravity_above_water_m=gravity_above_water_m,
        restoring=restoring,
        added_mass=added,
        damping=damping,
        excitation=_folded(excitation) if fold else excitation,
        depth_m=depth_m,
        water_kgpm3=water_kgpm3,
        reference_m=reference_m,
    )


def _zero() -> Matrix:
    return [[0.0] * 6 for _ in range(6)]


def _rows(path: Path) -> Iterable[list[float]]:
    """The rows of numbers of a file; other lines are headers."""
    for line in path.read_text(encoding="utf-8").splitlines():
        try:
            row = [float(cell) for cell in line.split()]
        except ValueError:
            continue
        if row:
            yield row


def _zones(path: Path) -> list[tuple[str, list[list[float]]]]:
    """The zones of a file for Tecplot, each with its title."""
    zones: list[tuple[str, list[list[float]]]] = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.strip().lower().startswith("zone"):
            zones.append((line, []))
        elif zones:
            try:
                zones[-1][1].append([float(cell) for cell in line.split()])
            except ValueError:
                continue
    return zones
