"""Results in Arrow, Parquet and pandas."""

from pathlib import Path

import fenderline
import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest


@pytest.fixture(scope="module")
def results() -> fenderline.Results:
    return fenderline.run(fenderline.example("tug_4kn"))


def test_columns_are_read_only_and_have_units(results: fenderline.Results) -> None:
    contacts = results["contacts"]
    assert contacts.columns["depth_m"].unit == "m"
    assert contacts["depth_m"] is contacts["depth_m"]
    with pytest.raises(ValueError, match="read-only"):
        contacts["depth_m"][0] = 0.0
    assert set(contacts["body_1"].tolist()) == {"ship"}


def test_arrow(results: fenderline.Results) -> None:
    for table in results.values():
        arrow = table.to_arrow()
        assert arrow.num_rows == table.rows
        assert arrow.column_names == list(table)
        through = pa.table(table)
        assert through.equals(arrow)
        assert arrow.schema.field("t_s").metadata[b"unit"] == b"s"


def test_parquet(results: fenderline.Results, tmp_path: Path) -> None:
    for path, table in zip(results.to_parquet(tmp_path / "out"), results.values(), strict=True):
        read = pq.read_table(path)
        for name in table:
            assert read[name].to_pylist() == table[name].tolist()


def test_pandas(results: fenderline.Results) -> None:
    frame = results["bodies"].to_pandas()
    assert frame.attrs["units"]["u_mps"] == "m/s"
    tug = frame[frame["body"] == "tug"]
    assert len(tug) == 200
    assert np.array_equal(frame["x_m"].to_numpy(), results["bodies"]["x_m"])


def test_pandas_and_numpy_of_a_whole_table(results: fenderline.Results) -> None:
    import pandas as pd

    for convert in (pd.DataFrame, np.asarray):
        with pytest.raises(TypeError, match=r"bodies\.to_pandas\(\)"):
            convert(results["bodies"])
        with pytest.raises(TypeError, match="several tables"):
            convert(results)
    array = results["bodies"].to_numpy()
    assert array.dtype.names == tuple(results["bodies"])
    assert (array["x_m"] == results["bodies"]["x_m"]).all()


def test_xarray(results: fenderline.Results) -> None:
    pytest.importorskip("xarray", reason="xarray is not installed")
    data = results["bodies"].to_xarray()
    assert dict(data.sizes) == {"t_s": 200, "body": 2}
    tug = results["bodies"]["body"] == "tug"
    assert (data["x_m"].sel(body="tug").values == results["bodies"]["x_m"][tug]).all()
    assert data["u_mps"].attrs["units"] == "m/s"
    assert dict(results["energy"].to_xarray().sizes) == {"t_s": 201}
    patches = fenderline.run_many(fenderline.example("tug_4kn"), [{}, {}]).pairs
    assert dict(patches.to_xarray().sizes) == {"run": 2}


def test_names_that_do_not_exist(results: fenderline.Results) -> None:
    with pytest.raises(KeyError, match="no table 'bodys': did you mean 'bodies'") as raised:
        results["bodys"]
    assert str(raised.value).startswith("there is no table")
    with pytest.raises(KeyError, match=r"no column of bodies 'u'; there are: t_s, body"):
        results["bodies"]["u"]
    with pytest.raises(AttributeError, match="no table 'fender'"):
        results.fender  # noqa: B018
    with pytest.raises(ValueError, match=r"no example 'tug': .*There are: docking, tug_4kn"):
        fenderline.example("tug")


def test_completion_in_notebooks(results: fenderline.Results) -> None:
    assert results._ipython_key_completions_() == list(results)
    assert results["bodies"]._ipython_key_completions_()[0] == "t_s"
    assert {"bodies", "to_parquet"} <= set(dir(results))
    assert results.bodies is results["bodies"]


def test_what_notebooks_show(results: fenderline.Results) -> None:
    scenario = fenderline.example("tug_4kn").with_set({"title": "a < b"})
    simulation = fenderline.Simulation(scenario)
    for thing, text in [
        (results, "<td>contacts</td>"),
        (results["bodies"], "<th>u_mps [m/s]</th>"),
        (scenario, "a &lt; b"),
        (simulation, "<td>tug</td>"),
    ]:
        html = thing._repr_html_()  # type: ignore[attr-defined]
        assert text in html
        assert html.count("<table>") == html.count("</table>") == 1
    # Ten rows, the gap and the head.
    assert results["bodies"]._repr_html_().count("<tr>") == 12


def test_figures(results: fenderline.Results, scenarios: Path) -> None:
    matplotlib = pytest.importorskip("matplotlib", reason="Matplotlib is not installed")
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt

    from fenderline import plot

    axes = plot.contact_forces(results)
    (line,) = axes.get_lines()
    assert line.get_ydata().max() == pytest.approx(results["contacts"]["normal_force_n"].max() / 1e3)
    assert len(plot.tracks(results).get_lines()) == 2
    assert plot.states(results, "r_radps", names=["tug"]).get_ylabel().endswith("[rad/s]")
    with pytest.raises(ValueError, match="no body 'tag': did you mean 'tug'"):
        plot.states(results, names=["tag"])
    berth = fenderline.run(
        scenarios / "berth" / "eight_cones_at_5_deg.toml", {"time.duration": "40 s"}
    )
    assert plot.fenders(berth).get_ylabel() == "reaction [kN]"
    runs = fenderline.run_many(fenderline.example("tug_4kn"), {"time.step": [0.1, 0.2]})
    assert plot.runs(runs, "time.step").get_xlabel() == "time.step"
    with pytest.raises(ValueError, match="no column of the runs 'x'"):
        plot.runs(runs, "x")
    plt.close("all")
