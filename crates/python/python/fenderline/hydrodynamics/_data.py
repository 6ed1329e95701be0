"""Hydrodynamic data of a ship as the simulation reads them."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from fenderline.hydrodynamics._errors import HydrodynamicsError

if TYPE_CHECKING:
    from fenderline.hydrodynamics._panel import Panel
    from fenderline.hydrodynamics._irregular import Repair

Matrix = list[list[float]]


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

    notes: list[str] = field(default_factory=list)
    """What was cut, filled, repaired, left out or supposed, and doubts: a line each, which the head of the file has too."""
    problems: list[str] = field(default_factory=list)
    """Why the simulation would refuse the data; a file is not written then."""
    before: Panel | None = field(default=None, repr=False, compare=False)
    """The data before anything was cut, filled or repaired, in the same axes, for the picture."""
    repairs: list[Repair] = field(default_factory=list, repr=False)
    """The single frequencies that were replaced."""

    def motion(
        self,
        omega_radps: float,
        heading_deg: float,
        *,
        damping: npt.ArrayLike | None = None,
        restoring: npt.ArrayLike | None = None,
    ) -> npt.NDArray[np.complex128]:
        """The motion of the reference point in a wave of 1 m amplitude, as Re(motion e^(i omega t)): surge, sway, heave down (m), roll,
        pitch, yaw (rad). Compare it with that of your panel code.

        The frequency and the heading must be those of the data. `damping` and `restoring` (six by six, in these axes) are added,
        as those of moorings or of roll.
        """
        omega = min(self.damping, key=lambda own: abs(own - omega_radps))
        key = min(self.excitation, key=lambda own: (abs(own[0] - omega), abs(own[1] - heading_deg)))
        if abs(omega - omega_radps) > 1e-3 * omega_radps or abs(key[0] - omega) > 1e-3 * omega or abs(key[1] - heading_deg) > 0.01:
            raise HydrodynamicsError(f"{omega_radps:g} rad/s and {heading_deg:g} degrees are not in the data")
        mass = np.diag([self.mass_kg] * 3 + [self.mass_kg * k * k for k in self.gyradii_m])
        forward, starboard, up = self.reference_m
        # The centre of gravity moves by the reference point's motion and minus the lever.
        lever = np.eye(6)
        lever[0, 4], lever[0, 5] = up, starboard
        lever[1, 3], lever[1, 5] = -up, -forward
        lever[2, 3], lever[2, 4] = -starboard, forward
        stiffness = np.zeros((6, 6))
        stiffness[2:5, 2:5] = self.restoring
        water = np.array(self.damping[omega]), np.array(self.added_mass[omega])
        matrix = -(omega**2) * (lever.T @ mass @ lever + water[1]) + 1j * omega * water[0] + stiffness
        if damping is not None:
            matrix = matrix + 1j * omega * np.asarray(damping)
        if restoring is not None:
            matrix = matrix + np.asarray(restoring)
        return np.linalg.solve(matrix, np.array(self.excitation[key]))

    def picture(self, path: str | Path | None = None) -> Any:
        """Draws added mass, damping, exciting forces and mean drift over frequency, with what was cut and repaired, by Matplotlib.

        A notebook shows the figure that is given back; `path` writes it, as SVG, PNG or PDF by its end.
        """
        from fenderline.hydrodynamics._picture import draw

        return draw(self, path)

    def text(self) -> str:
        """The file's text.

        Raises [`HydrodynamicsError`] if the simulation would refuse the data.
        """
        if self.problems:
            raise HydrodynamicsError("no file can be made of these data: " + "; ".join(self.problems))
        lines = ["= fenderline hydrodynamic data 1", *(f"# {line}" for line in self.source.splitlines())]
        lines += [f"# {line}" for line in self.notes]
        lines += FORM
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


#: Lines that each file has in its head.
FORM = [
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


