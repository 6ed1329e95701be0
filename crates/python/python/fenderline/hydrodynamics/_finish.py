"""From the results of a panel code to the data that the simulation reads."""

from __future__ import annotations

import copy
import math
import warnings
from collections.abc import Sequence
from typing import Any

import numpy as np

from fenderline.hydrodynamics._check import check_hull, check_restoring, check_waves, contradiction, is_at_wall
from fenderline.hydrodynamics._data import Hydrodynamics, Matrix
from fenderline.hydrodynamics._dropped import without_noise, without_numbers
from fenderline.hydrodynamics._errors import HydrodynamicsError, HydrodynamicsWarning
from fenderline.hydrodynamics._infinite import at_infinity
from fenderline.hydrodynamics._panel import MIRROR, MOTIONS, SIGNS, Panel, in_ships_axes, starboard_deg
from fenderline.hydrodynamics._sound import looked_through
from fenderline.hydrodynamics._waves import Array, Complexes

#: What a hull may be alike to, beyond its two sides.
SYMMETRIES = ("sides", "fore and aft", "revolution")
#: Motions along the middle line, and those across it: they are not coupled in a hull that is alike to both sides.
ALONG, ACROSS = (0, 2, 4), (1, 3, 5)
#: How far the mass that is given may be from that of the files: as the simulation refuses.
MASS = 0.03
#: How far the added masses of two motions by each other may differ, over the root of the product of both: as noise of a matrix in the simulation.
MUTUAL = 0.05
#: Added inertia in yaw of a body of revolution, over the displacement and the square of the cube root of its volume, at most: 0.06 for a cube.
CORNERS = 0.01
#: Draughts over the cube root of the displaced volume, and added masses at infinite frequency in surge, sway and heave over the mass, that the
#: simulation takes (crates/sim/src/seakeeping/check.rs).
DRAUGHTS = (3.0, 0.02)
ADDED = ((0.0, 5.0), (0.0, 20.0), (0.02, 50.0))


def finish(
    panel: Panel,
    *,
    mass_kg: float | None,
    gravity_above_water_m: float | None,
    gyradii_m: tuple[float, float, float] | None,
    reference_m: tuple[float, float, float] | None,
    restoring: Matrix | None,
    infinite: Matrix | None,
    fold: bool,
    symmetry: str | None,
    source: str,
    lowest_radps: float | None,
    highest_radps: float | None,
    repair_radps: Sequence[float] | None,
) -> Hydrodynamics:
    """Turns axes, looks the data through and says what was done."""
    mass = _mass(panel, mass_kg)
    gravity = panel.gravity_above_water_m if gravity_above_water_m is None else gravity_above_water_m
    radii = panel.gyradii_m if gyradii_m is None else gyradii_m
    reference = (panel.reference_m or (0.0, 0.0, 0.0)) if reference_m is None else reference_m
    for what, value in (("gravity_above_water_m", gravity), ("gyradii_m", radii)):
        if value is None:
            raise HydrodynamicsError(f"give {what}: the files do not have it", panel.file)
    assert gravity is not None and radii is not None
    for what, numbers in (("gyradii_m", radii), ("reference_m", reference)):
        if len(numbers) != 3 or not all(math.isfinite(x) for x in numbers):
            raise HydrodynamicsError(f"{what} must be three numbers, but is {numbers!r}")
    if infinite is not None:
        panel.infinite = np.array(infinite, float)
    stiffness = _restoring(panel, restoring, mass, gravity)
    panel.mass = np.array([mass] * 3 + [mass * k * k for k in radii])
    panel.stiff = np.array([0.0, 0.0, *np.diag(stiffness), 0.0])

    without_numbers(panel)
    if not len(panel.omega) or not len(panel.wave_omega):
        raise HydrodynamicsError("no frequency has numbers for all of added mass, damping and exciting forces", panel.file)
    check_waves(panel, may_be_at_wall=not fold)
    off = contradiction(panel)
    # At a wall the wave and its reflection push her.
    at_wall = not fold and (off is None or is_at_wall(off))
    _same_hull(panel, mass_kg, not at_wall and check_hull(panel, mass))
    if not at_wall:
        check_restoring(panel, float(stiffness[0, 0]), mass)
    _ship_axes(panel)
    _alike(panel, symmetry, fold)
    before = copy.deepcopy(panel)
    without_noise(panel, np.diag(panel.mass))
    _check_mutual(panel)
    repairs, problems = looked_through(panel, lowest_radps, highest_radps, repair_radps)
    if not problems:
        wrong = at_infinity(panel)
        problems += [wrong] if wrong else []
    elif panel.infinite is None and len(panel.omega):
        at_infinity(panel)
    problems += _headings(panel) + _float(stiffness) + _likely(panel, stiffness, mass)
    for note in panel.notes:
        warnings.warn(note, HydrodynamicsWarning, stacklevel=3)
    if problems:
        warnings.warn("The simulation would refuse: " + "; ".join(problems), HydrodynamicsWarning, stacklevel=3)
    return Hydrodynamics(
        source=source or panel.source,
        mass_kg=mass,
        gyradii_m=radii,
        gravity_above_water_m=gravity,
        restoring=stiffness.tolist(),
        added_mass={float(w): m.tolist() for w, m in zip(panel.omega, panel.added, strict=True)}
        | ({} if panel.infinite is None else {math.inf: panel.infinite.tolist()}),
        damping={float(w): m.tolist() for w, m in zip(panel.omega, panel.damping, strict=True)},
        excitation={
            (float(w), float(heading)): [complex(x) for x in panel.force[row, column]]
            for row, w in enumerate(panel.wave_omega)
            for column, heading in enumerate(panel.headings_deg)
        },
        drift={}
        if panel.drift is None
        else {
            (float(w), float(heading)): [float(x) for x in panel.drift[row, column]]
            for row, w in enumerate(panel.wave_omega)
            for column, heading in enumerate(panel.headings_deg)
        },
        depth_m=panel.depth_m,
        water_kgpm3=panel.water_kgpm3,
        reference_m=reference,
        notes=list(panel.notes),
        problems=problems,
        before=before,
        repairs=repairs,
    )


