"""Writes solids as other programs give them: truncated-octahedron.off, bracket.stl (ASCII) and cavity.poly (TetGen);
and boxes.json, a turned lattice of boxes that share faces, in three materials.

    python3 examples/make_solids.py
"""

import itertools
import os

from space import HERE, Complex


def write(name, text):
    with open(os.path.join(HERE, name), "w", encoding="utf-8") as file:
        file.write(text)


def truncated_octahedron():
    """All permutations of (0, 1, 2) with all signs: 24 vertices, 6 squares and 8 hexagons; fills space by itself."""
    vertices = sorted(
        {
            tuple(s * c for s, c in zip(signs, permutation))
            for permutation in itertools.permutations((0, 1, 2))
            for signs in itertools.product((-1, 1), repeat=3)
        }
    )
    planes = [(axis * s, 2) for s in (-1, 1) for axis in (1, 2, 3)]
    planes = [tuple((1 if a > 0 else -1) if k + 1 == abs(a) else 0 for k in range(3)) + (d,) for a, d in planes]
    planes += [signs + (3,) for signs in itertools.product((-1, 1), repeat=3)]
    faces = []
    for *normal, distance in planes:
        on = [i for i, v in enumerate(vertices) if sum(n * c for n, c in zip(normal, v)) == distance]
        face = [on[0]]
        while len(face) < len(on):  # counter-clockwise from outside: the next one has all others on its left
            p = vertices[face[-1]]
            for j in on:
                if j not in face and all(turn(normal, p, vertices[j], vertices[k]) >= 0 for k in on):
                    face.append(j)
                    break
        faces.append(face)
    lines = ["OFF", "# a truncated octahedron", f"{len(vertices)} {len(faces)} 36"]
    lines += [" ".join(map(str, v)) for v in vertices]
    lines += [" ".join(map(str, [len(f), *f])) for f in faces]
    write("truncated-octahedron.off", "\n".join(lines) + "\n")


def turn(normal, p, q, r):
    u, v = [b - a for a, b in zip(p, q)], [b - a for a, b in zip(p, r)]
    cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    return sum(n * c for n, c in zip(normal, cross))


def bracket():
    """An angle bracket with a square hole through its foot, in the triangles that a CAD program would write."""
    length, width, thick, high = 3, 1.5, 0.5, 2.5
    hole = [(1.5, 0.5), (2, 0.5), (2, 1), (1.5, 1)]
    profile = [(thick, thick), (thick, high), (0, high), (0, 0), (length, 0), (length, thick)]
    triangles = []

    def quad(a, b, c, d):
        triangles.extend([(a, b, c), (a, c, d)])

    # The two sides are fans around the inner corner of the profile; around it runs a band.
    for p, q in zip(profile[1:], profile[2:]):
        r = profile[0]
        triangles.append(tuple((x, 0, z) for x, z in (r, p, q)))
        triangles.append(tuple((x, width, z) for x, z in (r, q, p)))
    for (px, pz), (qx, qz) in zip(profile, profile[1:] + profile[:1]):
        if pz != qz:  # the other three have to go around the hole, or are the top
            quad((px, width, pz), (qx, width, qz), (qx, 0, qz), (px, 0, pz))
    quad((thick, width, high), (0, width, high), (0, 0, high), (thick, 0, high))
    for z, left in ((thick, thick), (0, 0)):
        outer = [(left, 0), (length, 0), (length, width), (left, width)]
        for i in range(4):
            j = (i + 1) % 4
            ring = [(*p, z) for p in (outer[i], outer[j], hole[j], hole[i])]
            quad(*(ring if z else ring[::-1]))
    for (px, py), (qx, qy) in zip(hole, hole[1:] + hole[:1]):
        quad((px, py, 0), (px, py, thick), (qx, qy, thick), (qx, qy, 0))

    lines = ["solid bracket"]
    for a, b, c in triangles:
        lines += ["facet normal " + " ".join(f"{x:g}" for x in unit_normal(a, b, c)), "outer loop"]
        lines += ["vertex " + " ".join(f"{x:g}" for x in p) for p in (a, b, c)]
        lines += ["endloop", "endfacet"]
    write("bracket.stl", "\n".join(lines) + "\nendsolid bracket\n")


