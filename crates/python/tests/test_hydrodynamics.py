"""Hydrodynamic data of Capytaine, as it computes them here, through the converters: motions in waves against Capytaine's own."""

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from fenderline import hydrodynamics

cpt = pytest.importorskip("capytaine")

DOFS = ["Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw"]
# Capytaine's y is to port and its z up.
SIGNS = np.array([1, -1, -1, 1, -1, -1])
OMEGAS = [0.4, 0.6, 0.8, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0, 2.2, 2.4, 2.7, 3.0, 3.4]
HEADINGS = [math.radians(degrees) for degrees in (0, 45, 90, 135)] + [math.pi]


@pytest.fixture(scope="module")
def dataset() -> Any:
    """A coarse box barge of 40 m in deep water: some seconds."""
    cpt.set_logging("ERROR")
    mesh = cpt.mesh_parallelepiped(
        size=(40.0, 12.0, 6.0), resolution=(16, 6, 4), center=(0.0, 0.0, 0.0), missing_sides={"top"}
    ).immersed_part()
    body = cpt.FloatingBody(
        mesh=mesh,
        lid_mesh=mesh.generate_lid(),
        dofs=cpt.rigid_body_dofs(rotation_center=(0, 0, 0.5)),
        center_of_mass=(0, 0, 0.5),
        name="barge",
    )
    body.inertia_matrix = body.compute_rigid_body_inertia(rho=1025.0)
    body.hydrostatic_stiffness = body.compute_hydrostatic_stiffness(rho=1025.0)
    problems = [
        cpt.RadiationProblem(body=body, radiating_dof=dof, omega=omega, rho=1025.0)
        for dof in DOFS
        for omega in [*OMEGAS, math.inf]
    ]
    problems += [
        cpt.DiffractionProblem(body=body, wave_direction=heading, omega=omega, rho=1025.0)
        for heading in HEADINGS
        for omega in OMEGAS
    ]
    results = cpt.BEMSolver().solve_all(problems, progress_bar=False)
    return cpt.assemble_dataset(results)


def converted(dataset: Any) -> hydrodynamics.Hydrodynamics:
    inertia = np.diag(dataset["inertia_matrix"].sel(influenced_dof=DOFS, radiating_dof=DOFS).values)
    roll, pitch, yaw = (float(math.sqrt(inertia[k] / inertia[0])) for k in (3, 4, 5))
    data = hydrodynamics.from_capytaine(dataset, gravity_above_water_m=0.5, gyradii_m=(roll, pitch, yaw))
    assert data.notes == [] and data.problems == []
    return data


def motion(data: hydrodynamics.Hydrodynamics, omega: float, heading_deg: float) -> Any:
    """The frequency-domain motion in a wave of 1 m by the converted data."""
    mass = np.diag([data.mass_kg] * 3 + [data.mass_kg * k * k for k in data.gyradii_m])
    restoring = np.zeros((6, 6))
    restoring[2:5, 2:5] = data.restoring
    matrix = (
        -(omega**2) * (mass + np.array(data.added_mass[omega]))
        + 1j * omega * np.array(data.damping[omega])
        + restoring
    )
    return np.linalg.solve(matrix, np.array(data.excitation[omega, heading_deg]))


def test_motions_of_converted_data_are_those_of_capytaine(dataset: Any) -> None:
    data = converted(dataset)
    own = cpt.post_pro.rao(dataset.sel(omega=OMEGAS))
    for omega in OMEGAS:
        for heading in HEADINGS:
            # Waves to port of the bow there are waves to starboard here, folded to the mirror image: signs of sway, roll and yaw.
            mirror = np.array([1, -1, 1, -1, 1, -1])
            expected = own.sel(omega=omega, wave_direction=heading)
            name = "radiating_dof" if "radiating_dof" in expected.dims else "influenced_dof"
            expected = expected.sel({name: DOFS}).values
            found = motion(data, omega, round(math.degrees(heading), 6))
            scale = np.abs(expected).max()
            assert np.abs(found - mirror * SIGNS * expected.conj()).max() < 2e-3 * scale


