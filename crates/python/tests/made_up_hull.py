"""A hull that is made up, with consistent data: her exciting forces are those of the undisturbed wave on a box (more in surge and sway, for
their added mass), her damping follows from them by Haskind's relation and her added mass from the damping by Ogilvie's. And files of it in
the forms of several panel codes.

In the axes of panel codes: x forward, y to port, z up, forces as e^(i omega t).
"""

import math
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

LENGTH, BEAM, DRAUGHT = 60.0, 16.0, 4.0
WATER, GRAVITY = 1025.0, 9.81
MASS = WATER * LENGTH * BEAM * DRAUGHT
GYRADII = (6.0, 16.0, 16.0)
RESTORING = np.diag(
    [0.0, 0.0, WATER * GRAVITY * LENGTH * BEAM, 0.08 * MASS * GRAVITY * BEAM, 1.2 * MASS * GRAVITY * LENGTH, 0.0]
)
INFINITE = np.array([0.02 * MASS, 0.1 * MASS, 0.8 * MASS, 4.0 * MASS, 200.0 * MASS, 60.0 * MASS])
OMEGAS = np.concatenate([np.arange(0.15, 1.0, 0.05), np.arange(1.0, 3.61, 0.1)])
HEADINGS = np.arange(0.0, 181.0, 15.0)


def wave_number(omega: float, depth: float) -> float:
    """By bisection: not as the package finds it."""
    if not math.isfinite(depth):
        return omega * omega / GRAVITY
    low, high = 0.0, 10.0 + omega * omega
    for _ in range(200):
        middle = 0.5 * (low + high)
        if GRAVITY * middle * math.tanh(middle * depth) < omega * omega:
            low = middle
        else:
            high = middle
    return low


def exciting(k: float, depth: float, beta: Any) -> Any:
    """Forces of an undisturbed wave of 1 m on the box, by heading and motion; roll and pitch by its bottom, yaw made up."""
    across, along = 0.5 * k * BEAM * np.sin(beta), 0.5 * k * LENGTH * np.cos(beta)

    def sinc(x: Any) -> Any:
        return np.sinc(x / math.pi)

    def tilt(x: Any) -> Any:
        safe = np.where(np.abs(x) > 1e-4, x, 1.0)
        return np.where(np.abs(x) > 1e-4, (np.sin(safe) - safe * np.cos(safe)) / safe**2, x / 3.0)

    # Waves far shorter than the depth do not feel the bottom.
    if k * depth < 300.0:
        keel = math.cosh(k * (depth - DRAUGHT)) / math.cosh(k * depth)
        side = (math.sinh(k * depth) - math.sinh(k * (depth - DRAUGHT))) / math.cosh(k * depth) / k
    else:
        keel, side = math.exp(-k * DRAUGHT), (1.0 - math.exp(-k * DRAUGHT)) / k
    weight = WATER * GRAVITY
    fade = math.exp(-((k * BEAM / 6.0) ** 2))
    return np.stack(
        [
            1.1 * weight * BEAM * sinc(across) * side * 2j * np.sin(along),
            2.0 * weight * LENGTH * sinc(along) * side * 2j * np.sin(across),
            weight * LENGTH * BEAM * keel * sinc(along) * sinc(across) + 0j,
            -2j * weight * LENGTH * keel * sinc(along) * tilt(across) * (0.5 * BEAM) ** 2,
            2j * weight * BEAM * keel * sinc(across) * tilt(along) * (0.5 * LENGTH) ** 2,
            weight * side * LENGTH**2 * np.sin(2.0 * beta) * k * LENGTH * 0.05 * fade + 0j,
        ],
        axis=-1,
    )


