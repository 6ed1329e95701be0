"""Settings of the book. `cargo xtask book` builds it; https://www.sphinx-doc.org explains each setting."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "_extensions"))

project = "fenderline"
author = "The fenderline contributors"
project_copyright = "the fenderline contributors, MIT or Apache-2.0"
language = "en"

extensions = ["myst_parser", "mathml", "repository"]

root_doc = "index"
exclude_patterns = ["_extensions", "requirements.txt", "figures"]

# Every broken reference is a warning, and `cargo xtask book` makes an error of each warning.
nitpicky = True
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
myst_links_external_new_tab = True
# Code blocks of the guides are run by the tests; some hold lines that the highlighter does not know.
suppress_warnings = ["misc.highlighting_failure"]
math_number_all = False
numfig = True

html_math_renderer = "mathml"
html_theme = "furo"
html_title = "fenderline"
html_copy_source = False
html_show_sphinx = False
html_static_path = ["_static"]
html_css_files = ["book.css"]
html_theme_options = {"sidebar_hide_name": False}