def _mass(panel: Panel, given: float | None) -> float:
    mass = panel.mass_kg if given is None else given
    if mass is None:
        raise HydrodynamicsError("give mass_kg: the files do not have it", panel.file)
    if not (math.isfinite(mass) and mass > 0.0):
        raise HydrodynamicsError(f"the mass must be above 0, but is {mass:g} kg", panel.file)
    return mass


def _same_hull(panel: Panel, given: float | None, is_right: bool) -> None:
    """A mass that is not that of the files is an error, unless long waves say that it is right."""
    if given is None or panel.mass_kg is None or abs(given / panel.mass_kg - 1.0) <= MASS:
        return
    text = f"mass_kg is given as {given:.5g}, but by the files the hull has {panel.mass_kg:.5g} kg"
    if not is_right and not panel.several:
        raise HydrodynamicsError(f"{text}: a hull of another size?", panel.file)
    panel.notes.append(f"Doubt: {text}" + ("; long waves push her as the given mass asks." if is_right else "."))


def _restoring(panel: Panel, given: Matrix | None, mass_kg: float, gravity_above_water_m: float) -> Array:
    if given is not None:
        matrix = np.array(given, float)
        if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
            raise HydrodynamicsError("restoring must be three rows of three numbers: heave, roll and pitch")
        return matrix
    if panel.restoring is None:
        raise HydrodynamicsError("give restoring: the files do not have it", panel.file)
    own: Array = in_ships_axes(panel.restoring)[2:5, 2:5].copy()
    theirs = panel.gravity_above_water_m
    if theirs is not None and abs(theirs - gravity_above_water_m) > 1e-3:
        change = -mass_kg * panel.gravity_mps2 * (gravity_above_water_m - theirs)
        own[1, 1] += change
        own[2, 2] += change
        panel.notes.append(
            f"Changed: restoring of roll and pitch by {change:.4g} N m, for the centre of gravity {gravity_above_water_m:g} m above the water "
            f"instead of {theirs:g} m as in the files."
        )
    return own


def _ship_axes(panel: Panel) -> None:
    """To the axes of the ship, headings in their order; those that are the same angle are one."""
    panel.added, panel.damping = in_ships_axes(panel.added), in_ships_axes(panel.damping)
    if panel.infinite is not None:
        panel.infinite = in_ships_axes(panel.infinite)
    panel.force = panel.force * SIGNS
    if panel.drift is not None:
        panel.drift = panel.drift * SIGNS[[0, 1, 5]]
    headings = [starboard_deg(heading) for heading in panel.headings_deg]
    order = sorted({heading: column for column, heading in enumerate(headings)}.items())
    columns = [column for _, column in order]
    panel.headings_deg = np.array([heading for heading, _ in order])
    panel.force = panel.force[:, columns]
    panel.drift = None if panel.drift is None else panel.drift[:, columns]


