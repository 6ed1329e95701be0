"""What the files of any panel code have, in the axes of panel codes, before it is looked through."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._waves import Array, Complexes, resolved_radpm, wave_number_radpm

MOTIONS = ("surge", "sway", "heave", "roll", "pitch", "yaw")
#: From x forward, y to port, z up to forward, starboard, down.
SIGNS = np.array([1.0, -1.0, -1.0, 1.0, -1.0, -1.0])
#: A motion and its mirror image about the middle line.
MIRROR = np.array([1.0, -1.0, 1.0, -1.0, 1.0, -1.0])


@dataclass
class Panel:
    """Results of a panel code for one body: x forward, y to port, z up, forces as e^(i omega t) in a wave of 1 m, SI units."""

    source: str
    """The code and what it ran."""
    file: Path | str
    """The file that errors name."""
    omega: Array
    """Frequencies of the radiation, rising (rad/s)."""
    added: Array
    """Added mass by frequency, force and motion."""
    damping: Array
    """Damping likewise."""
    infinite: Array | None
    """Added mass at infinite frequency."""
    wave_omega: Array
    """Frequencies of the excitation, rising (rad/s)."""
    headings_deg: Array
    """Where waves run to, turning to port from x (degrees)."""
    force: Complexes
    """Exciting forces by frequency, heading and motion."""
    depth_m: float
    gravity_mps2: float
    water_kgpm3: float
    drift: Array | None = None
    """Mean drift in surge, sway and yaw on the frequencies and headings of the excitation; not a number where there is none."""
    restoring: Array | None = None
    """Restoring of six motions, gravity included."""
    mass_kg: float | None = None
    """Mass or displacement by the files."""
    gyradii_m: tuple[float, float, float] | None = None
    """Radii of gyration by the files."""
    gravity_above_water_m: float | None = None
    """Centre of gravity by the files."""
    reference_m: tuple[float, float, float] | None = None
    """Reference point from the centre of gravity by the files: forward, to starboard, up."""
    several: bool = False
    """Whether other bodies were in the water."""
    lines: dict[float, int] = field(default_factory=dict)
    """The line of a frequency in the file."""
    notes: list[str] = field(default_factory=list)
    """What was left out or supposed while reading."""
    mass: Array = field(default_factory=lambda: np.zeros(6))
    """Rigid mass of each motion."""
    stiff: Array = field(default_factory=lambda: np.zeros(6))
    """Restoring of each motion."""

    def __post_init__(self) -> None:
        for what, value in (("depth", self.depth_m), ("gravity", self.gravity_mps2), ("density of the water", self.water_kgpm3)):
            if not value > 0.0 or (what != "depth" and not math.isfinite(value)):
                raise HydrodynamicsError(f"the {what} must be above 0, but is {value:g}", self.file)

    @property
    def felt(self) -> Array:
        """Mass with added mass at the highest frequency, of each motion."""
        last = self.added[-1] if self.infinite is None else self.infinite
        total: Array = self.mass + np.abs(np.diag(last))
        return total

    def length_m(self) -> float:
        """About the length of the body, by the added mass: of sway along her, as of a slender hull, and of heave as of a round one."""
        own = [float(np.nanmax(np.abs(self.added[:, k, k]))) for k in (1, 2, 5)]
        slender = math.sqrt(15.0 * own[2] / own[0]) if own[0] > 0.0 else 0.0
        return max(slender, 2.5 * math.cbrt(own[1] / self.water_kgpm3), 1e-3)

    def resolved_radpm(self) -> float:
        """The largest wave number at which the headings resolve the waves that she makes."""
        return resolved_radpm(self.headings_deg, self.length_m())

    def line(self, omega: float) -> int | None:
        """The line of the frequency nearest to this one."""
        if not self.lines:
            return None
        return self.lines[min(self.lines, key=lambda own: abs(own - omega))]

    def seen_from(self, x_m: float, y_m: float) -> None:
        """Counts phases from a crest at this point instead of the origin."""
        if x_m == 0.0 and y_m == 0.0:
            return
        k = np.array([wave_number_radpm(w, self.depth_m, self.gravity_mps2) for w in self.wave_omega])
        beta = np.radians(self.headings_deg)
        along = x_m * np.cos(beta) + y_m * np.sin(beta)
        self.force = self.force * np.exp(1j * k[:, None] * along[None, :])[:, :, None]

    def turned(self, degrees: float) -> None:
        """Headings from the axes of a body that is turned to port by an angle."""
        self.headings_deg = self.headings_deg - degrees


def in_ships_axes(matrix: Array) -> Array:
    """Matrices of motions, the last two axes, from a panel code's axes to the ship's."""
    turned: Array = matrix * SIGNS[:, None] * SIGNS[None, :]
    return turned


def starboard_deg(port_deg: float) -> float:
    """From a direction that turns to port to one that turns to starboard, above -180 to 180 degrees."""
    degrees = -port_deg % 360.0
    return round(degrees - 360.0 if degrees > 180.0 + 1e-6 else degrees, 6)


def gyradii(matrix: Array, mass_kg: float) -> tuple[float, float, float]:
    """Radii of gyration of a mass matrix about the centre of gravity."""
    roll, pitch, yaw = (math.sqrt(max(float(matrix[k, k]), 0.0) / mass_kg) for k in (3, 4, 5))
    return roll, pitch, yaw


def radps(values: Sequence[float] | Array) -> str:
    """Frequencies in words."""
    known = [f"{value:.4g}" for value in values]
    if len(known) > 6:
        known = [*known[:3], "…", known[-1]]
    return ", ".join(known) + " rad/s"


def trapezium(values: Array, at: Array) -> float:
    """The integral of values over their places."""
    return float(np.sum(0.5 * (values[1:] + values[:-1]) * np.diff(at)))
