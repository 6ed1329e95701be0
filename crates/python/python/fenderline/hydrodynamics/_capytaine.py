"""Datasets of Capytaine."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from fenderline.hydrodynamics._errors import HydrodynamicsError
from fenderline.hydrodynamics._panel import Panel, gyradii
from fenderline.hydrodynamics._waves import Array

_DOFS = ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")
_DRIFTS = ("drift_force_surge", "drift_force_sway", "drift_force_yaw")


def read(dataset: Any, body: int | str | None) -> Panel:
    """Reads a dataset or the NetCDF file at a path."""
    file: Path | str = "the dataset"
    if isinstance(dataset, (str, Path)):
        file = Path(dataset)
        if not file.is_file():
            raise HydrodynamicsError("there is no such file", file)
        try:
            import xarray
        except ImportError as error:
            raise ImportError("datasets of Capytaine need xarray, and h5netcdf or netCDF4: pip install xarray h5netcdf h5py") from error
        try:
            with xarray.open_dataset(file) as opened:
                dataset = opened.load()
        except (OSError, ValueError) as error:
            raise HydrodynamicsError(f"xarray cannot read it as NetCDF: {error}", file) from error
    # What cannot be done without.
    for name in ("added_mass", "radiation_damping"):
        if name not in dataset:
            raise HydrodynamicsError(f"the dataset has no `{name}`", file)
    for name in ("influenced_dof", "radiating_dof", "wave_direction"):
        if name not in dataset.coords:
            raise HydrodynamicsError(f"the dataset has no coordinate `{name}`", file)
    if "excitation_force" not in dataset and not {"Froude_Krylov_force", "diffraction_force"} <= set(dataset):
        raise HydrodynamicsError("the dataset has no `excitation_force`, nor its two parts", file)
    notes: list[str] = []
    dofs, index, count = _body(dataset, body, file, notes)

    def picked(name: str, *dims: str) -> Array:
        data = dataset[name]
        if "complex" in data.dims:
            data = data.sel(complex="re") + 1j * data.sel(complex="im")
        chosen = {dim: dofs for dim in ("influenced_dof", "radiating_dof") if dim in data.dims}
        for extra in [dim for dim in data.dims if dim not in dims]:
            if data.sizes[extra] != 1:
                raise HydrodynamicsError(f"`{name}` varies with `{extra}`: choose one with dataset.isel({extra}=0)", file)
            data = data.isel({extra: 0})
        missing = [dim for dim in dims if dim not in data.dims]
        if missing:
            raise HydrodynamicsError(f"`{name}` has no dimension {', '.join(missing)}", file)
        values: Array = data.sel(chosen).transpose(*dims).values
        return values

    frequencies = "omega"
    if frequencies not in dataset.dims:
        raise HydrodynamicsError(
            f"the dataset's frequencies must be `omega`, but its dimensions are {', '.join(map(str, dataset.dims))}: "
            "swap them with dataset.swap_dims",
            file,
        )
    omega = np.array(dataset["omega"].values, float)
    finite = np.flatnonzero(np.isfinite(omega) & (omega > 0.0))
    finite = finite[np.argsort(omega[finite])]
    if not len(finite):
        raise HydrodynamicsError("the dataset has no frequency above zero", file)
    at_infinity = np.flatnonzero(np.isinf(omega))
    added = picked("added_mass", "omega", "influenced_dof", "radiating_dof")
    damping = picked("radiation_damping", "omega", "influenced_dof", "radiating_dof")
    dims = ("omega", "wave_direction", "influenced_dof")
    if "excitation_force" in dataset:
        force = picked("excitation_force", *dims)
    else:
        force = picked("Froude_Krylov_force", *dims) + picked("diffraction_force", *dims)
    headings = np.degrees(np.array(dataset["wave_direction"].values, float))
    depth, water, gravity = (
        float(np.ravel(dataset[name].values)[0]) if name in dataset else default
        for name, default in (("water_depth", math.inf), ("rho", 1000.0), ("g", 9.81))
    )
    panel = Panel(
        source="Capytaine",
        file=file,
        omega=omega[finite],
        added=added[finite],
        damping=damping[finite],
        infinite=added[at_infinity[0]] if len(at_infinity) else None,
        wave_omega=omega[finite],
        headings_deg=headings,
        # Capytaine's e^(-i omega t) is the conjugate.
        force=np.conj(force[finite]),
        depth_m=depth,
        gravity_mps2=gravity,
        water_kgpm3=water,
        several=count > 1,
        notes=notes,
    )
    if all(name in dataset for name in _DRIFTS):
        panel.drift = _drift(dataset, panel)
    if "hydrostatic_stiffness" in dataset:
        panel.restoring = picked("hydrostatic_stiffness", "influenced_dof", "radiating_dof")
    if "inertia_matrix" in dataset:
        inertia = picked("inertia_matrix", "influenced_dof", "radiating_dof")
        if np.isfinite(inertia).all() and inertia[0, 0] > 0.0:
            panel.mass_kg = float(inertia[0, 0])
            panel.gyradii_m = gyradii(inertia, panel.mass_kg)
    if "rotation_center" in dataset:
        centre = np.array(dataset["rotation_center"].values, float).reshape(-1, 3)
        if len(centre) == count:
            x, y = centre[index, 0], centre[index, 1]
            if x or y:
                panel.seen_from(x, y)
                panel.notes.append(f"Moved: phases are counted from the rotation centre, {x:g} m along x and {y:g} m along y from the origin.")
    return panel


def _body(dataset: Any, body: int | str | None, file: Path | str, notes: list[str]) -> tuple[list[str], int, int]:
    """The motions of the body that was asked for, its index and the number of bodies."""
    known = [str(name) for name in np.atleast_1d(dataset["influenced_dof"].values)]
    if all(dof in known for dof in _DOFS):
        if body not in (None, 1):
            raise HydrodynamicsError(f"body is {body!r}, but the dataset has one body", file)
        extra = [name for name in known if name not in _DOFS]
        if extra:
            notes.append(f"Left out: the motions {', '.join(extra)} and their coupling to the six.")
        return list(_DOFS), 0, 1
    # Motions of several bodies are called BODY__Surge.
    bodies = list(dict.fromkeys(name.rsplit("__", 1)[0] for name in known if "__" in name))
    listed = ", ".join(f"{k + 1} ({name})" for k, name in enumerate(bodies))
    if not bodies:
        missing = ", ".join(dof for dof in _DOFS if dof not in known)
        raise HydrodynamicsError(f"the dataset has no {missing}; its motions are {', '.join(known)}", file)
    if body is None:
        if len(bodies) > 1:
            raise HydrodynamicsError(f"the dataset has {len(bodies)} bodies: {listed}; say which, as body = {bodies[0]!r}", file)
        index = 0
    elif isinstance(body, str) and body in bodies:
        index = bodies.index(body)
    elif isinstance(body, int) and 1 <= body <= len(bodies):
        index = body - 1
    else:
        raise HydrodynamicsError(f"there is no body {body!r}; there are {listed}", file)
    own = [f"{bodies[index]}__{dof}" for dof in _DOFS]
    missing = ", ".join(name for name in own if name not in known)
    if missing:
        raise HydrodynamicsError(f"the dataset has no {missing}", file)
    if len(bodies) > 1:
        others = ", ".join(name for name in bodies if name != bodies[index])
        notes.append(
            f"Left out: body {others}, and the coupling of body {bodies[index]} to it; the other bodies are in the forces as if they were held."
        )
    return own, index, len(bodies)


def _drift(dataset: Any, panel: Panel) -> Array | None:
    """What `capytaine.post_pro.far_field_mean_drift_force` gives, if it was merged into the dataset."""
    drift = np.full((len(panel.wave_omega), len(panel.headings_deg), 3), np.nan)
    for k, name in enumerate(_DRIFTS):
        data = dataset[name]
        if "complex" in data.dims:
            data = data.sel(complex="re") + 1j * data.sel(complex="im")
        own = np.array(dataset["wave_direction_k"].values, float)
        for column, heading in enumerate(panel.headings_deg):
            near = own[int(np.argmin(np.abs(own - math.radians(heading))))]
            if abs(near - math.radians(heading)) > 1e-6:
                continue
            for row, w in enumerate(panel.wave_omega):
                drift[row, column, k] = complex(data.sel(omega=w, wave_direction_k=near, wave_direction_l=near).values).real
    return drift
