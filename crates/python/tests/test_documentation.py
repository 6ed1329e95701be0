"""The examples in the documentation: docstrings of native classes, the guide, the example programs."""

import doctest
import inspect
import re
import runpy
from pathlib import Path

import fenderline
import pytest

NATIVE = [fenderline.Scenario, fenderline.Engine, fenderline.Simulation, fenderline.Fleet]


@pytest.mark.parametrize("native", NATIVE, ids=lambda native: native.__name__)
def test_docstrings_of_native_classes(native: type) -> None:
    parsed = doctest.DocTestParser().get_doctest(
        native.__doc__ or "", {}, native.__name__, None, None
    )
    assert parsed.examples
    output: list[str] = []
    failed, _ = doctest.DocTestRunner().run(parsed, out=output.append)
    assert not failed, "".join(output)


def test_everything_public_has_a_docstring() -> None:
    bare = []
    for name in fenderline.__all__:
        thing = getattr(fenderline, name)
        if isinstance(thing, type):
            members = [f"{name}.{m}" for m in vars(thing) if not m.startswith("_")]
            bare += [m for m in members if not inspect.getdoc(getattr(thing, m.split(".")[1]))]
        if callable(thing) and not thing.__doc__:
            bare.append(name)
    # Exceptions' plain fields are documented in the source.
    plain = {"file", "line", "column", "key", "message", "help", "run"}
    assert [name for name in bare if name.rpartition(".")[2] not in plain] == []


@pytest.mark.parametrize(("page", "least"), [("python", 4), ("learners", 1)])
def test_the_guides_snippets(
    root: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, page: str, least: int
) -> None:
    if page == "learners":
        pytest.importorskip("pettingzoo", reason="PettingZoo is not installed")
    guide = (root / "docs" / "guides" / f"{page}.md").read_text("utf-8")
    snippets = re.findall(r"^```python\n(.*?)^```$", guide, re.MULTILINE | re.DOTALL)
    assert len(snippets) >= least
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {"__name__": "__main__"}
    for snippet in snippets:
        exec(compile(snippet, f"docs/guides/{page}.md", "exec"), names)


def test_the_docking_example(root: Path, capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(root / "examples" / "python" / "docking.py"), run_name="__main__")
    assert "alongside" in capsys.readouterr().out
