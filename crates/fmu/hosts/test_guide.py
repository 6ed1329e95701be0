"""The guide's snippets form one program, which prints the guide's output."""

import re
import subprocess
import sys

from conftest import PROGRAM, ROOT


def test_the_guides_program_prints_its_output(tmp_path):
    guide = (ROOT / "docs" / "guides" / "fmi.md").read_text()
    blocks = re.findall(r"^```(\w+)\n(.*?)^```$", guide, re.MULTILINE | re.DOTALL)
    program = tmp_path / "guide.py"
    program.write_text("".join(text for language, text in blocks if language == "python"))
    (expected,) = [text for language, text in blocks if language == "text"]
    # -B, as the builder imports the ship's module.
    command = [sys.executable, "-B", program, PROGRAM]
    done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout == expected
