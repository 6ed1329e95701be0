"""Importing the package is fast, and imports no optional library."""

import subprocess
import sys

IMPORT = """
import sys, time
began = time.process_time()
import numpy
of_numpy = time.process_time() - began
import fenderline
spent = time.process_time() - began
heavy = {"gymnasium", "matplotlib", "openturns", "pandas", "pettingzoo", "pyarrow", "scipy", "tqdm", "xarray"} & set(sys.modules)
print(spent, of_numpy, *heavy)
"""
# The most that the import of the package may take beside the import of NumPy, as a share of the latter. It took a tenth.
MOST_OF_NUMPY = 0.5


def test_import_takes_little_time_beside_that_of_numpy() -> None:
    times = []
    for _ in range(3):
        # Processor time: other work on the machine does not count.
        done = subprocess.run(
            [sys.executable, "-c", IMPORT], capture_output=True, text=True, check=True
        )
        spent, of_numpy, *heavy = done.stdout.split()
        assert heavy == []
        times.append((float(spent), float(of_numpy)))
    spent_s, of_numpy_s = min(times)
    print(f"import fenderline: {spent_s:.3f} s, of which NumPy {of_numpy_s:.3f} s")
    assert spent_s <= (1.0 + MOST_OF_NUMPY) * of_numpy_s
