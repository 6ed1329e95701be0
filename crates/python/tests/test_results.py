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
