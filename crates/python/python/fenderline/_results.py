"""The tables of a run."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from fenderline import _html
from fenderline._names import UnknownName, unknown

if TYPE_CHECKING:
    import pandas as _pandas
    import pyarrow as _pyarrow
    import xarray as _xarray


class Column:
    """A column of a :class:`Table`."""

    __slots__ = {
        "name": "Its name; it ends with the unit where there is one.",
        "unit": "``1`` for a pure number, ``-`` for a text or a truth value.",
        "meaning": "What it means.",
        "_codes": "Values, or in columns of texts their indices into the words.",
        "_words": "The texts, in columns of texts.",
    }

    name: str
    unit: str
    meaning: str

    def __init__(
        self,
        name: str,
        unit: str,
        meaning: str,
        codes: npt.NDArray[Any],
        words: Sequence[str] | None,
    ) -> None:
        self.name, self.unit, self.meaning = name, unit, meaning
        codes.flags.writeable = False
        self._codes = codes
        self._words = None if words is None else np.array(words, dtype=np.str_)

    @property
    def values(self) -> npt.NDArray[Any]:
        """The values. Numbers and truth values are read-only and not copied; texts are a new array."""
        return self._codes if self._words is None else self._words[self._codes]

    def __reduce__(self) -> tuple[Any, ...]:
        words = None if self._words is None else self._words.tolist()
        return Column, (self.name, self.unit, self.meaning, self._codes.copy(), words)

    def __deepcopy__(self, memo: object) -> Column:
        return self  # its arrays are read-only

    def __repr__(self) -> str:
        return f"<fenderline.Column {self.name} [{self.unit}]: {self.meaning}>"


class Table(Mapping[str, npt.NDArray[Any]]):
    """A table of results: NumPy columns by name, with units and meanings.

    >>> import fenderline
    >>> results = fenderline.run(fenderline.example("tug_4kn"))
    >>> bodies = results["bodies"]
    >>> bodies.rows, bodies.columns["u_mps"].unit
    (400, 'm/s')
    >>> bool(bodies["u_mps"][bodies["body"] == "tug"].min() < 0)  # she bounces off
    True
    """

    def __init__(
        self,
        name: str,
        columns: Sequence[tuple[str, str, str, npt.NDArray[Any], Sequence[str] | None]],
    ) -> None:
        self.name: str = name
        self.columns: dict[str, Column] = {column[0]: Column(*column) for column in columns}

    @property
    def rows(self) -> int:
        """Number of rows."""
        for column in self.columns.values():
            return len(column._codes)
        return 0

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        if name not in self.columns:
            raise UnknownName(unknown(f"column of {self.name}", name, self.columns))
        return self.columns[name].values

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __array__(self, dtype: object = None, copy: bool | None = None) -> npt.NDArray[Any]:
        raise TypeError(
            f"the columns of a table have different types: use {self.name}.to_pandas() for a data frame, "
            f"{self.name}.to_numpy() for a structured array, or one column, as {self.name}[{next(iter(self), '')!r}]"
        )

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)

    def _repr_html_(self) -> str:
        return _html.table(self)

    def to_numpy(self) -> npt.NDArray[np.void]:
        """As a structured array with one field for each column.

        >>> import fenderline
        >>> fenderline.run(fenderline.example("tug_4kn"))["bodies"].to_numpy()[["t_s", "body"]][0].item()
        (0.0, 'ship')
        """
        columns = {name: self[name] for name in self}
        fields = [(name, values.dtype) for name, values in columns.items()]
        array = np.empty(self.rows, dtype=fields)
        for name, values in columns.items():
            array[name] = values
        return array

    def to_xarray(self) -> _xarray.Dataset:
        """As a data set, units and meanings in ``attrs``; needs ``xarray``. Where each time has one row for each body (or fender,
        line, run, ...), its dimensions are these two, ``t_s`` or ``run`` first; else ``row``.
        """
        import xarray as xr

        axes = self._axes()
        shape = tuple(len(values) for values in axes.values())
        data: dict[str, Any] = {}
        order = self._order(axes)
        for name, column in self.columns.items():
            if name not in axes:
                attrs = {"units": column.unit, "long_name": column.meaning}
                data[name] = (tuple(axes), self[name][order].reshape(shape), attrs)
        coordinates: dict[str, Any] = {}
        for name, values in axes.items():
            if name in self.columns:
                column = self.columns[name]
                attrs = {"units": column.unit, "long_name": column.meaning}
                coordinates[name] = ((name,), values, attrs)
        return xr.Dataset(data, coordinates, {"title": self.name})

    def _axes(self) -> dict[str, npt.NDArray[Any]]:
        """The columns whose values together name each row once."""
        for first in ("t_s", "run"):
            if first not in self.columns:
                continue
            times = np.unique(self[first])
            if len(times) == self.rows:
                return {first: times}
            for name, column in self.columns.items():
                if column._words is None or not self.rows:
                    continue
                names = list(dict.fromkeys(self[name].tolist()))
                keys = set(zip(self[first].tolist(), self[name].tolist(), strict=True))
                if len(times) * len(names) == self.rows == len(keys):
                    return {first: times, name: np.array(names)}
        return {"row": np.arange(self.rows)}

    def _order(self, axes: Mapping[str, npt.NDArray[Any]]) -> npt.NDArray[np.intp]:
        """The order of the rows in which the last axis runs fastest."""
        keys = []
        for name, values in axes.items():
            if name in self.columns:
                numbers = {value: number for number, value in enumerate(values.tolist())}
                keys.append([numbers[value] for value in self[name].tolist()])
        return np.lexsort(keys[::-1]) if keys else np.arange(self.rows)

    def to_arrow(self) -> _pyarrow.Table:
        """As an Arrow table, with units and meanings in the fields' metadata; needs ``pyarrow``."""
        import pyarrow as pa

        arrays, fields = [], []
        for column in self.columns.values():
            if column._words is None:
                array = pa.array(column._codes)
            else:
                words = pa.array(column._words.tolist(), pa.string())
                array = pa.DictionaryArray.from_arrays(pa.array(column._codes), words)
            arrays.append(array)
            metadata = {"unit": column.unit, "meaning": column.meaning}
            fields.append(pa.field(column.name, array.type, nullable=False, metadata=metadata))
        return pa.Table.from_arrays(arrays, schema=pa.schema(fields))

    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
        """Arrow's stream interface, for polars, DuckDB, pandas and others; needs ``pyarrow``."""
        return self.to_arrow().__arrow_c_stream__(requested_schema)

    def to_pandas(self) -> _pandas.DataFrame:
        """As a data frame, texts as categories, units in ``attrs``; needs ``pandas``."""
        import pandas as pd

        def series(column: Column) -> Any:
            if column._words is None:
                return column._codes
            return pd.Categorical.from_codes(
                column._codes.tolist(), pd.Index(column._words.tolist(), dtype="str")
            )

        frame = pd.DataFrame({name: series(column) for name, column in self.columns.items()})
        frame.attrs["units"] = {name: column.unit for name, column in self.columns.items()}
        return frame

    def to_parquet(self, path: str | Path) -> None:
        """Writes a Parquet file; needs ``pyarrow``."""
        import pyarrow.parquet as pq

        pq.write_table(self.to_arrow(), path)

    def __repr__(self) -> str:
        return f"<fenderline.Table {self.name}: {self.rows} rows of {', '.join(self.columns)}>"


