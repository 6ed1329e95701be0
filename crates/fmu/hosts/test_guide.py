"""The guide's snippets are one program, and it prints what the guide says."""

import re
import subprocess
import sys

from conftest import PROGRAM, ROOT


def test_the_guide_prints_what_it_says(tmp_path):
    guide = (ROOT / "docs" / "guides" / "fmi.md").read_text()
    blocks = re.findall(r"^```(\w+)\n(.*?)^```$", guide, re.MULTILINE | re.DOTALL)
    program = tmp_path / "guide.py"
    program.write_text("".join(text for language, text in blocks if language == "python"))
    (said,) = [text for language, text in blocks if language == "text"]
    # The ship's module is imported by the builder.
    command = [sys.executable, "-B", program, PROGRAM]
    done = subprocess.run(command, cwd=ROOT, text=True, capture_output=True)
    assert done.returncode == 0, done.stderr
    assert done.stdout == said
