"""Frequencies at which a motion is off: how they are found, and how single ones are repaired."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from fenderline.hydrodynamics._panel import MOTIONS, Panel
from fenderline.hydrodynamics._waves import Array, haskind_factor, over_all_headings, wave_number_radpm

#: As the reader of the simulation refuses (crates/seakeeping/src): damping below zero of one motion and of several together over the
#: maxima, the most of it at the first and the last frequency, its largest step, and the fewest frequencies.
NEGATIVE, TOGETHER, ENDS, STEP, FEWEST = 0.01, 0.05, (0.6, 0.5), 0.6, 8
#: Logarithms of the damping over that by Haskind's relation: of an irregular frequency, and of sound ones at most.
OFF = (math.log(1.25), math.log(1.12))
#: The width of an irregular frequency, where the data are closer than that.
NARROW = 0.03
#: A single frequency is irregular if its damping or added mass is off the curve through its neighbours by more than the first share of
#: the maximum, and by more than the second multiple of what its neighbours are off without it.
IRREGULAR = (0.1, 6.0)


@dataclass(frozen=True)
class Repair:
    """A value that was replaced by the curve through its neighbours."""

    omega_radps: float
    motions: tuple[int, ...]
    """The motions, from 0."""


def faults(damping: Array) -> list[str | None]:
    """Why a frequency cannot be used, if so."""
    most = np.array([np.abs(damping[:, k, k]).max(initial=0.0) for k in range(6)])
    scale = np.where(most > 0.0, 1.0 / np.sqrt(np.maximum(most, 1e-300)), 0.0)
    found: list[str | None] = []
    for matrix in damping:
        own = np.diag(matrix)
        worst = int(np.argmin(np.where(most > 0.0, own / np.maximum(most, 1e-300), 0.0)))
        if own[worst] < -NEGATIVE * most[worst]:
            found.append(f"damping of {MOTIONS[worst]} is negative ({100 * own[worst] / most[worst]:.1f} % of its maximum)")
            continue
        values, vectors = np.linalg.eigh(0.5 * (matrix + matrix.T) * np.outer(scale, scale))
        if values[0] < -TOGETHER:
            one, two = sorted(np.argsort(-np.abs(vectors[:, 0]))[:2])
            found.append(
                f"damping of {MOTIONS[one]} and {MOTIONS[two]} together is negative ({100 * values[0]:.1f} % of its maximum"
                + ("; if the hull is alike to both sides, symmetry = \"sides\" takes that as noise)" if (one + two) % 2 else ")")
            )
            continue
        found.append(None)
    return found


def through(axis: Array, values: Any, at: int, skip: set[int]) -> Any:
    """The value by the cubic through two neighbours on each side, or fewer at the ends; `skip` are no neighbours."""
    below = [k for k in range(at - 1, -1, -1) if k not in skip][:2]
    above = [k for k in range(at + 1, len(axis)) if k not in skip][:2]
    own = below + above
    total = np.zeros_like(values[at])
    for k in own:
        weight = 1.0
        for other in own:
            if other != k:
                weight *= (axis[at] - axis[other]) / (axis[k] - axis[other])
        total = total + weight * values[k]
    return total


def contradictions(panel: Panel) -> Array | None:
    """By row and motion, the logarithm of the damping over that which the exciting forces ask for (Haskind's relation); zero where the damping
    is below a twentieth of its maximum or the headings do not resolve the waves, and minus infinity where it is negative. `None` where headings do not cover, or the relation does not
    hold."""
    integral = over_all_headings(panel.headings_deg, panel.force)
    if integral is None:
        return None
    most = np.abs(np.diagonal(panel.damping, axis1=1, axis2=2)).max(axis=0)
    logs = np.zeros((len(panel.omega), 6))
    most_radpm = panel.resolved_radpm()
    for row, w in enumerate(panel.omega):
        near = int(np.argmin(np.abs(panel.wave_omega - w)))
        if abs(panel.wave_omega[near] / w - 1.0) > 1e-3:
            continue
        # Beyond, the headings do not resolve the waves that she makes.
        if wave_number_radpm(w, panel.depth_m, panel.gravity_mps2) > most_radpm:
            continue
        factor = haskind_factor(w, panel.depth_m, panel.gravity_mps2, panel.water_kgpm3)
        for k in range(6):
            damping, asked = panel.damping[row, k, k], factor * integral[near, k]
            if abs(damping) > 0.05 * most[k] and asked > 0.0:
                logs[row, k] = math.log(damping / asked) if damping > 0.0 else -math.inf
    known = np.isfinite(logs) & (logs != 0.0)
    median = float(np.median(logs[known])) if known.sum() >= 8 else math.inf
    if abs(median + math.log(2.0)) < math.log(1.1):
        # At a wall the damping of hull and image is shared by both.
        logs[known] += math.log(2.0)
        return logs
    return logs if abs(median) < math.log(1.1) else None


def factor_of(log: float) -> str:
    """A contradiction in words."""
    return f"by a factor of {math.exp(abs(log)):.2g}" if math.isfinite(log) else "in sign"


@dataclass(frozen=True)
class Band:
    """Rows next to each other at which a motion is off."""

    start: int
    end: int
    motion: int
    reason: str


def irregular(panel: Panel) -> list[Band]:
    """Where a motion is off: where the headings cover, damping and exciting forces contradict each other; else a single frequency leaps out of the
    curve of its neighbours. And negative damping."""
    found = []
    logs = contradictions(panel)
    most = np.abs(np.diagonal(panel.damping, axis1=1, axis2=2)).max(axis=0)
    # Where the headings do not resolve the waves, Haskind's relation says nothing.
    unresolved = np.ones(len(panel.omega), bool)
    if logs is not None:
        numbers = [wave_number_radpm(w, panel.depth_m, panel.gravity_mps2) for w in panel.omega]
        unresolved = np.array(numbers) > panel.resolved_radpm()
    for k in range(6):
        curve = panel.damping[:, k, k]
        negative = curve < -NEGATIVE * most[k]
        if logs is not None:
            off = np.abs(logs[:, k])
            for start, end in bands((off > OFF[1]) | negative):
                worst = start + int(np.argmax(off[start:end]))
                if off[worst] > OFF[0]:
                    found.append(Band(start, end, k, f"damping and exciting forces of {MOTIONS[k]} contradict each other {factor_of(logs[worst, k])}"))
                elif negative[start:end].any():
                    found.append(Band(start, end, k, _negative_words(k, curve[start:end], most[k])))
        else:
            for start, end in bands(negative):
                found.append(Band(start, end, k, _negative_words(k, curve[start:end], most[k])))
        leaps = np.zeros(len(curve), bool)
        for values in (curve, panel.added[:, k, k]):
            leaps |= _leaps(panel.omega, values)
        for row in np.flatnonzero(leaps & unresolved & ~negative):
            found.append(Band(int(row), int(row) + 1, k, f"{MOTIONS[k]} leaps out of the curve of its neighbours"))
    return sorted(found, key=lambda band: (band.start, band.end, band.motion))


def _negative_words(k: int, values: Array, most: float) -> str:
    return f"damping of {MOTIONS[k]} is negative ({100 * values.min() / most:.1f} % of its maximum)"


def _leaps(omega: Array, values: Array) -> npt.NDArray[np.bool_]:
    """Single values that leap out of the curve of their neighbours."""
    n, most = len(values), np.abs(values).max(initial=0.0)
    leaps = np.zeros(n, bool)
    for row in range(2, n - 2):
        off = abs(values[row] - through(omega, values, row, set()))
        if off < IRREGULAR[0] * most or most == 0.0:
            continue
        around = max(
            abs(values[near] - through(omega, values, near, {row}))
            for near in (row - 2, row - 1, row + 1, row + 2)
            if 0 < near < n - 1
        )
        leaps[row] = off > IRREGULAR[1] * around
    return leaps


def bands(mask: npt.NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First row and end of each run of true."""
    found, start = [], None
    for row, value in enumerate([*mask, False]):
        if value and start is None:
            start = row
        elif not value and start is not None:
            found.append((start, row))
            start = None
    return found


def is_single(omega: Array, band: Band) -> bool:
    """Whether a band is one frequency, or as narrow as one, with two neighbours on each side."""
    width = (omega[band.end - 1] - omega[band.start]) / omega[band.start]
    inside = band.start >= 2 and band.end <= len(omega) - 2
    return inside and (band.end - band.start == 1 or bool(width <= NARROW))


def repaired(panel: Panel, found: list[Band]) -> list[Repair]:
    """Replaces the rows of bands by the curve through their neighbours."""
    done: list[Repair] = []
    before_b, before_a = panel.damping.copy(), panel.added.copy()
    logs = contradictions(panel)
    groups: dict[tuple[int, int], list[Band]] = {}
    for band in found:
        groups.setdefault((band.start, band.end), []).append(band)
    for (start, end), own in groups.items():
        motions = tuple(sorted({band.motion for band in own}))
        forces: set[int] = set()
        for row in range(start, end):
            for k in motions:
                # The cubic has hold only of rows that are sound in this motion.
                skip = {r for band in found if band.motion == k for r in range(band.start, band.end)}
                for matrix, before in ((panel.damping, before_b), (panel.added, before_a)):
                    new = through(panel.omega, before, row, skip)
                    matrix[row, k, :], matrix[row, :, k] = new[k, :], new[:, k]
                if _force_repaired(panel, row, k, skip, logs is not None):
                    forces.add(k)
            done.append(Repair(float(panel.omega[row]), motions))
        where = f"{panel.omega[start]:.4g} rad/s"
        if end - start > 1:
            where = f"{panel.omega[start]:.4g} to {panel.omega[end - 1]:.4g} rad/s ({end - start} frequencies)"
        also = " and exciting forces" if forces else ""
        words = ", ".join(MOTIONS[k] for k in motions)
        reasons = "; ".join(dict.fromkeys(band.reason for band in own))
        panel.notes.append(
            f"Repaired: {where}, added mass and damping{also} of {words}, by the curve through the neighbours: {reasons}."
        )
    return done


def _force_repaired(panel: Panel, row: int, k: int, skip: set[int], by_haskind: bool) -> bool:
    """Exciting forces are off at an irregular frequency too, or are not: only those that are get the curve through their neighbours."""
    w = panel.omega[row]
    at = int(np.argmin(np.abs(panel.wave_omega - w)))
    if abs(panel.wave_omega[at] / w - 1.0) > 1e-3 or not 2 <= at < len(panel.wave_omega) - 2:
        return False
    others = {int(np.argmin(np.abs(panel.wave_omega - panel.omega[other]))) for other in skip} - {at}
    before = panel.force[at, :, k].copy()
    new = through(panel.wave_omega, panel.force[:, :, k], at, others)
    if by_haskind:
        # With the new damping, the forces that belong to it are nearer to Haskind's relation.
        factor = haskind_factor(w, panel.depth_m, panel.gravity_mps2, panel.water_kgpm3)

        def off() -> float:
            integral = over_all_headings(panel.headings_deg, panel.force[at : at + 1])
            asked = 0.0 if integral is None else factor * float(integral[0, k])
            damping = panel.damping[row, k, k]
            return abs(math.log(damping / asked)) if damping > 0.0 and asked > 0.0 else math.inf

        old = off()
        if old < OFF[1]:
            return False
        panel.force[at, :, k] = new
        if off() > 0.5 * old:
            panel.force[at, :, k] = before
            return False
        return True
    most = np.abs(panel.force[:, :, k]).max()
    around = max(
        np.abs(panel.force[near, :, k] - through(panel.wave_omega, panel.force[:, :, k], near, {at})).max()
        for near in (at - 1, at + 1)
    )
    leap = np.abs(before - new).max()
    if leap > IRREGULAR[0] * most and leap > IRREGULAR[1] * around:
        panel.force[at, :, k] = new
        return True
    return False
