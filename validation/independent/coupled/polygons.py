"""Polygons: where two of them overlap, by tracing both boundaries from crossing to crossing (Weiler and Atherton,
"Hidden surface removal using polygon area sorting", 1977). Any simple polygons, walked from x to y."""


def edges(polygon):
    return zip(polygon, polygon[1:] + polygon[:1])


def lies_within(point, polygon):
    """By the parity of crossings of a ray along x."""
    x, y = point
    inside = False
    for (ax, ay), (bx, by) in edges(polygon):
        if (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay):
            inside = not inside
    return inside


def overlaps(polygon_1, polygon_2):
    """Parts of the overlap of two simple polygons, each walked from x to y: (corners, chord) with the chord the sum of
    P_out - P_in, where polygon 1's boundary enters and leaves polygon 2."""
    crossings_1 = [[] for _ in polygon_1]
    crossings_2 = [[] for _ in polygon_2]
    number = 0
    sides_2 = list(edges(polygon_2))
    for i, (a, b) in enumerate(edges(polygon_1)):
        low_x, high_x = (a[0], b[0]) if a[0] < b[0] else (b[0], a[0])
        low_y, high_y = (a[1], b[1]) if a[1] < b[1] else (b[1], a[1])
        for j, (p, q) in enumerate(sides_2):
            if (p[0] < low_x and q[0] < low_x) or (p[0] > high_x and q[0] > high_x):
                continue
            if (p[1] < low_y and q[1] < low_y) or (p[1] > high_y and q[1] > high_y):
                continue
            ux, uy = q[0] - p[0], q[1] - p[1]
            wx, wy = b[0] - a[0], b[1] - a[1]
            side_a = ux * (a[1] - p[1]) - uy * (a[0] - p[0])
            side_b = ux * (b[1] - p[1]) - uy * (b[0] - p[0])
            side_p = wx * (p[1] - a[1]) - wy * (p[0] - a[0])
            side_q = wx * (q[1] - a[1]) - wy * (q[0] - a[0])
            if (side_a > 0.0) == (side_b > 0.0) or (side_p > 0.0) == (side_q > 0.0):
                continue
            share = side_a / (side_a - side_b)
            point = (a[0] + share * wx, a[1] + share * wy)
            crossings_1[i].append((share, number, point))
            crossings_2[j].append((side_p / (side_p - side_q), number, point))
            number += 1
    if number == 0:
        if lies_within(polygon_1[0], polygon_2) or lies_within(polygon_2[0], polygon_1):
            raise ValueError("one body lies inside the other")
        return []
    arcs_1 = inner_arcs(polygon_1, crossings_1, lies_within(polygon_1[0], polygon_2))
    arcs_2 = inner_arcs(polygon_2, crossings_2, lies_within(polygon_2[0], polygon_1))
    found = []
    while arcs_1:
        start, (end, points) = arcs_1.popitem()
        corners, chord = list(points), [points[-1][0] - points[0][0], points[-1][1] - points[0][1]]
        while True:
            end, points = arcs_2.pop(end)
            corners += points[1:]
            if end == start:
                break
            end, points = arcs_1.pop(end)
            corners += points[1:]
            chord[0] += points[-1][0] - points[0][0]
            chord[1] += points[-1][1] - points[0][1]
        found.append((corners[:-1], chord))
    return found


def inner_arcs(polygon, crossings, inside):
    """Stretches of a boundary within the other polygon: from the number of the crossing where each begins to (number
    of that where it ends, points)."""
    walk = []
    for vertex, cut in zip(polygon, crossings):
        walk.append((None, vertex))
        walk += [(number, point) for _, number, point in sorted(cut)]
    first = next(k for k, (number, _) in enumerate(walk) if number is not None)
    # Turned round so that it begins at a crossing; before that crossing the walk is where the polygon began.
    walk = walk[first:] + walk[:first] + [walk[first]]
    arcs, begun, points = {}, None, []
    for number, point in walk:
        if number is None:
            if begun is not None:
                points.append(point)
            continue
        if begun is not None:
            points.append(point)
            arcs[begun] = (number, points)
            begun, inside = None, False
        elif not inside:
            begun, inside, points = number, True, [point]
        else:
            inside = False
    return arcs


def area_and_centroid(corners):
    ox, oy = corners[0]
    twice, sum_x, sum_y = 0.0, 0.0, 0.0
    for (ax, ay), (bx, by) in edges(corners):
        ax, ay, bx, by = ax - ox, ay - oy, bx - ox, by - oy
        part = ax * by - ay * bx
        twice += part
        sum_x += part * (ax + bx)
        sum_y += part * (ay + by)
    if twice <= 1e-16:
        return 0.0, (ox, oy)
    return 0.5 * twice, (ox + sum_x / (3.0 * twice), oy + sum_y / (3.0 * twice))


def box_of(points):
    xs, ys = [p[0] for p in points], [p[1] for p in points]
    return min(xs), min(ys), max(xs), max(ys)


def boxes_meet(a, b):
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]

