"""Checks of data against what does not depend on their file: the dispersion relation, the depth and the size of the hull."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._panel import Panel
from fenderline.hydrodynamics._waves import haskind_factor, over_all_headings, wave_number_radpm

#: Above the first, exciting forces and damping contradict each other; a reading is clear if the next one is worse by the second.
FAR, CLEAR = math.log(1.5), math.log(1.3)
#: From where on the depth is doubted. The open-water data of this repository agree within 3 % at their depth, and are off by 25 to 50 % at twice this depth.
SHALLOW = math.log(1.2)
#: Where they contradict each other by more than this whatever the depth, it is said.
DOUBT = math.log(2.5)
#: At a wall, hull and image: the exciting force of the pair is that of the hull, the damping half of it. How near to a factor of two, and how even.
WALL = (0.08, 0.06)
#: How far the mass by long waves may be from that of the ship before it is said, and before it is an error.
MASS = (0.2, 0.4)


def contradiction(panel: Panel) -> tuple[float, float] | None:
    """How far the damping is from what the exciting forces ask for (Haskind's relation), over all frequencies at which it counts: the
    root of the mean square of the logarithm, and the mean of the logarithm. `None` where the headings do not cover."""
    integral = over_all_headings(panel.headings_deg, np.nan_to_num(panel.force))
    if integral is None:
        return None
    logs = []
    most_radpm = panel.resolved_radpm()
    for row, w in enumerate(panel.omega):
        near = int(np.argmin(np.abs(panel.wave_omega - w)))
        if abs(panel.wave_omega[near] / w - 1.0) > 1e-3 or not np.isfinite(panel.damping[row]).all():
            continue
        if wave_number_radpm(w, panel.depth_m, panel.gravity_mps2) > most_radpm:
            continue
        factor = haskind_factor(w, panel.depth_m, panel.gravity_mps2, panel.water_kgpm3)
        for k in (0, 1, 2):
            damping, asked = panel.damping[row, k, k], factor * integral[near, k]
            most = np.nanmax(panel.damping[:, k, k] / np.maximum(panel.omega, 1e-9))
            # As WAMIT has it, over the frequency, so that the choice of rows does not depend on what the column is taken for.
            if damping / w > 0.1 * most and asked > 0.0:
                logs.append(math.log(damping / asked))
    if len(logs) < 3:
        return None
    return math.sqrt(sum(x * x for x in logs) / len(logs)), sum(logs) / len(logs)


def is_at_wall(off: tuple[float, float]) -> bool:
    """Whether the damping is half of what the exciting forces ask for, evenly: a hull and her image behind a wall."""
    spread = math.sqrt(max(0.0, off[0] ** 2 - off[1] ** 2))
    return abs(off[1] + math.log(2.0)) < WALL[0] and spread < WALL[1]


def best_depth(panel: Panel) -> tuple[float, float] | None:
    """How far damping and exciting forces are from each other at the depth at which they agree best, and that depth (m)."""
    depths = [10.0 ** (0.05 * k) for k in range(0, 71)] + [math.inf]
    found = [(off[0], depth) for depth in depths if (off := contradiction(replace(panel, depth_m=depth))) is not None]
    return min(found, default=None)


def metres(depth_m: float, digits: int) -> str:
    """A depth in words."""
    return f"{depth_m:.{digits}g} m of water" if math.isfinite(depth_m) else "deep water"


def check_waves(panel: Panel, may_be_at_wall: bool) -> None:
    """Damping and exciting forces by Haskind's relation: a depth that is not that of the data is an error, other contradictions are said."""
    own = contradiction(panel)
    if own is None or own[0] <= SHALLOW or (may_be_at_wall and is_at_wall(own)):
        return
    found = best_depth(panel)
    if found is not None and found[0] < min(0.5 * own[0], SHALLOW):
        raise HydrodynamicsError(
            f"the depth is taken as {metres(panel.depth_m, 6)}, but damping and exciting forces are off by a factor of {math.exp(own[0]):.2g} "
            f"then (Haskind's relation); in about {metres(found[1], 2)} they agree within {100 * (math.exp(found[0]) - 1):.0f} %"
            + ("; for a hull at a wall give fold = False" if is_at_wall(own) else ""),
            panel.file,
            panel.line(panel.omega[0]),
        )
    if own[0] > DOUBT:
        panel.notes.append(
            f"Doubt: damping and exciting forces contradict each other by a factor of {math.exp(own[0]):.2g} (Haskind's relation): "
            "are length, density and the files of one run?"
        )


def check_hull(panel: Panel, mass_kg: float) -> bool:
    """Long waves carry a ship as they carry the water in her place: the force is the acceleration times mass and added mass. A mass
    that is not that of the panels is an error. True if there are such waves, and the mass is right.

    With other bodies in the water the coupling to them would belong to it."""
    if panel.several:
        return False
    cube_m = (mass_kg / panel.water_kgpm3) ** (1.0 / 3.0)
    found: list[tuple[float, float]] = []
    for row, w in enumerate(panel.wave_omega):
        k = wave_number_radpm(w, panel.depth_m, panel.gravity_mps2)
        if k * cube_m > 0.2:
            continue
        near = int(np.argmin(np.abs(panel.omega - w)))
        if abs(panel.omega[near] / w - 1.0) > 0.05:
            continue
        for motion, along in ((0, 0.0), (1, 90.0)):
            for column, heading in enumerate(panel.headings_deg):
                turn = math.cos(math.radians(heading - along))
                if abs(turn) < 0.9:
                    continue
                force, added = abs(panel.force[row, column, motion]), panel.added[near, motion, motion]
                mass = force / (panel.gravity_mps2 * k * abs(turn)) - added
                if math.isfinite(mass):
                    found.append((mass / mass_kg, w))
    if not found:
        return False
    ratio = sorted(found)[len(found) // 2]
    off = abs(ratio[0] - 1.0)
    if off > MASS[0]:
        text = (
            f"the mass is {mass_kg:.4g} kg, but by the forces of long waves ({ratio[1]:.3g} rad/s and others) the panels displace "
            f"{ratio[0]:.2f} of that: are mass, length scale, depth and density those of these files?"
        )
        if off > MASS[1]:
            raise HydrodynamicsError(text, panel.file, panel.line(ratio[1]))
        panel.notes.append(f"Doubt: {text}")
        return False
    return True


def check_restoring(panel: Panel, heave_npm: float, mass_kg: float) -> None:
    """Long waves lift a ship by her restoring in heave."""
    if panel.several or not heave_npm > 0.0:
        return
    cube_m = (mass_kg / panel.water_kgpm3) ** (1.0 / 3.0)
    for row, w in enumerate(panel.wave_omega):
        k = wave_number_radpm(w, panel.depth_m, panel.gravity_mps2)
        if k * cube_m > 0.1:
            return
        lifts = np.abs(panel.force[row, :, 2])
        if not np.isfinite(lifts).all():
            continue
        ratio = float(np.median(lifts)) / heave_npm
        if not 0.6 < ratio < 1.4:
            raise HydrodynamicsError(
                f"the restoring in heave is {heave_npm:.4g} N/m, but a long wave ({w:.3g} rad/s) lifts with {ratio:.2f} of that: is the "
                "restoring that of this hull?",
                panel.file,
                panel.line(w),
            )
        return
