"""Shared by the tests with masters: the program, FMUs of scenarios, and direct runs to compare with."""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("FENDERLINE", str(ROOT / "target" / "release" / "fenderline"))
TUG = "scenarios/paper/experiment_2_4kn.toml"
BERTHING = "scenarios/berth/eight_cones_at_5_deg.toml"
MOORED = "scenarios/berth/leaning_on_eight_fenders.toml"


class Run:
    """The result files of `fenderline run`."""

    def __init__(self, folder):
        self.folder = folder
        self.summary = json.loads((folder / "summary.json").read_text())

    def table(self, name, key, of):
        """Rows of one body or fender, by the start of the step: {t_s: {column: value}}."""
        with open(self.folder / f"{name}.csv", newline="") as file:
            rows = [row for row in csv.DictReader(file) if row[key] == of]
        return {float(row["t_s"]): {c: float(v) for c, v in row.items() if c != key} for row in rows}


class Fenderline:
    def __init__(self, folder):
        self.folder = folder
        self.count = 0

    def call(self, *arguments):
        done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=ROOT, text=True, capture_output=True)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def run(self, scenario, *options):
        self.count += 1
        folder = self.folder / f"run_{self.count}"
        self.call("run", scenario, "--out", folder, *options)
        return Run(folder)

    def fmu(self, scenario, kind, fmi=2, *options, name=None):
        self.count += 1
        path = self.folder / f"{name or f'{kind}_{self.count}'}.fmu"
        self.call("fmu", scenario, "--kind", kind, "--fmi", fmi, "-o", path, *options)
        return path

    def ship(self):
        """The ship of ship.py as FMU."""
        from pythonfmu.builder import FmuBuilder

        path = self.folder / "Ship.fmu"
        if not path.exists():
            FmuBuilder.build_FMU(Path(__file__).with_name("ship.py"), dest=self.folder, needsExecutionTool="false")
        return path


@pytest.fixture
def fenderline(tmp_path):
    return Fenderline(tmp_path)