def unit_normal(a, b, c):
    n = [turn(axis, a, b, c) for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    length = sum(x * x for x in n) ** 0.5
    return [x / length + 0.0 for x in n]


def cavity():
    """A block of two materials with an octahedral cavity in one of them; the wall between them has a round window."""
    points = [(x, y, z) for x in (0, 3, 6) for z in (0, 3) for y in (0, 3)]  # 1 to 12: y fastest
    a, b, c = (1, 2, 4, 3), (5, 6, 8, 7), (9, 10, 12, 11)
    facets = [([a], 1), ([c], 2)]
    for p, q in ((a, b), (b, c)):
        facets += [([(p[i], p[(i + 1) % 4], q[(i + 1) % 4], q[i])], 3) for i in range(4)]
    window = [(3, 1.5 + y, 1.5 + z) for y, z in ((1, 0), (0.5, 0.5), (0, 1), (-0.5, 0.5), (-1, 0), (0, -1))]
    facets.append(([b, tuple(range(13, 19))], 4))
    octahedron = [(1.5 + x, 1.5 + y, 1.5 + z) for x, y, z in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    octahedron += [(1.5 - x, 1.5 - y, 1.5 - z) for x, y, z in ((1, 0, 0), (0, 1, 0), (0, 0, 1))]
    points += window + octahedron
    for i, j, k in itertools.product((19, 22), (20, 23), (21, 24)):
        facets.append(([(i, j, k)], 5))
    lines = ["# two materials, and a cavity in the first", f"{len(points)} 3 0 0"]
    lines += [f"{i} " + " ".join(f"{x:g}" for x in p) for i, p in enumerate(points, 1)]
    lines.append(f"{len(facets)} 1")
    for loops, marker in facets:
        lines.append(f"{len(loops)} 0 {marker}")
        lines += [" ".join(map(str, [len(loop), *loop])) for loop in loops]
    lines += ["1", "1 1.5 1.5 1.5", "2", "1 0.25 0.25 0.25 1 0.5", "2 5 0.25 0.25 2 0"]
    write("cavity.poly", "\n".join(lines) + "\n")


def boxes():
    """A lattice of 3 x 2 x 2 unit boxes, turned by 3-4-5 and 5-12-13 triangles; every shared face is there once. The
    boxes of each layer across the longest side are one region, with its label and its bound on volumes."""

    def turned(x, y, z):
        x, y = (3 * x - 4 * y) / 5, (4 * x + 3 * y) / 5
        return x, (12 * y - 5 * z) / 13, (5 * y + 12 * z) / 13

    c = Complex()
    size = (3, 2, 2)
    v = {p: c.vertex(*turned(*p)) for p in itertools.product(*(range(n + 1) for n in size))}
    for axis in range(3):
        u, w = [a for a in range(3) if a != axis]
        for p in itertools.product(*(range(n + 1) for n in size)):
            if p[u] == size[u] or p[w] == size[w]:
                continue
            corners = []
            for du, dw in ((0, 0), (1, 0), (1, 1), (0, 1)):
                q = list(p)
                q[u] += du
                q[w] += dw
                corners.append(v[tuple(q)])
            c.face(corners)
    regions = []
    for x, y, z in itertools.product(range(3), range(2), range(2)):
        at = turned(x + 0.5, y + 0.5, z + 0.5)
        regions.append({"at": list(at), "label": x + 1, "max": (0.02, 0.005, 0.05)[x]})
    c.write("boxes.json", regions=regions)


if __name__ == "__main__":
    truncated_octahedron()
    bracket()
    cavity()
    boxes()
