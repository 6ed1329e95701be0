"""Pages that stand elsewhere in the repository, with their links turned so that they work in the book."""

import os
import re
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent
ROOT = DOCS.parent
GENERATED = DOCS / "_generated"

# File in the repository, and its page in docs/_generated. Other files go by the same name as in the repository.
PAGES = [
    "ARCHITECTURE.md",
    "CHANGELOG.md",
    "CONTRIBUTING.md",
    "SECURITY.md",
    "fenders/README.md",
    "vessels/README.md",
    "validation/README.md",
    "validation/independent/README.md",
    "examples/c/README.md",
    "examples/cpp/README.md",
    "examples/csharp/README.md",
]
LINK = re.compile(r"(?<!`)\]\((?!https?:|mailto:|#)([^)\s]+)\)")


def from_repository() -> dict[str, str]:
    return {name: adapted(name) for name in PAGES}


def adapted(name: str) -> str:
    text = (ROOT / name).read_text(encoding="utf-8")
    # Fences such as "```toml scenario" tell the tests what a snippet is; the highlighter knows the first word alone.
    text = re.sub(r"^```(\w+) [^\n]*$", r"```\1", text, flags=re.MULTILINE)
    here = (GENERATED / name).parent

    def turned(match: re.Match) -> str:
        target, hash_mark, anchor = match[1].partition("#")
        path = (ROOT / name).parent / target
        if not path.exists():
            raise SystemExit(f"{name}: a link to {match[1]}, which does not exist")
        inside = os.path.relpath(path, ROOT)
        place = GENERATED / inside if inside in PAGES else path
        return f"]({os.path.relpath(place, here)}{hash_mark}{anchor})"

    return LINK.sub(turned, text)
