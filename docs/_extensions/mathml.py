"""Equations as MathML, written at build time by docutils: pages show them without scripts and without a network."""

from docutils.nodes import SkipNode
from docutils.utils.math import MathError
from docutils.utils.math.latex2mathml import tex2mathml
from sphinx.errors import ExtensionError


def inline(translator, node):
    translator.body.append(_mathml(node, as_block=False))
    raise SkipNode


def block(translator, node):
    identifiers = f' id="{node["ids"][0]}"' if node.get("ids") else ""
    number = f'<span class="number">({node["number"]})</span>' if node.get("number") else ""
    translator.body.append(f'<div class="equation"{identifiers}>{_mathml(node, as_block=True)}{number}</div>\n')
    raise SkipNode


def _mathml(node, as_block):
    text = node.astext()
    try:
        return tex2mathml(text, as_block=as_block)
    except (MathError, IndexError) as error:
        raise ExtensionError(f"{node.source}:{node.line}: equation {text!r}: {error}") from error


def setup(app):
    app.add_html_math_renderer("mathml", (inline, None), (block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
