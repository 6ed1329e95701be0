"""Files of panel codes as they are: a made-up hull in the forms of WAMIT, HAMS, Nemoh, AQWA and Capytaine, with the traits of public examples."""

import math
import re
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import made_up_hull as made_up
import numpy as np
import pytest
from fenderline import hydrodynamics
from fenderline.hydrodynamics import HydrodynamicsError, HydrodynamicsWarning
from made_up_hull import GYRADII, HEADINGS, INFINITE, MASS, RESTORING, Hull

# From a panel code's axes to the ship's, and to the mirror image: waves to port are taken as waves to starboard.
SIGNS = np.array([1, -1, -1, 1, -1, -1])
MIRROR = np.array([1, -1, 1, -1, 1, -1])


@pytest.fixture(scope="module")
def hull() -> Hull:
    return Hull()


@pytest.fixture(scope="module")
def shallow() -> Hull:
    return Hull(depth=10.0)


def quiet(make: Callable[[], hydrodynamics.Hydrodynamics]) -> hydrodynamics.Hydrodynamics:
    """Makes data with the notes as warnings, of which there are as many as notes, and one of what would be refused."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        data = make()
    said = [str(one.message) for one in caught if issubclass(one.category, HydrodynamicsWarning)]
    assert said[: len(data.notes)] == data.notes
    assert len(said) == len(data.notes) + bool(data.problems)
    return data


def wamit(base: Path, **also: Any) -> hydrodynamics.Hydrodynamics:
    own: dict[str, Any] = {"mass_kg": MASS, "gravity_above_water_m": 0.0, "gyradii_m": GYRADII, "gravity_mps2": made_up.GRAVITY} | also
    return quiet(lambda: hydrodynamics.from_wamit(base, **own))


def agrees(data: hydrodynamics.Hydrodynamics, hull: Hull, within: float = 2e-3) -> None:
    """Motions at all frequencies that are left, and at all headings, are those of the hull."""
    for row, omega in enumerate(hull.omegas):
        if min(abs(w - omega) for w in data.damping) > 1e-3 * omega:
            continue
        for column, heading in enumerate(hull.headings):
            expected = hull.motion(row, column) * SIGNS * (MIRROR if 0 < heading < 180 else 1)
            found = data.motion(omega, heading)
            scale = np.abs(expected) * np.array([1, 1, 1, 8, 30, 30])
            assert np.abs((found - expected) * np.array([1, 1, 1, 8, 30, 30])).max() < within * scale.max() + 1e-5, (omega, heading)


def notes_of(data: hydrodynamics.Hydrodynamics, kind: str) -> list[str]:
    return [note for note in data.notes if note.startswith(kind)]


def test_sound_files_give_motions_of_the_hull_and_no_note(hull: Hull, tmp_path: Path) -> None:
    data = wamit(hull.wamit(tmp_path / "box"))
    assert data.notes == [] and data.problems == []
    agrees(data, hull)
    np.testing.assert_allclose(data.restoring, RESTORING[2:5, 2:5], rtol=1e-5)


def test_a_stem_with_a_dot_finds_its_files(hull: Hull, tmp_path: Path) -> None:
    base = hull.wamit(tmp_path / "box.v2")
    assert len(wamit(base).damping) == len(hull.omegas)
    assert len(wamit(tmp_path / "box.v2.1").damping) == len(hull.omegas)


@pytest.mark.parametrize("column", ["period", "frequency", "wave number"])
def test_the_first_column_is_recognised(shallow: Hull, tmp_path: Path, column: str) -> None:
    data = wamit(shallow.wamit(tmp_path / "box", column=column), depth_m=10.0)
    agrees(data, shallow)
    assert len(notes_of(data, "Supposed: the first column")) == (column != "period")
    np.testing.assert_allclose(np.diag(data.added_mass[math.inf]), INFINITE, rtol=1e-5)


def test_a_first_column_that_is_something_else_is_an_error_at_its_file(shallow: Hull, tmp_path: Path) -> None:
    base = shallow.wamit(tmp_path / "box", column="wave number")
    with pytest.raises(HydrodynamicsError, match="taken for the period .*; as wave number damping and exciting forces agree") as caught:
        wamit(base, depth_m=10.0, first_column="period")
    assert caught.value.file == f"{base}.1" and caught.value.line == 1
    (tmp_path / "box.cfg").write_text("! a comment\nIPEROUT=2\n")
    with pytest.raises(HydrodynamicsError, match=r"taken for the frequency \(box.cfg says so\)"):
        wamit(base, depth_m=10.0)
    (tmp_path / "box.cfg").write_text("IPEROUT=4\n")
    assert "box.cfg says so" in wamit(base, depth_m=10.0).notes[0]


def test_too_few_headings_to_tell_the_first_column_ask_for_it(hull: Hull, tmp_path: Path) -> None:
    few = Hull(headings=np.array([0.0]))
    with pytest.raises(HydrodynamicsError, match="give first_column"):
        wamit(few.wamit(tmp_path / "box"))
    data = wamit(tmp_path / "box", first_column="period")
    assert "the headings leave a gap" in data.problems[0]
    with pytest.raises(HydrodynamicsError, match="the headings leave a gap"):
        data.text()


def test_a_depth_of_another_place_is_an_error(shallow: Hull, tmp_path: Path) -> None:
    base = shallow.wamit(tmp_path / "box")
    for depth_m in (20.0, math.inf):
        with pytest.raises(HydrodynamicsError, match=r"the depth is taken as .*in about (9|10|11)(\.\d)? m of water") as caught:
            wamit(base, depth_m=depth_m)
        assert caught.value.file == f"{base}.1" and caught.value.line is not None


def test_a_hull_of_another_size_is_an_error(hull: Hull, tmp_path: Path) -> None:
    base = hull.wamit(tmp_path / "box")
    with pytest.raises(HydrodynamicsError, match=r"by the forces of long waves .* the panels displace") as caught:
        wamit(base, mass_kg=3.0 * MASS)
    assert caught.value.file == f"{base}.1" and caught.value.line is not None
    with pytest.raises(HydrodynamicsError, match="contradict each other"):
        wamit(base, length_m=2.0)
    with pytest.raises(HydrodynamicsError, match="the restoring in heave is"):
        wamit(base, restoring=(4.0 * RESTORING[2:5, 2:5]).tolist())


def test_the_length_of_the_run_scales_all_files(hull: Hull, tmp_path: Path) -> None:
    base = hull.wamit(tmp_path / "box", length=60.0)
    agrees(wamit(base, length_m=60.0), hull)
    (tmp_path / "box.gdf").write_text("a header\n60.0 9.81 ULEN GRAV\n")
    agrees(wamit(base), hull)
    with pytest.raises(HydrodynamicsError, match="box.gdf:2: length_m is given as 1,"):
        wamit(base, length_m=1.0)


def test_the_listing_of_the_run_is_taken_and_held_against_what_is_given(shallow: Hull, tmp_path: Path) -> None:
    base = shallow.wamit(tmp_path / "box")
    waves = "\n".join(
        f" Wave period (sec) = {2 * math.pi / w:.6E}        Wavenumber (kL) = {k:.6E}" for w, k in zip(shallow.omegas, shallow.k, strict=True)
    )
    (tmp_path / "box.out").write_text(
        " Gravity:     9.81000                Length scale:        1.00000\n"
        " Water depth:        10.00000        Water density:     1025.00000\n"
        f" Volumes (VOLX,VOLY,VOLZ):           {MASS / 1025:.1f}      {MASS / 1025:.1f}      {MASS / 1025:.1f}\n"
        " Center of Buoyancy (Xb,Yb,Zb):     0.0     0.0   -2.0\n"
        " Center of Gravity  (Xg,Yg,Zg):     0.000000     0.000000     0.000000\n" + waves + "\n"
    )
    data = quiet(lambda: hydrodynamics.from_wamit(base, gyradii_m=GYRADII))
    assert data.depth_m == 10.0 and data.mass_kg == pytest.approx(MASS, rel=1e-4)
    agrees(data, shallow)
    with pytest.raises(HydrodynamicsError, match="box.out:2: depth_m is given as 30, but the depth of the run is 10"):
        wamit(base, depth_m=30.0)
    with pytest.raises(HydrodynamicsError, match="a hull of another size"):
        wamit(base, mass_kg=0.9 * MASS)
    with pytest.raises(HydrodynamicsError, match="the values are the periods of box.out"):
        wamit(base, first_column="frequency")
    higher = quiet(lambda: hydrodynamics.from_wamit(base, gyradii_m=GYRADII, gravity_above_water_m=1.0))
    assert len(notes_of(higher, "Changed: restoring of roll and pitch")) == 1
    assert data.restoring[1][1] - higher.restoring[1][1] == pytest.approx(data.mass_kg * 9.81)


def test_without_infinite_frequency_it_follows_from_the_damping_with_its_error(hull: Hull, tmp_path: Path) -> None:
    data = wamit(hull.wamit(tmp_path / "box", infinite=False))
    (note,) = data.notes
    assert note.startswith("Filled: added mass at infinite frequency") and data.problems == []
    said = {name: float(share) for name, share in re.findall(r"(\w+) ([\d.]+) %", note)}
    for k, name in enumerate(("surge", "sway", "heave", "roll", "pitch", "yaw")):
        largest = max(abs(matrix[k][k]) for matrix in data.added_mass.values())
        off = abs(data.added_mass[math.inf][k][k] - INFINITE[k]) / largest
        assert off < 0.03 and off < 0.02 + 0.01 * 2 * said[name], name
    assert f"# {note}" in data.text()


def test_rows_that_are_not_numbers_are_dropped_and_said(hull: Hull, tmp_path: Path) -> None:
    base = hull.wamit(tmp_path / "box")
    lines = Path(f"{base}.1").read_text().splitlines()
    at = [k for k, line in enumerate(lines) if line.split()[1:3] == ["3", "3"]][1:3]
    lines[at[0]] = re.sub(r"\S+$", "NaN", lines[at[0]])
    lines[at[1]] = re.sub(r"\S+$", "*************", lines[at[1]])
    Path(f"{base}.1").write_text("\n".join(lines))
    data = wamit(base)
    assert data.notes == ["Dropped: 0.15, 0.2 rad/s: values of damping are not numbers there (the panel code found no solution)."]
    assert min(data.damping) == pytest.approx(0.25) and "nan" not in data.text()
    # Couplings are there.
    agrees(data, hull)


def test_a_single_irregular_frequency_is_repaired_and_named(tmp_path: Path) -> None:
    good, bad = Hull(), Hull()
    row = int(np.argmin(np.abs(bad.omegas - 1.2)))
    bad.damping[row, 2, 2] *= -0.4
    bad.added[row, 2, 2] *= 1.3
    bad.force[row, :, 2] *= 0.3
    data = wamit(bad.wamit(tmp_path / "box"))
    (note,) = data.notes
    assert note.startswith("Repaired: 1.2 rad/s, added mass and damping and exciting forces of heave, by the curve through the neighbours: ")
    assert f"# {note}" in data.text() and data.problems == []
    omega = min(data.damping, key=lambda w: abs(w - 1.2))
    assert data.damping[omega][2][2] == pytest.approx(good.damping[row, 2, 2], abs=0.01 * good.damping[:, 2, 2].max())
    assert data.added_mass[omega][2][2] == pytest.approx(good.added[row, 2, 2], abs=0.02 * good.added[:, 2, 2].max())
    own = wamit(bad.wamit(tmp_path / "box"), repair_radps=())
    assert notes_of(own, "Repaired") == [] and own.problems
    asked = wamit(good.wamit(tmp_path / "box"), repair_radps=[1.2, 7.0])
    assert [note[:12] for note in asked.notes] == ["Not repaired", "Repaired: 1."]


def test_without_headings_a_leap_is_seen_in_the_curve(tmp_path: Path) -> None:
    bad = Hull(headings=np.array([0.0, 90.0, 180.0]))
    row = int(np.argmin(np.abs(bad.omegas - 0.7)))
    bad.added[row, 4, 4] *= 1.6
    data = wamit(bad.wamit(tmp_path / "box"), first_column="period")
    (note,) = notes_of(data, "Repaired")
    assert note.startswith("Repaired: 0.7 rad/s") and "pitch leaps out of the curve" in note


def test_negative_damping_above_all_waves_that_matter_is_cut_with_the_reason(hull: Hull, tmp_path: Path) -> None:
    bad = Hull()
    for row in np.flatnonzero(bad.omegas > 3.05):
        bad.damping[row, 1, 1] = -0.026 * bad.damping[:, 1, 1].max()
    data = wamit(bad.wamit(tmp_path / "box"))
    (note,) = data.notes
    assert note.startswith("Cut: added mass and damping, and exciting forces above 3 rad/s (3.1, 3.2, 3.3, 3.4, 3.5, 3.6 rad/s): from 3.1 rad/s on ")
    assert "sway" in note and data.problems == []
    assert max(w for w in data.damping) == pytest.approx(3.0) and max(w for w, _ in data.excitation) == pytest.approx(3.0)
    agrees(data, hull)


def test_the_range_to_use_can_be_chosen(hull: Hull, tmp_path: Path) -> None:
    data = wamit(hull.wamit(tmp_path / "box"), lowest_radps=0.24, highest_radps=3.25)
    assert [min(data.damping), max(data.damping)] == [pytest.approx(0.25), pytest.approx(3.2)]
    assert len(notes_of(data, "Cut: added mass and damping, and exciting forces")) == 2
    assert all("given as 0.24 to 3.25 rad/s" in note for note in data.notes)
    short = wamit(tmp_path / "box", highest_radps=0.75)
    assert "run higher ones" in short.problems[0]
    with pytest.raises(HydrodynamicsError, match="no file can be made of these data: .*run higher ones"):
        short.write(tmp_path / "box.hydro")
    assert not (tmp_path / "box.hydro").exists()
    assert wamit(tmp_path / "box", lowest_radps=50.0).problems[0] == "no frequency is left in the range to use"


def test_a_file_in_which_nothing_is_sound_is_refused_with_the_reason(tmp_path: Path) -> None:
    bad = Hull()
    bad.damping[::3, 2, 2] *= -1.0
    data = wamit(bad.wamit(tmp_path / "box"))
    assert data.problems and "negative" in data.problems[0]


@pytest.mark.parametrize("code", ["wamit", "nemoh", "aqwa"])
def test_of_two_bodies_one_is_chosen_and_the_other_is_said_to_be_left_out(hull: Hull, tmp_path: Path, code: str) -> None:
    def make(**also: Any) -> hydrodynamics.Hydrodynamics:
        if code == "wamit":
            return wamit(hull.wamit(tmp_path / "two", bodies=2), **also)
        if code == "nemoh":
            folder = tmp_path / f"case{len(list(tmp_path.iterdir()))}"
            return quiet(lambda: hydrodynamics.from_nemoh(hull.nemoh(folder, bodies=2), gyradii_m=GYRADII, **also))
        return quiet(lambda: hydrodynamics.from_aqwa(hull.ah1(tmp_path / "two.AH1", bodies=2), **also))

    with pytest.raises(HydrodynamicsError, match="2 (bodies|structures)"):
        make()
    with pytest.raises(HydrodynamicsError, match="there is no body 3"):
        make(body=3)
    for body in (1, 2, "ship") if code == "nemoh" else (1, 2):
        data = make(body=body)
        assert len(notes_of(data, "Left out: ")) == 1 and "coupling" in notes_of(data, "Left out: ")[0]
        agrees(data, hull)


def test_a_body_at_another_place_has_its_own_phases(hull: Hull, tmp_path: Path) -> None:
    away = Hull()
    beta = np.radians(HEADINGS)
    along = 50.0 * np.cos(beta) + 20.0 * np.sin(beta)
    away.force = away.force * np.exp(-1j * hull.k[:, None] * along[None, :])[:, :, None]
    data = wamit(away.wamit(tmp_path / "box"), body_at_m=(50.0, 20.0, 0.0))
    assert data.notes[0].startswith("Moved: phases are counted from the body's origin, 50 m along x and 20 m along y")
    agrees(data, hull)


def test_nemoh_is_read_with_its_case_and_mesh(shallow: Hull, tmp_path: Path) -> None:
    data = quiet(lambda: hydrodynamics.from_nemoh(shallow.nemoh(tmp_path / "case"), gyradii_m=GYRADII))
    assert data.depth_m == 10.0 and data.mass_kg == pytest.approx(MASS) and data.gravity_above_water_m == 1.5
    assert [note[:37] for note in data.notes] == ["Filled: added mass at infinite freque"]
    agrees(data, shallow)
    with pytest.raises(HydrodynamicsError, match="depth_m is given as 20, but the run has 10"):
        hydrodynamics.from_nemoh(tmp_path / "case", gyradii_m=GYRADII, depth_m=20.0)
    table = tmp_path / "case" / "Results" / "RadiationCoefficients.tec"
    lines = table.read_text().splitlines()
    table.write_text("\n".join(lines[:20] + ["what"] + lines[21:]))
    with pytest.raises(HydrodynamicsError, match=r"RadiationCoefficients.tec:21: a row must be numbers"):
        hydrodynamics.from_nemoh(tmp_path / "case", gyradii_m=GYRADII)


@pytest.mark.parametrize(("unit", "value"), [("Hz", lambda w: w / (2 * math.pi)), ("s", lambda w: 2 * math.pi / w)])
def test_nemoh_with_other_frequencies_than_radians(hull: Hull, tmp_path: Path, unit: str, value: Callable[[float], float]) -> None:
    folder = hull.nemoh(tmp_path / "case")
    for name in ("RadiationCoefficients.tec", "ExcitationForce.tec"):
        path = folder / "Results" / name
        lines = path.read_text().replace('"w (rad/s)"', f'"f ({unit})"').splitlines()
        for k, line in enumerate(lines):
            if re.match(r"[0-9]", line):
                first, rest = line.split(" ", 1)
                lines[k] = f"{value(float(first)):.9E} {rest}"
        path.write_text("\n".join(lines))
    agrees(quiet(lambda: hydrodynamics.from_nemoh(folder, gyradii_m=GYRADII)), hull)


def test_aqwa_is_read_from_both_text_forms(shallow: Hull, tmp_path: Path) -> None:
    data = quiet(lambda: hydrodynamics.from_aqwa(shallow.ah1(tmp_path / "box.AH1")))
    assert data.notes == [] and data.gravity_above_water_m == 1.5
    agrees(data, shallow)
    listing = quiet(lambda: hydrodynamics.from_aqwa(shallow.lis(tmp_path / "box.LIS")))
    assert [note.split(":")[0] for note in listing.notes] == ["Left out", "Filled"]
    assert listing.mass_kg == pytest.approx(MASS, rel=1e-4) and listing.gyradii_m == pytest.approx(GYRADII, rel=1e-3)
    agrees(listing, shallow, within=1e-2)


def test_hams_says_what_its_first_column_is(shallow: Hull, tmp_path: Path) -> None:
    shallow.wamit(tmp_path / "Output" / "Wamit_format" / "Buoy", column="wave number")
    (tmp_path / "Input").mkdir()
    control = tmp_path / "Input" / "ControlFile.in"
    text = "Waterdepth 10.D0\nOutput_frequency_type 2\nReference_body_center 0.000 0.000 0.000\nReference_body_length 1.D0\n"
    control.write_text(text + "Output_frequency_type options: same as Input_frequency_type options\n")
    rows = "\n".join(" ".join(f"{MASS * x:.5E}" for x in row) for row in np.diag([1.0, 1.0, 1.0, *(r * r for r in GYRADII)]))
    (tmp_path / "Input" / "Hydrostatic.in").write_text(f" Center of Gravity:\n 0.0 0.0 0.0\n Body Mass Matrix:\n{rows}\n")
    data = quiet(lambda: hydrodynamics.from_hams(tmp_path, gravity_mps2=made_up.GRAVITY))
    assert data.notes == ["The first column of Buoy.1 is the wave number: ControlFile.in says so."]
    assert data.gyradii_m == pytest.approx(GYRADII, rel=1e-4)
    agrees(data, shallow)
    control.write_text(text.replace("type 2", "type 4"))
    with pytest.raises(HydrodynamicsError, match=r"taken for the period \(ControlFile.in says so\)"):
        hydrodynamics.from_hams(tmp_path, gravity_mps2=made_up.GRAVITY)


def dataset(hull: Hull, infinite: bool = True, bodies: tuple[str, ...] = ("",)) -> Any:
    """As Capytaine writes it: e^(-i omega t)."""
    xarray = pytest.importorskip("xarray")
    names = [prefix + dof for prefix in bodies for dof in ("Surge", "Sway", "Heave", "Roll", "Pitch", "Yaw")]
    count = len(bodies)

    def spread(values: Any) -> Any:
        return np.stack([np.kron(np.eye(count), matrix) for matrix in values])

    omegas = [*hull.omegas, math.inf] if infinite else list(hull.omegas)
    added, damping = list(hull.added), list(hull.damping)
    force = np.concatenate([np.conj(hull.force)] * count, axis=2)
    if infinite:
        added, damping = [*added, np.diag(INFINITE)], [*damping, np.full((6, 6), np.nan)]
        force = np.concatenate([force, np.full((1, *force.shape[1:]), np.nan)])
    dims = ("omega", "influenced_dof", "radiating_dof")
    still = ("influenced_dof", "radiating_dof")
    mass = np.diag([MASS] * 3 + [MASS * r * r for r in GYRADII])
    return xarray.Dataset(
        {
            "added_mass": (dims, spread(added)),
            "radiation_damping": (dims, spread(damping)),
            "excitation_force": (("omega", "wave_direction", "influenced_dof"), force),
            "hydrostatic_stiffness": (still, np.kron(np.eye(count), RESTORING)),
            "inertia_matrix": (still, np.kron(np.eye(count), mass)),
        },
        coords={
            "omega": omegas, "influenced_dof": names, "radiating_dof": names, "wave_direction": np.radians(hull.headings),
            "water_depth": hull.depth, "rho": made_up.WATER, "g": made_up.GRAVITY,
        },
    )  # fmt: skip


def test_capytaine_without_infinite_frequency_and_with_nan_rows(hull: Hull) -> None:
    data = quiet(lambda: hydrodynamics.from_capytaine(dataset(hull), gravity_above_water_m=0.0))
    assert data.notes == [] and data.gyradii_m == pytest.approx(GYRADII)
    agrees(data, hull)
    without = dataset(hull, infinite=False)
    without["added_mass"].values[:2] = np.nan
    data = quiet(lambda: hydrodynamics.from_capytaine(without, gravity_above_water_m=0.0))
    assert [note[:36] for note in data.notes] == ["Dropped: 0.15, 0.2 rad/s: values of ", "Filled: added mass at infinite frequ"]
    agrees(data, hull)


def test_capytaine_with_two_bodies(hull: Hull) -> None:
    two = dataset(hull, bodies=("tug__", "ship__"))
    with pytest.raises(HydrodynamicsError, match=r"the dataset has 2 bodies: 1 \(tug\), 2 \(ship\); say which"):
        hydrodynamics.from_capytaine(two, gravity_above_water_m=0.0)
    data = quiet(lambda: hydrodynamics.from_capytaine(two, gravity_above_water_m=0.0, body="ship"))
    assert data.notes[0].startswith("Left out: body tug, and the coupling of body ship to it")
    agrees(data, hull)
    bare = two.drop_vars("added_mass")
    with pytest.raises(HydrodynamicsError, match="the dataset has no `added_mass`"):
        hydrodynamics.from_capytaine(bare, gravity_above_water_m=0.0)


def test_headings_of_a_hull_that_is_alike_fore_and_aft_are_filled(tmp_path: Path) -> None:
    half = Hull(headings=np.arange(0.0, 91.0, 15.0))
    data = wamit(half.wamit(tmp_path / "box"), first_column="period", symmetry="fore and aft")
    assert notes_of(data, "Filled: headings beyond abeam") and data.problems == []
    agrees(data, Hull())
    with pytest.raises(HydrodynamicsError, match="symmetry is 'round', but must be None or one of"):
        wamit(tmp_path / "box", first_column="period", symmetry="round")
    with pytest.raises(HydrodynamicsError, match="given as revolution, but the added mass of surge and sway differ"):
        wamit(tmp_path / "box", first_column="period", symmetry="revolution")


@pytest.mark.parametrize(
    ("end", "change", "said"),
    [
        (".1", lambda lines: [*lines[:9], "what is this", *lines[10:]], ":10: a row must have 4 or 5 numbers, but has text"),
        (".1", lambda lines: [*lines[:9], lines[9] + " 1.0", *lines[10:]], ":10: a row must have 4 or 5 numbers, but has 6"),
        (".1", lambda lines: [*lines[:9], lines[9].replace(" 4 4 ", " 4.5 4 "), *lines[10:]], ":10: a motion must be a whole number from 1 to 594, but is 4.5"),
        (".3", lambda lines: [], ".3: the file has no row of numbers"),
        (".3", lambda lines: [" 1.0 0.0 9 1 0 1 0", *lines], ":1: a motion must be a whole number from 1 to 6, but is 9"),
        (".hst", lambda lines: ["3 3"], ":1: a row must have 3 numbers, but has 2"),
    ],
)  # fmt: skip
def test_a_damaged_file_is_named_with_its_line(
    hull: Hull, tmp_path: Path, end: str, change: Callable[[list[str]], list[str]], said: str
) -> None:
    base = hull.wamit(tmp_path / "box")
    path = Path(f"{base}{end}")
    path.write_text("\n".join(change(path.read_text().splitlines())))
    with pytest.raises(HydrodynamicsError) as caught:
        wamit(base)
    assert said in str(caught.value) and caught.value.file == str(path)


@pytest.mark.parametrize("share", [0.02, 0.3, 0.6, 0.97])
def test_files_that_end_anywhere_give_our_errors(hull: Hull, tmp_path: Path, share: float) -> None:
    made: list[tuple[Path, Callable[[], hydrodynamics.Hydrodynamics]]] = [
        (hull.wamit(tmp_path / "a" / "box").with_name("box.1"), lambda: hydrodynamics.from_wamit(tmp_path / "a" / "box", mass_kg=MASS, gravity_above_water_m=0.0, gyradii_m=GYRADII)),
        (hull.nemoh(tmp_path / "b") / "Results" / "ExcitationForce.tec", lambda: hydrodynamics.from_nemoh(tmp_path / "b", gyradii_m=GYRADII)),
        (hull.ah1(tmp_path / "c.AH1"), lambda: hydrodynamics.from_aqwa(tmp_path / "c.AH1")),
        (hull.lis(tmp_path / "d.LIS"), lambda: hydrodynamics.from_aqwa(tmp_path / "d.LIS")),
    ]  # fmt: skip
    for path, make in made:
        text = path.read_text()
        path.write_text(text[: int(share * len(text))])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            # Data that end early are an error, or are refused for what they lack, or lack nothing that counts.
            try:
                data = make()
            except HydrodynamicsError:
                continue
            assert data.problems or data.notes or len(data.damping) > 8


def test_missing_files_are_our_errors(tmp_path: Path) -> None:
    makers: list[Callable[[], hydrodynamics.Hydrodynamics]] = [
        lambda: hydrodynamics.from_wamit(tmp_path / "no", gyradii_m=GYRADII),
        lambda: hydrodynamics.from_nemoh(tmp_path / "no", gyradii_m=GYRADII),
        lambda: hydrodynamics.from_nemoh(tmp_path, gyradii_m=GYRADII),
        lambda: hydrodynamics.from_hams(tmp_path / "no"),
        lambda: hydrodynamics.from_aqwa(tmp_path / "no.AH1"),
        lambda: hydrodynamics.from_capytaine(tmp_path / "no.nc", gravity_above_water_m=0.0),
    ]
    for make in makers:
        with pytest.raises(HydrodynamicsError, match="there (is|must be)|neither"):
            make()


def test_the_picture_is_an_svg_with_what_was_cut(hull: Hull, tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    bad = Hull()
    bad.damping[-4:, 1, 1] = -0.03 * bad.damping[:, 1, 1].max()
    row = int(np.argmin(np.abs(bad.omegas - 1.2)))
    bad.damping[row, 2, 2] *= -0.4
    data = wamit(bad.wamit(tmp_path / "box"))
    figure = data.picture(tmp_path / "box.svg")
    text = (tmp_path / "box.svg").read_text()
    assert text.lstrip().startswith("<?xml") and "<svg" in text
    assert "grey: cut; yellow: repaired" in figure.get_suptitle()
    assert len(figure.axes) == 18
    # A notebook shows what the call gives back.
    assert hasattr(figure, "_repr_svg_")
    # Masses are in tonnes, as naval architects have them.
    titles = [ax.get_title(loc="left") for ax in figure.axes]
    assert "heave: added mass [kt]" in titles and not any("kkg" in title or "Mkg" in title for title in titles)
    assert "3,936 t" in figure.get_suptitle()
    data.mass_kg = 26.8
    assert ": 26.8 kg, deep water" in data.picture().get_suptitle()
    with pytest.raises(HydrodynamicsError, match="the picture cannot be written"):
        data.picture(tmp_path / "box.nothing")


def panel_of(data: hydrodynamics.Hydrodynamics, depth_m: float) -> Any:
    """The data of a file as those of a panel code, at a depth."""
    from fenderline.hydrodynamics._panel import Panel

    omegas = sorted(data.damping)
    waves, headings = (sorted({key[k] for key in data.excitation}) for k in (0, 1))
    own = Panel(
        source="", file="", omega=np.array(omegas), added=np.array([data.added_mass[w] for w in omegas]),
        damping=np.array([data.damping[w] for w in omegas]), infinite=np.array(data.added_mass[math.inf]), wave_omega=np.array(waves),
        headings_deg=np.array(headings), force=np.array([[data.excitation[w, h] for h in headings] for w in waves]),
        depth_m=depth_m, gravity_mps2=9.81, water_kgpm3=data.water_kgpm3,
    )  # fmt: skip
    own.mass = np.array([data.mass_kg] * 3 + [data.mass_kg * k * k for k in data.gyradii_m])
    own.stiff = np.array([0.0, 0.0, *np.diag(data.restoring), 0.0])
    return own


def test_the_files_of_the_repository_agree_with_their_depth_and_are_left_as_they_are(root: Path) -> None:
    from fenderline.hydrodynamics import _check, _sound

    files = sorted((root / "hydrodynamics").glob("*.hydro"))
    if not files:
        pytest.skip("the tests run without the repository")
    for path in files:
        data = hydrodynamics.read(path)
        panel = panel_of(data, data.depth_m)
        off = _check.contradiction(panel)
        if "quay" in path.name:
            assert off is None or _check.is_at_wall(off), path.name
        else:
            assert off is not None and off[0] < math.log(1.03), path.name
            twice = _check.contradiction(panel_of(data, 2.0 * data.depth_m))
            # The median over the frequencies. It is less the more short waves the data have, which feel no bottom.
            assert twice is not None and math.log(1.25) < twice[0] < math.log(1.5), path.name
        _, cut = _sound.looked_through(panel, None, None, None)
        assert cut == [], path.name
        # Data that reach to short waves, which the panels do not resolve, have a doubt there. What would be repaired was repaired when the file was
        # made, as its head says.
        head = path.read_text(encoding="utf-8")
        assert all(note in head for note in panel.notes if not note.startswith("Doubt")), path.name


def test_a_file_is_read_back(hull: Hull, tmp_path: Path) -> None:
    data = wamit(hull.wamit(tmp_path / "box"))
    data.write(tmp_path / "box.hydro")
    again = hydrodynamics.read(tmp_path / "box.hydro")
    agrees(again, hull, within=5e-3)
    assert again.source == "WAMIT, box"
    text = (tmp_path / "box.hydro").read_text()
    (tmp_path / "bad.hydro").write_text(text.replace("= infinite", "= nothing"))
    with pytest.raises(HydrodynamicsError, match="the table `= infinite` is missing"):
        hydrodynamics.read(tmp_path / "bad.hydro")


def test_the_simulation_reads_what_was_repaired(hull: Hull, tmp_path: Path) -> None:
    from fenderline import Scenario

    bad = Hull()
    bad.damping[-4:, 1, 1] = -0.03 * bad.damping[:, 1, 1].max()
    row = int(np.argmin(np.abs(bad.omegas - 1.2)))
    bad.damping[row, 2, 2] *= -0.4
    data = wamit(bad.wamit(tmp_path / "box", infinite=False))
    data.write(tmp_path / "box.hydro")
    (tmp_path / "box.toml").write_text(SCENARIO)
    scenario = Scenario.load(str(tmp_path / "box.toml"))
    assert [notice for notice in scenario.notices if "box.hydro" in str(notice)] == []


def test_a_hull_that_the_simulation_would_refuse_is_a_problem_of_the_file(tmp_path: Path) -> None:
    """As the spar of a two-body wave energy converter: a small waterline over a deep hull, and an added mass of nearly nothing."""
    hull = Hull()
    restoring = [list(row) for row in RESTORING[2:5, 2:5]]
    restoring[0][0] = 1e5
    # Exciting forces of long waves are those of the restoring.
    hull.force[:, :, 2] *= 1e5 / RESTORING[2, 2]
    hull.damping[:, 2, 2] *= (1e5 / RESTORING[2, 2]) ** 2
    data = wamit(hull.wamit(tmp_path / "spar"), restoring=restoring)
    assert any("the restoring of heave is 1e+05 N/m, but of the hulls of this displacement" in problem for problem in data.problems)
    infinite = np.diag(INFINITE)
    infinite[0, 0] = 6.0 * MASS
    data = wamit(Hull().wamit(tmp_path / "box"), infinite=infinite.tolist())
    assert "the added mass of surge at infinite frequency is 6 of the mass, but must be 0 to 5" in data.problems


def test_a_coupling_that_is_not_mutual_is_said() -> None:
    """As in the WAMIT files of a public two-body example, where the motion in pitch differs by 4 % for it."""
    odd = Hull()
    root = np.sqrt(odd.added[:, 0, 0].max() * odd.added[:, 4, 4].max())
    odd.added[:, 0, 4] -= 0.2 * root
    odd.added[:, 4, 0] -= 0.04 * root
    data = quiet(lambda: hydrodynamics.from_capytaine(dataset(odd), gravity_above_water_m=0.0))
    assert any(note.startswith("Doubt: added mass of surge by pitch and of pitch by surge must be the same") for note in data.notes)


def test_a_square_box_is_no_body_of_revolution(tmp_path: Path) -> None:
    """Surge is as sway and roll as pitch, but a box with corners moves water as she yaws."""
    square = Hull()
    # Long waves carry her with her added mass.
    square.force[:, :, 0] *= ((MASS + square.added[:, 1, 1]) / (MASS + square.added[:, 0, 0]))[:, None]
    for matrices in (square.added, square.damping):
        for one, two in ((0, 1), (3, 4)):
            matrices[:, one, one] = matrices[:, two, two]
    with pytest.raises(HydrodynamicsError, match="given as revolution, but she moves water as she yaws"):
        wamit(square.wamit(tmp_path / "square"), first_column="period", symmetry="revolution")


@pytest.mark.parametrize("trait", ["sound", "two bodies", "rows that are not numbers", "an irregular frequency"])
def test_the_simulated_ship_moves_in_regular_waves_as_the_panel_code_says(hull: Hull, tmp_path: Path, trait: str) -> None:
    """Within 2 % in heave and pitch, where they are above 2 % of the wave's amplitude and slope."""
    import fenderline

    if trait == "two bodies":
        data = quiet(lambda: hydrodynamics.from_capytaine(dataset(hull, bodies=("tug__", "ship__")), gravity_above_water_m=0.0, body="ship"))
    elif trait == "rows that are not numbers":
        bad = dataset(hull, infinite=False)
        bad["added_mass"].values[:2] = np.nan
        data = quiet(lambda: hydrodynamics.from_capytaine(bad, gravity_above_water_m=0.0))
    else:
        own = Hull()
        if trait == "an irregular frequency":
            own.damping[int(np.argmin(np.abs(own.omegas - 1.2))), 2, 2] *= -0.4
        data = wamit(own.wamit(tmp_path / "own"))
    data.write(tmp_path / "box.hydro")
    for omega, heading in ((0.5, 0.0), (0.9, 60.0), (1.2, 180.0)):
        row, column = int(np.argmin(np.abs(hull.omegas - omega))), int(np.argmin(np.abs(hull.headings - heading)))
        expected = np.abs(hull.motion(row, column))
        # Small waves, in which she keeps her heading though nothing holds her.
        period, amplitude = 2.0 * math.pi / omega, 1e-4
        (tmp_path / "waves.toml").write_text(
            SCENARIO.replace('step = "0.2 s"', f"step = {period / 60:.9g}")
            .replace('duration = "1 min"', f"duration = {60 * period:.9g}")
            .replace(
                'depth = "300 m"',
                f'depth = "300 m"\nwaves = {{ height = {2 * amplitude}, period = {period:.9g}, from = "{180 - heading:g} deg", regular = true }}',
            )
        )
        rows = fenderline.run(str(tmp_path / "waves.toml"))["vessels"]
        t = np.asarray(rows["t_s"])
        late = t > 20 * period
        weight = np.sin(math.pi * (t[late] - t[late][0]) / (t[late][-1] - t[late][0])) ** 4
        for name, k, scale in (("heave_m", 2, 1.0), ("pitch_rad", 4, omega**2 / made_up.GRAVITY)):
            found = 2.0 * abs(np.sum(weight * np.asarray(rows[name])[late] * np.exp(-1j * omega * t[late]))) / weight.sum() / amplitude
            if expected[k] > 0.02 * scale:
                assert found == pytest.approx(expected[k], rel=0.02), (name, omega, heading)


SCENARIO = """
[time]
step = "0.2 s"
duration = "1 min"

[environment]
depth = "300 m"

[vessel.box]
length_bp = "60 m"
beam = "16 m"
draught = "4 m"
block_coefficient = 1.0
gyradius = "16 m"
hydrodynamics = "box.hydro"

[body.ship]
vessel = "box"
outline = [[-30, -8], [30, -8], [30, 8], [-30, 8]]
"""
