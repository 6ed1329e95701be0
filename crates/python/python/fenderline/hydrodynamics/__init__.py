"""Hydrodynamic data of panel codes, as the file that ``vessel.NAME.hydrodynamics`` of a scenario names.

- :func:`from_capytaine`: a dataset of Capytaine, or its NetCDF file.
- :func:`from_wamit`: files ``.1`` and ``.3``, and ``.hst``, ``.out``, ``.cfg``, ``.8`` or ``.9`` if there are any.
- :func:`from_hams`: the folder of a case of HAMS.
- :func:`from_nemoh`: the folder of a case or of the results of Nemoh 2 or 3.
- :func:`from_aqwa`: the file ``.AH1`` or ``.LIS`` of AQWA.

- :func:`read`: the file itself, read back.

Each returns :class:`Hydrodynamics`: :meth:`~Hydrodynamics.picture` draws the data, :meth:`~Hydrodynamics.motion` gives a motion to compare
with that of the panel code, :meth:`~Hydrodynamics.write` writes the file.

What is cut, filled, repaired or left out is a line of :attr:`~Hydrodynamics.notes`, of the head of the file, and a
:class:`HydrodynamicsWarning`. What cannot be right is a :class:`HydrodynamicsError` with file, line and reason. What the simulation would
refuse is in :attr:`~Hydrodynamics.problems`: the picture and the motions are there, a file is not written.

All codes have x forward, y to port and z up. The file has forward, to starboard and down: sway, heave, pitch and yaw
change their signs, headings turn clockwise, and phases are of the form e^(i omega t) with the crest at the reference point.

All functions take these:

``mass_kg``, ``gravity_above_water_m``, ``gyradii_m``
    Displacement, centre of gravity above the still water, and radii of gyration in roll, pitch and yaw about the centre of gravity. Where the
    files have them they may be left out.
``restoring``
    Restoring in heave (down), roll and pitch about the reference point, gravity included (N/m, N, N m); where the files have it
    that may be left out. If you give a centre of gravity that is not theirs, roll and pitch are changed for that, and it is said.
``reference_m``
    The reference point (the origin of the body's motions) from the centre of gravity: forward, to starboard, up; zero, or what the
    files say, if left out.
``body``
    Of several bodies, the one to take: its number from 1, or its name where the files have names. Others are left out, and that is said.
``lowest_radps``, ``highest_radps``
    The frequencies to use. Without them all are used that are sound.
``repair_radps``
    Single frequencies to replace by the curve through their neighbours. Without it, those that leap out of the curve or are negative, if
    their neighbours are sound; ``()`` repairs none.
``symmetry``
    ``"fore and aft"`` or ``"revolution"``, for a hull of which the panel code ran only some headings; ``"sides"`` takes the
    couplings across the middle line as noise.
``fold``
    Waves from starboard are the mirror image of those from port, for a hull that is alike to both sides in open water.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from fenderline.hydrodynamics import _aqwa, _capytaine, _file, _hams, _nemoh, _wamit
from fenderline.hydrodynamics._data import Hydrodynamics, Matrix
from fenderline.hydrodynamics._errors import HydrodynamicsError, HydrodynamicsWarning
from fenderline.hydrodynamics._finish import finish

__all__ = [
    "Hydrodynamics",
    "HydrodynamicsError",
    "HydrodynamicsWarning",
    "from_aqwa",
    "from_capytaine",
    "from_hams",
    "from_nemoh",
    "from_wamit",
    "read",
]


def read(path: str | Path) -> Hydrodynamics:
    """Reads the file that a scenario names, for its picture and its motions."""
    return _file.read(Path(path))


def from_capytaine(
    dataset: Any,
    *,
    gravity_above_water_m: float,
    gyradii_m: tuple[float, float, float] | None = None,
    mass_kg: float | None = None,
    reference_m: tuple[float, float, float] = (0.0, 0.0, 0.0),
    restoring: Matrix | None = None,
    infinite: Matrix | None = None,
    body: int | str | None = None,
    lowest_radps: float | None = None,
    highest_radps: float | None = None,
    repair_radps: Sequence[float] | None = None,
    symmetry: str | None = None,
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From a dataset of Capytaine, or the path of its NetCDF file (xarray and h5netcdf or netCDF4 read it).

    The dataset needs `added_mass`, `radiation_damping`, `excitation_force` (or its two parts), and
    `hydrostatic_stiffness`. Mean drift is taken from what `capytaine.post_pro.far_field_mean_drift_force` gives, if it was merged into the
    dataset. `mass_kg` and `gyradii_m` are those of `inertia_matrix` if they are not given. `reference_m` is the rotation centre of its
    motions from the centre of gravity. `infinite` is the added mass at infinite frequency in Capytaine's axes, where the dataset has none.
    """
    return finish(
        _capytaine.read(dataset, body),
        mass_kg=mass_kg,
        gravity_above_water_m=gravity_above_water_m,
        gyradii_m=gyradii_m,
        reference_m=reference_m,
        restoring=restoring,
        infinite=infinite,
        fold=fold,
        symmetry=symmetry,
        source=source,
        lowest_radps=lowest_radps,
        highest_radps=highest_radps,
        repair_radps=repair_radps,
    )


