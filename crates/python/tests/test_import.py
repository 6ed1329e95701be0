"""Importing the package is fast, and imports no optional library."""

import subprocess
import sys

IMPORT = """
import sys, time
began = time.process_time()
import fenderline
spent = time.process_time() - began
heavy = {"gymnasium", "matplotlib", "openturns", "pandas", "pettingzoo", "pyarrow", "scipy", "tqdm", "xarray"} & set(sys.modules)
print(spent, *heavy)
"""


def test_import_takes_little_time() -> None:
    spent_s = []
    for _ in range(3):
        # Processor time: other work on the machine does not count. NumPy is most of it.
        done = subprocess.run(
            [sys.executable, "-c", IMPORT], capture_output=True, text=True, check=True
        )
        spent, *heavy = done.stdout.split()
        assert heavy == []
        spent_s.append(float(spent))
    print(f"import fenderline: {min(spent_s):.3f} s")
    assert min(spent_s) <= 0.3