def test_wamit_files_of_capytaine_give_the_same_data(dataset: Any, tmp_path: Path) -> None:
    cpt.export_dataset(tmp_path / "barge", dataset, format="wamit")
    data = converted(dataset)
    # Capytaine writes numbers with dimensions over rho and g.
    again = hydrodynamics.from_wamit(
        tmp_path / "barge",
        restoring=data.restoring,
        mass_kg=data.mass_kg,
        gravity_above_water_m=0.5,
        gyradii_m=data.gyradii_m,
        gravity_mps2=float(dataset["g"]),
    )
    near = {round(omega, 4): omega for omega in again.damping}
    for omega in OMEGAS:
        other = near[round(omega, 4)]
        # On a coarse mesh the matrices are not quite symmetric; the file has their means.
        for one, two in ((again.added_mass[other], data.added_mass[omega]), (again.damping[other], data.damping[omega])):
            np.testing.assert_allclose(np.add(one, np.transpose(one)), np.add(two, np.transpose(two)), rtol=1e-4, atol=1e3)
    waves = {(round(w, 4), round(heading, 2)): x for (w, heading), x in again.excitation.items()}
    for (omega, heading), forces in data.excitation.items():
        np.testing.assert_allclose(waves[round(omega, 4), round(heading, 2)], forces, rtol=1e-3, atol=2e3)


@pytest.mark.filterwarnings("ignore:Doubt. added mass of")  # The numbers are places in the file, and not mutual.
def test_nemoh_files_give_the_numbers_in_them(tmp_path: Path) -> None:
    zones = []
    for j in range(6):
        rows = "\n".join(f" {w} " + " ".join(f"{10 * j + i + w} {0.5}" for i in range(6)) for w in (0.5, 1.0))
        zones.append(f'Zone t="Motion of body  1 in DoF  {j + 1}",I=2,F=POINT\n{rows}')
    header = 'VARIABLES="w (rad/s)"\n"A"\n"B"\n'
    (tmp_path / "RadiationCoefficients.tec").write_text(header + "\n".join(zones))
    rows = " 0.5 " + " ".join("2.0 0.3" for _ in range(6))
    zone = f'Zone t="Excitation force - beta =   30.000 deg",I=1,F=POINT\n{rows}'
    (tmp_path / "ExcitationForce.tec").write_text(header + zone)
    with pytest.warns(hydrodynamics.HydrodynamicsWarning, match="there are 2 frequencies, but 8 are needed"):
        data = hydrodynamics.from_nemoh(
            tmp_path,
            restoring=[[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            mass_kg=1.0,
            gravity_above_water_m=0.0,
            gyradii_m=(1.0, 1.0, 1.0),
        )
    assert data.added_mass[0.5][1][5] == 10 * 5 + 1 + 0.5
    assert data.added_mass[0.5][0][4] == -(10 * 4 + 0 + 0.5)
    assert math.inf not in data.added_mass
    # 30 degrees to port, folded: sway of the mirror image, conjugate.
    force = data.excitation[0.5, 30.0]
    assert force[0] == pytest.approx(2.0 * complex(math.cos(0.3), -math.sin(0.3)))
    assert force[1] == pytest.approx(force[0]) and force[2] == pytest.approx(-force[0])


def test_the_file_has_all_tables(dataset: Any) -> None:
    text = converted(dataset).text()
    tables = [line for line in text.splitlines() if line.startswith("=")]
    assert tables == [
        "= fenderline hydrodynamic data 1",
        *(f"= {name}" for name in ("ship", "radiation", "infinite", "excitation")),
    ]


def test_mean_drift_of_capytaine_is_taken_and_mirrored(dataset: Any) -> None:
    import xarray

    directions = dataset["wave_direction"].values
    along = np.arange(len(OMEGAS) * len(directions) ** 2, dtype=float).reshape(len(OMEGAS), len(directions), -1)
    names = ("drift_force_surge", "drift_force_sway", "drift_force_yaw")
    coordinates = {"omega": OMEGAS, "wave_direction_k": directions, "wave_direction_l": directions}
    forces = {
        name: xarray.DataArray(factor * along + 0j, coords=coordinates, dims=list(coordinates))
        for name, factor in zip(names, (1.0, 10.0, 100.0), strict=True)
    }
    data = converted(dataset.merge(xarray.Dataset(forces), join="outer"))
    assert len(data.drift) == len(OMEGAS) * len(HEADINGS)
    # To port there; folded to starboard, where sway and yaw of the mirror image have the signs that Capytaine's axes give them.
    index = 2
    value = along[3, index, index]
    assert data.drift[OMEGAS[3], round(math.degrees(HEADINGS[index]), 6)] == [value, 10 * value, 100 * value]
    assert "= drift" in data.text()