def from_wamit(
    path: str | Path,
    *,
    mass_kg: float | None = None,
    gravity_above_water_m: float | None = None,
    gyradii_m: tuple[float, float, float],
    restoring: Matrix | None = None,
    infinite: Matrix | None = None,
    length_m: float | None = None,
    depth_m: float | None = None,
    gravity_mps2: float | None = None,
    water_kgpm3: float | None = None,
    reference_m: tuple[float, float, float] | None = None,
    first_column: str | None = None,
    body: int | str | None = None,
    body_at_m: tuple[float, float, float] | None = None,
    lowest_radps: float | None = None,
    highest_radps: float | None = None,
    repair_radps: Sequence[float] | None = None,
    symmetry: str | None = None,
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From files of WAMIT in its form without dimensions: `path` with ``.1`` (added mass and damping), ``.3`` or ``.2`` (exciting
    forces) and, if there are any, ``.8`` or ``.9`` (mean drift), ``.hst`` (restoring), ``.out``, ``.gdf`` and ``.cfg`` (the run).

    `length_m` is WAMIT's ULEN. It, depth, gravity and density are taken from ``.out`` if they are not given, else 1 m, deep water,
    9.80665 m/s² and 1025 kg/m³; what is given must agree with ``.out``. Displacement, centre of gravity and `reference_m`, the origin of the
    body's axes from the centre of gravity, are those of ``.out`` if they are not given.

    `first_column` is what the first column of ``.1`` and ``.3`` is: ``"period"``, ``"frequency"``, ``"deep wave number"``, ``"wave number"``
    (both by the length) or ``"wave length"``. Without it, ``.cfg`` says so (IPEROUT), or the damping and the exciting forces do, which belong to
    each other only at their frequency (Haskind's relation). Of periods zero is infinite frequency and a negative one zero
    frequency; of frequencies and wave numbers it is the other way round.

    `body_at_m` is the place of the body in the axes of the run, x, y, and her turn in degrees to port (XBODY), for phases and headings; it
    is that of ``.out`` if it is not given.
    """
    panel = _wamit.read(
        _wamit.base_of(path),
        body=body,
        length_m=length_m,
        depth_m=depth_m,
        gravity_mps2=gravity_mps2,
        water_kgpm3=water_kgpm3,
        first_column=first_column,
        body_at_m=body_at_m,
    )
    return finish(
        panel,
        mass_kg=mass_kg,
        gravity_above_water_m=gravity_above_water_m,
        gyradii_m=gyradii_m,
        reference_m=reference_m,
        restoring=restoring,
        infinite=infinite,
        fold=fold,
        symmetry=symmetry,
        source=source,
        lowest_radps=lowest_radps,
        highest_radps=highest_radps,
        repair_radps=repair_radps,
    )


def from_hams(
    folder: str | Path,
    *,
    output: str = "Output",
    mass_kg: float | None = None,
    gravity_above_water_m: float | None = None,
    gyradii_m: tuple[float, float, float] | None = None,
    restoring: Matrix | None = None,
    infinite: Matrix | None = None,
    gravity_mps2: float | None = None,
    water_kgpm3: float | None = None,
    reference_m: tuple[float, float, float] | None = None,
    body: int | str | None = None,
    lowest_radps: float | None = None,
    highest_radps: float | None = None,
    repair_radps: Sequence[float] | None = None,
    symmetry: str | None = None,
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From the folder of a case of HAMS: ``Input/ControlFile.in`` says what the first column of ``Output/Wamit_format/*.1`` and ``*.3`` is, the
    depth and the length; ``Input/Hydrostatic.in`` has mass, centre of gravity and radii of gyration, ``*.hst`` the restoring.

    `output` is the name of the folder of its results. HAMS takes mass, centre of gravity and restoring as they were typed. Give your own where they are not those of the floating ship.
    Moorings and extra damping of ``Hydrostatic.in`` are left out, and that is said.
    """
    return finish(
        _hams.read(Path(folder), output=output, body=body, gravity_mps2=gravity_mps2, water_kgpm3=water_kgpm3),
        mass_kg=mass_kg,
        gravity_above_water_m=gravity_above_water_m,
        gyradii_m=gyradii_m,
        reference_m=reference_m,
        restoring=restoring,
        infinite=infinite,
        fold=fold,
        symmetry=symmetry,
        source=source,
        lowest_radps=lowest_radps,
        highest_radps=highest_radps,
        repair_radps=repair_radps,
    )


def from_nemoh(
    folder: str | Path,
    *,
    mass_kg: float | None = None,
    gravity_above_water_m: float | None = None,
    gyradii_m: tuple[float, float, float],
    restoring: Matrix | None = None,
    infinite: Matrix | None = None,
    depth_m: float | None = None,
    gravity_mps2: float | None = None,
    water_kgpm3: float | None = None,
    reference_m: tuple[float, float, float] | None = None,
    body: int | str | None = None,
    lowest_radps: float | None = None,
    highest_radps: float | None = None,
    repair_radps: Sequence[float] | None = None,
    symmetry: str | None = None,
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From the folder of a case of Nemoh, or that of its results: ``RadiationCoefficients.tec`` and ``ExcitationForce.tec``, and if there are any
    ``Nemoh.cal`` (depth, density, bodies), ``Mesh/KH.dat`` (restoring) and ``Mesh/Hydrostatics.dat`` (displacement, centre of gravity).

    Nemoh does not give infinite frequency there: `infinite` is the added mass at it, in Nemoh's axes; without it that
    of the highest frequencies by Ogilvie's relation is written, with its error.
    """
    panel = _nemoh.read(
        Path(folder), body=body, depth_m=depth_m, gravity_mps2=gravity_mps2, water_kgpm3=water_kgpm3
    )
    return finish(
        panel,
        mass_kg=mass_kg,
        gravity_above_water_m=gravity_above_water_m,
        gyradii_m=gyradii_m,
        reference_m=reference_m,
        restoring=restoring,
        infinite=infinite,
        fold=fold,
        symmetry=symmetry,
        source=source,
        lowest_radps=lowest_radps,
        highest_radps=highest_radps,
        repair_radps=repair_radps,
    )


def from_aqwa(
    path: str | Path,
    *,
    mass_kg: float | None = None,
    gravity_above_water_m: float | None = None,
    gyradii_m: tuple[float, float, float] | None = None,
    restoring: Matrix | None = None,
    infinite: Matrix | None = None,
    body: int | str | None = None,
    lowest_radps: float | None = None,
    highest_radps: float | None = None,
    repair_radps: Sequence[float] | None = None,
    symmetry: str | None = None,
    fold: bool = True,
    source: str = "",
) -> Hydrodynamics:
    """From the file ``.AH1`` of AQWA, or its listing ``.LIS``. Both have mass, restoring and depth, and their moments and phases are about the
    centre of gravity, so that `reference_m` is zero.

    Their forms are not documented to us: they are read as WEC-Sim's BEMIO and BEMRosetta read them. The listing has two to four digits fewer.
    """
    return finish(
        _aqwa.read(Path(path), body),
        mass_kg=mass_kg,
        gravity_above_water_m=gravity_above_water_m,
        gyradii_m=gyradii_m,
        reference_m=(0.0, 0.0, 0.0),
        restoring=restoring,
        infinite=infinite,
        fold=fold,
        symmetry=symmetry,
        source=source,
        lowest_radps=lowest_radps,
        highest_radps=highest_radps,
        repair_radps=repair_radps,
    )
