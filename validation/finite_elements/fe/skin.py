"""A skin with a bending stiffness, which keeps a compressed surface from creasing.

The free surface of a neo-Hookean solid folds into itself where it is compressed by more than about 35 %; the
inside of a bore that is pressed flat reaches that. The folds are small and hardly change the reaction,
but elements are inverted in them. A skin that resists only bending prevents them; the study of its stiffness
shows its effect.
"""

import numpy as np
from scipy.sparse import coo_matrix


def stiffness(points, edges, bending, size):
    """Matrix over all unknowns of a skin of bending stiffness `bending` on these edges (rows of three nodes, the
    middle one second): half of it times the squared second derivative of the displacement along the surface."""
    triples = [tuple(edge) for edge in edges]
    ends = {}
    for first, middle, last in edges:
        ends.setdefault(first, []).append(middle)
        ends.setdefault(last, []).append(middle)
    triples += [(two[0], node, two[1]) for node, two in ends.items() if len(two) == 2]
    rows, columns, values = [], [], []
    difference = np.array([1.0, -2.0, 1.0])
    for triple in triples:
        place = points[list(triple)]
        spacing = (np.linalg.norm(place[1] - place[0]) + np.linalg.norm(place[2] - place[1])) / 2
        block = bending / spacing**3 * np.outer(difference, difference)
        for axis in (0, 1):
            unknowns = 2 * np.array(triple) + axis
            rows.append(np.repeat(unknowns, 3))
            columns.append(np.tile(unknowns, 3))
            values.append(block.ravel())
    if not rows:
        return coo_matrix((size, size)).tocsr()
    place = (np.concatenate(rows), np.concatenate(columns))
    return coo_matrix((np.concatenate(values), place), shape=(size, size)).tocsr()