class Results(Mapping[str, Table]):
    """The tables of a run by name: those that ``fenderline run`` writes, with the same numbers. ``results.bodies`` is
    ``results["bodies"]``.
    """

    def __init__(self, title: str, tables: Sequence[Table]) -> None:
        self.title: str = title
        self._tables = {table.name: table for table in tables}

    def __getitem__(self, name: str) -> Table:
        if name not in self._tables:
            raise UnknownName(unknown("table", name, self._tables))
        return self._tables[name]

    def __getattr__(self, name: str) -> Table:
        # `_tables` itself is missing while an object is made from its pickle.
        tables: dict[str, Table] = {} if name.startswith("_") else self._tables
        if name not in tables:
            raise AttributeError(unknown("table", name, tables), name=name, obj=self)
        return tables[name]

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._tables]

    def _ipython_key_completions_(self) -> list[str]:
        return list(self)

    def _repr_html_(self) -> str:
        return _html.results(self)

    def __array__(self, dtype: object = None, copy: bool | None = None) -> npt.NDArray[Any]:
        raise TypeError(
            f"results are several tables: take one of {', '.join(self)}, as results['bodies'].to_pandas()"
        )

    def __iter__(self) -> Iterator[str]:
        return iter(self._tables)

    def __len__(self) -> int:
        return len(self._tables)

    def to_parquet(self, folder: str | Path) -> list[Path]:
        """Writes ``NAME.parquet`` for every table into a folder, which is created; needs ``pyarrow``."""
        folder = Path(folder)
        folder.mkdir(parents=True, exist_ok=True)
        paths = [folder / f"{name}.parquet" for name in self]
        for path, table in zip(paths, self.values(), strict=True):
            table.to_parquet(path)
        return paths

    def __repr__(self) -> str:
        return f'<fenderline.Results "{self.title}": {", ".join(self)}>'