def _add(panel: Panel, headings: Array, force: Complexes, drift: Array | None) -> None:
    """Adds headings that the data do not have."""
    new = [k for k, heading in enumerate(headings) if np.abs(panel.headings_deg - heading).min() > 1e-3]
    headings = np.concatenate([panel.headings_deg, headings[new]])
    order = np.argsort(headings)
    panel.force = np.concatenate([panel.force, force[:, new]], axis=1)[:, order]
    if panel.drift is not None and drift is not None:
        panel.drift = np.concatenate([panel.drift, drift[:, new]], axis=1)[:, order]
    panel.headings_deg = headings[order]


def _alike(panel: Panel, symmetry: str | None, fold: bool) -> None:
    """Headings that follow from the symmetry of the hull."""
    if symmetry is not None and symmetry not in SYMMETRIES:
        raise HydrodynamicsError(f"symmetry is {symmetry!r}, but must be None or one of: {', '.join(SYMMETRIES)}")
    drifts = [0, 1, 5]
    sides = {heading < 0 for heading in panel.headings_deg if abs(heading) not in (0.0, 180.0)}
    if fold and sides == {True}:
        # Waves from starboard as the mirror image of those from port.
        panel.headings_deg = np.abs(panel.headings_deg)
        order = np.argsort(panel.headings_deg)
        panel.headings_deg = panel.headings_deg[order]
        panel.force = (panel.force * MIRROR)[:, order]
        panel.drift = None if panel.drift is None else (panel.drift * MIRROR[drifts])[:, order]
    if symmetry in ("sides", "revolution"):
        _alike_to_both_sides(panel)
    if symmetry == "fore and aft":
        _check_alike(panel, [(0, 1), (0, 3), (2, 4), (1, 5), (3, 5)], "fore and aft")
        image = np.array([-1.0, 1.0, 1.0, 1.0, -1.0, -1.0])
        drift = None if panel.drift is None else panel.drift * image[drifts]
        _add(panel, 180.0 - panel.headings_deg, panel.force * image, drift)
        panel.notes.append("Filled: headings beyond abeam are the mirror image of those before it, for a hull that is alike fore and aft, as given.")
    elif symmetry == "revolution":
        for one, two in ((0, 1), (3, 4)):
            for what, matrices in (("added mass", panel.added), ("damping", panel.damping)):
                # The median, for at irregular frequencies they may differ.
                most = np.abs(matrices[:, one, one]).max()
                off = float(np.median(np.abs(matrices[:, one, one] - matrices[:, two, two])))
                if off > 0.05 * most:
                    raise HydrodynamicsError(
                        f"symmetry is given as revolution, but the {what} of {MOTIONS[one]} and {MOTIONS[two]} differ by "
                        f"{100 * off / most:.0f} %",
                        panel.file,
                    )
        # What turns about its own axis moves no water, unless it has corners.
        turning = float(np.median(np.abs(panel.added[:, 5, 5])))
        scale = panel.mass[0] * (panel.mass[0] / panel.water_kgpm3) ** (2.0 / 3.0)
        if turning > CORNERS * scale:
            raise HydrodynamicsError(
                f"symmetry is given as revolution, but she moves water as she yaws (added inertia {turning:.3g} kg m²): a body with corners?",
                panel.file,
            )
        own = panel.headings_deg[0]
        headings = np.arange(0.0, 181.0, 15.0)
        force = np.stack([_turned(panel.force[:, 0], heading - own) for heading in headings], axis=1)
        drift = panel.drift
        if drift is not None:
            six = np.zeros((len(drift), 6))
            six[:, drifts] = drift[:, 0]
            drift = np.stack([_turned(six, heading - own)[:, drifts] for heading in headings], axis=1)
        panel.headings_deg, panel.force, panel.drift = headings, force, drift
        panel.notes.append(f"Filled: all headings are that of {own:g} degrees turned, for a body of revolution, as given.")


def _alike_to_both_sides(panel: Panel) -> None:
    """Takes couplings across the middle line as noise, and one side of headings that go all round."""
    _check_alike(panel, [(i, j) for i in ALONG for j in ACROSS], "sides")
    for matrices in (panel.added, panel.damping):
        for i in ALONG:
            for j in ACROSS:
                matrices[:, i, j] = matrices[:, j, i] = 0.0
    if panel.infinite is not None:
        for i in ALONG:
            for j in ACROSS:
                panel.infinite[i, j] = panel.infinite[j, i] = 0.0
    panel.notes.append("Filled: couplings across the middle line are zero, for a hull that is alike to both sides, as given.")
    half = (panel.headings_deg >= 0.0) & (panel.headings_deg <= 180.0)
    if not half.all() and half.any():
        panel.headings_deg, panel.force = panel.headings_deg[half], panel.force[:, half]
        panel.drift = None if panel.drift is None else panel.drift[:, half]
        panel.notes.append("Cut: headings of waves from starboard, which are the mirror image of the others.")


