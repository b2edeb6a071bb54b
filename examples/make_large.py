"""Writes solids of many facets, which are too large to be stored, to the folder that is given (default: here):
polytope.off, a polytope around a sphere, of hexagons and twelve pentagons, whose angles are all blunt; terrain.json, a
block under a rough terrain of triangles, whose angles are sharp everywhere.

    python3 examples/make_large.py [folder [frequency [side]]]

There are 10 frequency^2 + 2 faces of the polytope (default 32: 10,242), and 2 side^2 triangles of the terrain (default
70: 9,800)."""

import itertools
import math
import os
import sys

import space


def cross(p, q):
    return [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]


def unit(p):
    length = math.sqrt(sum(c * c for c in p))
    return [c / length for c in p]


def geodesic(frequency):
    """A subdivided icosahedron on the unit sphere: its vertices, and its triangles counter-clockwise from outside."""
    g = (1 + math.sqrt(5)) / 2
    corners = [p for a, b in itertools.product((-1, 1), (-g, g)) for p in ((0, a, b), (a, b, 0), (b, 0, a))]
    edge = min(math.dist(p, q) for p, q in itertools.combinations(corners, 2)) * 1.01
    numbers, points, triangles = {}, [], []

    def number(weights):
        key = tuple(sorted((c, w) for c, w in weights if w))
        if key not in numbers:
            numbers[key] = len(points)
            points.append(unit([sum(w * corners[c][k] for c, w in weights) for k in range(3)]))
        return numbers[key]

    for a, b, c in itertools.combinations(range(12), 3):
        if max(math.dist(corners[i], corners[j]) for i, j in ((a, b), (b, c), (a, c))) > edge:
            continue
        u, v = ([q - p for p, q in zip(corners[a], corners[k])] for k in (b, c))
        if sum(x * y for x, y in zip(cross(u, v), corners[a])) < 0:
            b, c = c, b
        at = lambda i, j: number([(a, frequency - i - j), (b, i), (c, j)])
        for i in range(frequency):
            for j in range(frequency - i):
                triangles.append((at(i, j), at(i + 1, j), at(i, j + 1)))
                if i + j + 2 <= frequency:
                    triangles.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
    return points, triangles


def polytope(folder, frequency):
    """Its faces touch the sphere at the vertices of a geodesic sphere; a vertex is where those of a triangle meet."""
    points, triangles = geodesic(frequency)
    vertices, beside = [], [{} for _ in points]
    for t, (a, b, c) in enumerate(triangles):
        p, q, r = points[a], points[b], points[c]
        normal = cross([y - x for x, y in zip(p, q)], [y - x for x, y in zip(p, r)])
        scale = sum(x * y for x, y in zip(normal, p))
        vertices.append([x / scale for x in normal])
        for v, after in ((a, b), (b, c), (c, a)):
            beside[v][after] = t
    lines = ["OFF", f"{len(vertices)} {len(points)} 0"]
    lines += [" ".join(map(repr, v)) for v in vertices]
    ends = {}
    for t, (a, b, c) in enumerate(triangles):
        ends.update({(a, b): c, (b, c): a, (c, a): b})
    for v, around in enumerate(beside):
        first = after = min(around)
        face = []
        while True:
            face.append(around[after])
            after = ends[v, after]
            if after == first:
                break
        lines.append(" ".join(map(str, [len(face), *face])))
    with open(os.path.join(folder, "polytope.off"), "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")


def terrain(folder, side):
    """Heights are made of bits of a linear congruence."""
    c = space.Complex()
    known, state = {}, 1
    c.segment = lambda a, b: known.setdefault((min(a, b), max(a, b)), len(known))
    top = {}
    for i, j in itertools.product(range(side + 1), repeat=2):
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        top[i, j] = c.vertex(i, j, 2 * (state >> 40) / 2**24)
    low = {p: c.vertex(*p, -side / 4) for p in ((0, 0), (side, 0), (side, side), (0, side))}
    for i, j in itertools.product(range(side), repeat=2):
        c.face([top[i, j], top[i + 1, j], top[i + 1, j + 1]])
        c.face([top[i, j], top[i + 1, j + 1], top[i, j + 1]])
    c.face([low[p] for p in ((0, 0), (0, side), (side, side), (side, 0))])
    for p, q in (((0, 0), (side, 0)), ((side, 0), (side, side)), ((side, side), (0, side)), ((0, side), (0, 0))):
        step = [(b - a) // side for a, b in zip(p, q)]
        rim = [top[q[0] - k * step[0], q[1] - k * step[1]] for k in range(side + 1)]
        c.face([low[p], low[q], *rim])
    c.segments = [list(s) for s in known]
    space.HERE = folder
    c.write("terrain.json")


if __name__ == "__main__":
    target = sys.argv[1] if len(sys.argv) > 1 else space.HERE
    polytope(target, int(sys.argv[2]) if len(sys.argv) > 2 else 32)
    terrain(target, int(sys.argv[3]) if len(sys.argv) > 3 else 70)
