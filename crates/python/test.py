"""Tests the Python package as a user gets it: `pip install .` into a clean virtual environment, then pytest with all
doctests, the guide's snippets and the example, stubtest, and mypy on tests and examples.

    python3 crates/python/test.py            # what continuous integration runs
    python3 crates/python/test.py --heavy    # with Stable-Baselines3 (PyTorch, 5 GB): its tests run too
    python3 crates/python/test.py --wheel WHEEL PYTHON...   # a wheel, in a clean environment of each interpreter

Standard library only. `cargo xtask test all` calls it; it needs Rust, Python 3.11 or later, and PyPI.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
import tempfile
import time
import venv
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
OWN = ROOT / "crates" / "python"
# For compiled modules; removed at the end.
CACHE = tempfile.TemporaryDirectory(prefix="fenderline-modules-")


def run(*command: str | Path, cwd: Path = ROOT, **environment: str) -> None:
    print("$", *command, flush=True)
    began = time.monotonic()
    # No packages of the user, no questions by pip, no __pycache__ in the source tree; modules are compiled when they are
    # first imported, because compiling all of them takes as long as unpacking them.
    clean = {
        "PYTHONNOUSERSITE": "1",
        "PYTHONDONTWRITEBYTECODE": "",
        "PYTHONPYCACHEPREFIX": CACHE.name,
        "PIP_NO_INPUT": "1",
        "PIP_NO_COMPILE": "1",
    }
    subprocess.run(
        [str(part) for part in command],
        cwd=cwd,
        env=os.environ | clean | environment,
        check=True,
        stdin=subprocess.DEVNULL,
    )
    print(f"-- {time.monotonic() - began:.0f} s", flush=True)


def install_list(python: str | Path, requirements: Path) -> None:
    """Installs the packages of a list: by uv where it is installed, which takes a tenth of pip's time, else by pip."""
    uv = shutil.which("uv")
    if uv is not None:
        try:
            return run(uv, "pip", "install", "--quiet", "--python", python, "-r", requirements)
        except subprocess.CalledProcessError as error:
            print(f"uv failed with exit code {error.returncode}; pip installs the packages", flush=True)
    run(*pip_install(python), "-r", requirements)


def pip_install(python: str | Path) -> list[str | Path]:
    return [python, "-m", "pip", "--disable-pip-version-check", "install", "--quiet"]


def target_folder() -> Path:
    cargo = os.environ.get("CARGO", "cargo")
    metadata = subprocess.run(
        [cargo, "metadata", "--format-version", "1", "--no-deps"],
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    return Path(json.loads(metadata.stdout)["target_directory"])


def test_wheel(wheel: Path, pythons: list[str]) -> None:
    """Installs a wheel into a clean environment of each interpreter, and runs the tests from a folder outside the checkout.

    Without the program, the tests that compare with it are skipped.
    """
    for interpreter in pythons:
        with tempfile.TemporaryDirectory() as text:
            folder = Path(text)
            run(interpreter, "-m", "venv", folder / "venv")
            python = folder / "venv" / ("Scripts" if os.name == "nt" else "bin") / "python"
            install_list(python, OWN / "requirements-test.txt")
            run(*pip_install(python), wheel.resolve())
            # The tests read scenarios and documents beside them; no source of the package is copied.
            beside = [
                "scenarios",
                "campaigns",
                "docs",
                "examples",
                "crates/app/tests/verdict",
                "crates/campaign/tests",
            ]
            for name in ["crates/python/tests", *beside]:
                shutil.copytree(ROOT / name, folder / "outside" / name)
            shutil.copy(ROOT / "pyproject.toml", folder / "outside")
            run(python, "--version")
            run(python, "-m", "pytest", cwd=folder / "outside")


def main() -> None:
    if sys.argv[1:2] == ["--wheel"]:
        return test_wheel(Path(sys.argv[2]), sys.argv[3:])
    target = target_folder()
    folder = target / "python-package"
    if folder.exists():
        shutil.rmtree(folder)
    venv.create(folder, with_pip=True)
    python = folder / ("Scripts" if os.name == "nt" else "bin") / "python"
    install_list(python, OWN / "requirements-test.txt")
    if "--heavy" in sys.argv[1:]:
        install_list(python, OWN / "requirements-heavy.txt")
    run(*pip_install(python), ".", CARGO_TARGET_DIR=str(target))
    # The program with which the package's numbers are compared: `cargo xtask test` names the one that it has built.
    program = os.environ.get("FENDERLINE_PROGRAM")
    if program is None:
        run(os.environ.get("CARGO", "cargo"), "build", "--release", "--package", "fenderline")
        program = str(target / "release" / ("fenderline.exe" if os.name == "nt" else "fenderline"))
    pytest = [python, "-m", "pytest"]
    run(*pytest, FENDERLINE_PROGRAM=program)
    run(*pytest, "--doctest-modules", "--pyargs", "fenderline")
    mypy_config = ["--mypy-config-file", ROOT / "pyproject.toml"]
    # `python -m` searches the current folder first, but this one has no package: the installed one is found.
    run(python, "-m", "mypy.stubtest", *mypy_config, "fenderline")
    cache = ["--cache-dir", folder / "mypy"]
    run(python, "-m", "mypy", *cache, OWN / "tests", OWN / "bench.py", ROOT / "examples" / "python")


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as error:
        sys.exit(f"failed: {error}")