def _turned(forces: Any, degrees: float) -> Any:
    """Forces turned to starboard by an angle."""
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    turned = forces.copy()
    for x, y in ((0, 1), (3, 4)):
        turned[:, x] = c * forces[:, x] - s * forces[:, y]
        turned[:, y] = s * forces[:, x] + c * forces[:, y]
    return turned


def _check_alike(panel: Panel, pairs: list[tuple[int, int]], what: str) -> None:
    for i, j in pairs:
        scale = math.sqrt(np.abs(panel.added[:, i, i]).max() * np.abs(panel.added[:, j, j]).max())
        # The median, for at irregular frequencies a mesh that is not quite alike shows.
        off = float(np.median(np.abs(panel.added[:, i, j])))
        if off > 0.1 * scale:
            raise HydrodynamicsError(
                f"symmetry is given as {what}, but {MOTIONS[i]} and {MOTIONS[j]} are coupled by {100 * off / scale:.0f} %",
                panel.file,
            )


def _headings(panel: Panel) -> list[str]:
    """Gaps of the headings, as the simulation refuses them."""
    at = panel.headings_deg
    help_ = "; for a hull that is alike give symmetry = \"fore and aft\", or \"revolution\" for a body of revolution"
    known = ", ".join(f"{heading:g}" for heading in at[:6]) + (" …" if len(at) > 6 else "")
    if len(at) < 2 or np.diff(at).max() > 45.5:
        return [f"the headings leave a gap (there are {known} degrees){help_}"]
    half = abs(at[0]) < 0.06 and abs(at[-1] - 180.0) < 0.06
    if not half and at[0] + 360.0 - at[-1] > 45.5:
        return [f"the headings cover neither 0 to 180 degrees nor all round (there are {known} degrees){help_}"]
    return []


def _check_mutual(panel: Panel) -> None:
    """Two motions push each other alike: says where they do not, for the file has their mean."""
    for i in range(6):
        for j in range(i + 1, 6):
            one, two = panel.added[:, i, j], panel.added[:, j, i]
            scale = math.sqrt(float(np.abs(panel.added[:, i, i]).max() * np.abs(panel.added[:, j, j]).max()))
            # The median, for at irregular frequencies they may differ.
            off = float(np.median(np.abs(one - two)))
            if off > MUTUAL * scale:
                panel.notes.append(
                    f"Doubt: added mass of {MOTIONS[i]} by {MOTIONS[j]} and of {MOTIONS[j]} by {MOTIONS[i]} must be the same, but differ by "
                    f"{100 * off / scale:.0f} % of the root of the product of both motions: the mean is taken."
                )


def _likely(panel: Panel, stiffness: Array, mass_kg: float) -> list[str]:
    """Restoring and added mass that no ship has, as the simulation refuses them."""
    volume = mass_kg / panel.water_kgpm3
    # The displaced volume over draughts of three cube roots of the volume, and of 2 % of one.
    least, most = (panel.water_kgpm3 * 9.80665 * volume ** (2.0 / 3.0) / draught for draught in DRAUGHTS)
    found = []
    heave = float(stiffness[0, 0])
    if heave > 0.0 and not least <= heave <= most:
        found.append(
            f"the restoring of heave is {heave:.4g} N/m, but of the hulls of this displacement that the simulation takes it is {least:.3g} to "
            f"{most:.3g} (a spar deeper than three cube roots of her volume is not one)"
        )
    if panel.infinite is not None:
        for k, (low, high) in enumerate(ADDED):
            share = float(panel.infinite[k, k]) / mass_kg
            if not low <= share <= high:
                found.append(f"the added mass of {MOTIONS[k]} at infinite frequency is {share:.3g} of the mass, but must be {low:g} to {high:g}")
    return found


def _float(stiffness: Array) -> list[str]:
    """Motions without restoring."""
    return [
        f"the restoring of {name} is {stiffness[k, k]:.3g}: she does not float upright alone (is gravity in it, are moorings left out?)"
        for k, name in enumerate(("heave", "roll", "pitch"))
        if not stiffness[k, k] > 0.0
    ]
