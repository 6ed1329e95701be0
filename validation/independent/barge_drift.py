"""Mean drift of the box barge in a beam wave of 2 rad/s, by panels of half the size.

    python3 validation/independent/barge_drift.py

It needs what hydrodynamics/capytaine_hulls.py needs. It prints the drift in sway over the square of the amplitude (kN/m²) with the panels of the shipped
data and with panels of half their size, and that of total reflection over her length, ρgL/2. A wave of 15 m runs round the ends of a barge of 80 m, so
total reflection is an upper limit.
"""

import importlib.util
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
spec = importlib.util.spec_from_file_location("capytaine_hulls", ROOT / "hydrodynamics/capytaine_hulls.py")
hulls = importlib.util.module_from_spec(spec)
sys.modules["capytaine_hulls"] = hulls
spec.loader.exec_module(hulls)

for counts in ((24, 10, 6), (48, 18, 12)):
    hulls.CASES["finer"] = dict(hulls.CASES["barge_20m"], hull=lambda counts=counts: hulls.box(80.0, 20.0, 5.0, counts))
    data = hulls.solve("finer", [2.0, np.inf], [np.radians(270.0)])[0]
    sway_n = -float(np.ravel(data["drift_force_sway"].values)[0])
    print(f"{counts[0]} x {counts[1]} x {counts[2]} panels: {sway_n / 1e3:.1f} kN")
print(f"total reflection: {hulls.WATER_KGPM3 * hulls.GRAVITY_MPS2 * 80.0 / 2 / 1e3:.1f} kN")