@dataclass
class Hull:
    """The data of the hull."""

    depth: float = math.inf
    omegas: Any = field(default_factory=lambda: OMEGAS.copy())
    headings: Any = field(default_factory=lambda: HEADINGS.copy())

    def __post_init__(self) -> None:
        fine = np.linspace(0.01, 7.0, 700)
        damping = np.array([self._damping(w) for w in fine])
        self.k = np.array([wave_number(w, self.depth) for w in self.omegas])
        self.damping = np.zeros((len(self.omegas), 6, 6))
        self.added = np.zeros((len(self.omegas), 6, 6))
        for m in range(6):
            self.damping[:, m, m] = np.interp(self.omegas, fine, damping[:, m])
            for row, w in enumerate(self.omegas):
                own = self.damping[row, m, m]
                middle = np.abs(fine - w) < 1e-9
                part = (damping[:, m] - own) / np.where(middle, 1.0, fine**2 - w**2)
                part[middle] = 0.5 * np.gradient(damping[:, m], fine)[middle] / w
                end = fine[-1]
                rest = -own * math.log((end + w) / (end - w)) / (2.0 * w)
                change = float(np.sum(0.5 * (part[1:] + part[:-1]) * np.diff(fine))) + rest
                self.added[row, m, m] = INFINITE[m] + 2.0 / math.pi * change
        self.force = np.array([exciting(k, self.depth, np.radians(self.headings)) for k in self.k])

    def _damping(self, omega: float) -> Any:
        k = wave_number(omega, self.depth)
        twice = 2.0 * k * self.depth
        shallow = twice / math.sinh(twice) if math.isfinite(twice) and twice < 500.0 else 0.0
        group = 0.5 * omega / k * (1.0 + shallow)
        count = 72 + 4 * int(k * LENGTH)
        beta = 2.0 * math.pi * np.arange(count) / count
        squared = 2.0 * math.pi * np.mean(np.abs(exciting(k, self.depth, beta)) ** 2, axis=0)
        return k / (8.0 * math.pi * WATER * GRAVITY * group) * squared

    def motion(self, row: int, column: int) -> Any:
        """Her motion about the centre of gravity, which is the reference point."""
        mass = np.diag([MASS] * 3 + [MASS * r * r for r in GYRADII])
        w = self.omegas[row]
        matrix = -(w**2) * (mass + self.added[row]) + 1j * w * self.damping[row] + RESTORING
        return np.linalg.solve(matrix, self.force[row, column])

    # Files.

    def first(self, row: int, column: str) -> float:
        """The entry of a first column."""
        w, k = float(self.omegas[row]), float(self.k[row])
        return {"period": 2.0 * math.pi / w, "frequency": w, "wave number": k, "deep wave number": w * w / GRAVITY}[column]

    def wamit(
        self, base: Path, *, column: str = "period", infinite: bool = True, bodies: int = 1, length: float = 1.0, hst: bool = True
    ) -> Path:
        """Files `.1`, `.3` and `.hst` of one body, or of several that are the same and do not feel each other."""
        base.parent.mkdir(parents=True, exist_ok=True)

        def scale(i: int, j: int) -> float:
            return WATER * length ** (3 + (i > 2) + (j > 2))

        lines = []
        pairs = [(6 * b + i, 6 * b + i, i) for b in range(bodies) for i in range(6)]
        if infinite:
            limit = 0.0 if column == "period" else -1.0
            lines += [f" {limit:.6E} {i + 1} {j + 1} {INFINITE[m] / scale(m, m):.6E}" for i, j, m in pairs]
        for row, w in enumerate(self.omegas):
            for i, j, m in pairs:
                a, b = self.added[row, m, m] / scale(m, m), self.damping[row, m, m] / scale(m, m) / w
                lines.append(f" {self.first(row, column):.6E} {i + 1} {j + 1} {a:.6E} {b:.6E}")
        Path(f"{base}.1").write_text("\n".join(lines) + "\n")
        lines = []
        for row in range(len(self.omegas)):
            for at, heading in enumerate(self.headings):
                for b in range(bodies):
                    for m in range(6):
                        x = self.force[row, at, m] / (WATER * GRAVITY * length ** (2 + (m > 2)))
                        cells = [self.first(row, column), heading, 6 * b + m + 1, abs(x), math.degrees(np.angle(x)), x.real, x.imag]
                        lines.append(" " + " ".join(f"{cell:.6E}" if k != 2 else str(cell) for k, cell in enumerate(cells)))
        Path(f"{base}.3").write_text("\n".join(lines) + "\n")
        if hst:
            size = 6 * bodies
            rows = []
            for i in range(size):
                for j in range(size):
                    same = i // 6 == j // 6
                    value = RESTORING[i % 6, j % 6] / (WATER * GRAVITY * length ** (2 + (i % 6 > 2) + (j % 6 > 2))) if same else 0.0
                    rows.append(f" {i + 1} {j + 1} {value:.6E}")
            Path(f"{base}.hst").write_text("\n".join(rows) + "\n")
        return base

    def nemoh(self, folder: Path, *, bodies: int = 1) -> Path:
        """A folder of Nemoh: e^(-i omega t), depth 0 for deep water."""
        (folder / "Mesh").mkdir(parents=True)
        (folder / "Results").mkdir()
        names = ["tug", "ship"][-bodies:]
        depth = self.depth if math.isfinite(self.depth) else 0.0
        cal = [f"{WATER} ! RHO ! KG/M**3 ! Fluid specific volume", f"{GRAVITY} ! G ! M/S**2 ! Gravity", f"{depth} ! DEPTH ! M ! Water depth"]
        cal += ["0. 0. ! XEFF YEFF ! M ! Wave measurement point", f"{bodies} ! Number of bodies"]
        for name in names:
            cal += [f"mesh\\{name}.dat ! Name of mesh file", *(f"2 1. 0. 0. 0. 0. 1.5 ! {turn} about a point" for turn in ("Roll", "Pitch", "Yaw"))]
        (folder / "Nemoh.cal").write_text("\n".join(cal) + "\n")
        head = 'VARIABLES="w (rad/s)"\n"A" "B"\n'
        zones = []
        for b in range(bodies):
            for j in range(6):
                rows = [f'Zone t="Motion of body {b + 1} in DoF {j + 1}",I={len(self.omegas)},F=POINT']
                for row, w in enumerate(self.omegas):
                    cells = [f"{w:.7E}"]
                    for other in range(bodies):
                        for i in range(6):
                            own = other == b
                            cells += [f"{self.added[row, i, j] if own else 0.0:.7E}", f"{self.damping[row, i, j] if own else 0.0:.7E}"]
                    rows.append(" ".join(cells))
                zones.append("\n".join(rows))
        (folder / "Results" / "RadiationCoefficients.tec").write_text(head + "\n".join(zones) + "\n")
        zones = []
        for at, heading in enumerate(self.headings):
            rows = [f'Zone t="Excitation force - beta = {heading:8.3f} deg",I={len(self.omegas)},F=POINT']
            for row, w in enumerate(self.omegas):
                cells = [f"{w:.7E}"]
                for _ in range(bodies):
                    cells += [f"{abs(x):.7E} {-np.angle(x):.7E}" for x in self.force[row, at]]
                rows.append(" ".join(cells))
            zones.append("\n".join(rows))
        (folder / "Results" / "ExcitationForce.tec").write_text(head + "\n".join(zones) + "\n")
        for b in range(bodies):
            end = "" if bodies == 1 else f"_{b}"
            (folder / "Mesh" / f"KH{end}.dat").write_text("\n".join(" ".join(f"{x:.7E}" for x in row) for row in RESTORING) + "\n")
            (folder / "Mesh" / f"Hydrostatics{end}.dat").write_text(
                f" XF = 0.000 - XG = 0.000\n YF = 0.000 - YG = 0.000\n ZF = -2.000 - ZG = 1.500\n Displacement = {MASS / WATER:.7E}\n"
            )
        return folder

    def ah1(self, path: Path, *, bodies: int = 1) -> Path:
        """AQWA's file: phases are lags."""
        lines = ["* FILE VERSION NO 5", "*"]

        def numbers(values: list[float]) -> list[str]:
            return [" ".join(f"{x:.7f}" for x in values[k : k + 6]) for k in range(0, len(values), 6)]

        for b in range(bodies):
            lines.append(f" {b + 1} {len(self.headings)} {len(self.omegas)} " + " ".join(f"{h:.5f}" for h in self.headings))
            lines += numbers(list(self.omegas))
        each = range(1, bodies + 1)
        lines += ["GENERAL", *(f" {b} {self.depth if math.isfinite(self.depth) else 1e4:.3f} {WATER:.3f} {GRAVITY:.3f} 0 0" for b in each)]
        lines += ["COG", *(f" {b} 0.0 0.0 1.5" for b in each)]

        def matrix(indices: list[int], values: Any) -> list[str]:
            rows = [" ".join(f"{x:.7E}" for x in row) for row in values]
            return [" ".join(map(str, indices)) + " " + rows[0], *rows[1:]]

        mass = np.diag([MASS] * 3 + [MASS * r * r for r in GYRADII])
        for name, still in (("MASS", mass), ("HYDSTIFFNESS", RESTORING)):
            lines.append(name)
            for b in each:
                lines += matrix([b], still)
        for name, values in (("ADDEDMASS", self.added), ("DAMPING", self.damping)):
            lines.append(name)
            for one in each:
                for two in each:
                    for row in range(len(self.omegas)):
                        lines += matrix([one, two, row + 1], values[row] if one == two else np.zeros((6, 6)))
        lines.append("ADDEDMASS_HF")
        for one in each:
            for two in each:
                lines += matrix([one, two], np.diag(INFINITE) if one == two else np.zeros((6, 6)))
        lines.append("FORCERAO")
        for b in each:
            for at in range(len(self.headings)):
                for row in range(len(self.omegas)):
                    x = self.force[row, at]
                    lines.append(f" {b} {at + 1} {row + 1} " + " ".join(f"{abs(v):.7E}" for v in x))
                    lines.append(" ".join(f"{-math.degrees(np.angle(v)):.5f}" for v in x))
        path.write_text("\n".join(lines) + "\n")
        return path

    def lis(self, path: Path) -> Path:
        """AQWA's listing, as much of it as is read."""
        lines = [
            "            WATER  DEPTH  . . . . . =    " + f"{self.depth if math.isfinite(self.depth) else 1e4:.4f}",
            f"            DENSITY  OF  WATER  . . =    {WATER:.3f}",
            f"            ACCELERATION  DUE  TO GRAVITY . =  {GRAVITY:.3f}",
            " * * * M A S S   A N D   I N E R T I A   P R O P E R T I E S   O F   S T R U C T U R E   1 * * *",
            f"            T O T A L         21         {MASS:.4E}          {MASS * GRAVITY:.4E}",
            "            CENTRE OF GRAVITY           0.000       0.000       1.500",
            "            INERTIA MATRIX  " + " ".join(f"{x:.4E}" for x in (MASS * GYRADII[0] ** 2, 0.0, 0.0)),
            "                            " + " ".join(f"{x:.4E}" for x in (0.0, MASS * GYRADII[1] ** 2, 0.0)),
            "                            " + " ".join(f"{x:.4E}" for x in (0.0, 0.0, MASS * GYRADII[2] ** 2)),
            "   * * * H Y D R O D Y N A M I C   P A R A M E T E R S   F O R   S T R U C T U R E   1 * * *",
        ]

        def matrix(title: str, values: Any) -> list[str]:
            rows = [f"  {name}  " + " ".join(f"{x:.4E}" for x in row) for name, row in zip(("X", "Y", "Z", "RX", "RY", "RZ"), values, strict=True)]
            return ["", f"     {title}", "     " + "-" * len(title), "", "   X   Y   Z   RX   RY   RZ", *(line for row in rows for line in (row, ""))]

        lines += matrix("STIFFNESS MATRIX", RESTORING)
        for row, w in enumerate(self.omegas):
            lines += ["1", f"   WAVE PERIOD = {2 * math.pi / w:.3f}   WAVE FREQUENCY = {w:.4f}", ""]
            lines += matrix("ADDED  MASS", self.added[row]) + matrix("DAMPING", self.damping[row])
        lines += ["1", "   FROUDE KRYLOV + DIFFRACTION FORCES-VARIATION WITH WAVE PERIOD/FREQUENCY", " (SECS)  (RAD/S) (DEGREES)    AMP      PHASE", ""]
        for at, heading in enumerate(self.headings):
            for row, w in enumerate(self.omegas):
                pairs = " ".join(f"{abs(x):.4E} {-math.degrees(np.angle(x)):.2f}" for x in self.force[row, at])
                lines.append(f"  {2 * math.pi / w:.2f} {w:.4f} {f'{heading:.2f}' if row == 0 else ''} {pairs}")
            lines.append("")
        lines.append("1")
        path.write_text("\n".join(lines) + "\n")
        return path
