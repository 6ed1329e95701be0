#!/usr/bin/env python3
"""Fenders by finite elements: the whole analysis in one command.

    python3 validation/finite_elements/analyse.py              all studies, the comparison, tables and data files
    python3 validation/finite_elements/analyse.py --small      compares coarse meshes with the stored results, for CI
    python3 validation/finite_elements/analyse.py --compare    the comparison and the tables alone, from stored results

Packages come from PyPI in the versions of requirements.txt, into an environment under `target`.
"""

import argparse
import os
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def in_own_environment():
    """Restarts in its own environment, which is created if needed."""
    wanted = (HERE / "requirements.txt").read_text()
    folder = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "finite-elements"
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    if Path(sys.prefix).resolve() == folder.resolve():
        return
    stamp = folder / "installed.txt"
    if not stamp.exists() or stamp.read_text() != wanted:
        print(f"FElupe, numpy and scipy, from PyPI, into {folder}", flush=True)
        subprocess.run([sys.executable, "-m", "venv", "--clear", folder], check=True)
        install = [python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"]
        subprocess.run([*install, HERE / "requirements.txt"], check=True)
        stamp.write_text(wanted)
    # One thread: the matrices are small.
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    done = subprocess.run([python, "-B", __file__, *sys.argv[1:]], env=environment)
    sys.exit(done.returncode)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--small", action="store_true", help="coarse meshes against the stored results")
    form.add_argument("--compare", action="store_true", help="from stored results, no finite elements")
    arguments = parser.parse_args()
    in_own_environment()
    sys.path.insert(0, str(HERE))
    from fe import studies

    if arguments.small:
        sys.exit(studies.small())
    if not arguments.compare:
        studies.whole()
    from fe import laws

    laws.compare()


if __name__ == "__main__":
    main()
