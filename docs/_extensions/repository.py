"""Links from pages to the rest of the repository.

A page links `../SECURITY.md` or `../crates/contact/src/step.rs`, which works where the repository is browsed. In the book
the first becomes a link to that page's copy (`docs/generate/pages.py` lists which there are). The book holds no sources, so
that the second becomes the file's name. A link to what does not exist is a warning.
"""

import os
import sys
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms import SphinxTransform
from sphinx.util import logging

DOCS = Path(__file__).resolve().parent.parent
ROOT = DOCS.parent
sys.path.insert(0, str(DOCS / "generate"))
from pages import LINK, PAGES  # noqa: E402

log = logging.getLogger(__name__)


def to_copies(app, name, source):
    """Turns links to pages outside of docs to their copies in docs/_generated."""
    here = (DOCS / name).parent

    def turned(match):
        target, hash_mark, anchor = match[1].partition("#")
        inside = os.path.relpath((here / target).resolve(), ROOT)
        if inside not in PAGES:
            return match[0]
        return f"]({os.path.relpath(DOCS / '_generated' / inside, here)}{hash_mark}{anchor})"

    source[0] = LINK.sub(turned, source[0])


class SourceFiles(SphinxTransform):
    """Shows links to files of the repository as their names."""

    default_priority = 5

    def apply(self, **_):
        here = Path(self.document["source"]).parent
        for node in list(self.document.findall(addnodes.download_reference)):
            path = (here / node["reftarget"]).resolve()
            if not path.is_relative_to(ROOT) or not path.exists():
                log.warning("no file of the repository: %s", node["reftarget"], location=node)
                continue
            name = os.path.relpath(path, ROOT)
            shown = node.astext()
            text = name if name.endswith(shown) else f"{shown} ({name})"
            node.replace_self(nodes.literal(text, text))


def setup(app):
    app.connect("source-read", to_copies)
    app.add_transform(SourceFiles)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
