"""Writes small and sharp complexes of space: face-with-holes.json, plates.json, near-plates.json, wedge.json,
fan-of-faces.json, book.json, schoenhardt.json, needles.json, spikes.json, segments-at-a-face.json, dangling.json, and
in bad/ four that are not valid, for tests and to see what is said about them.

    python3 examples/make_sharp.py
"""

import itertools
import math

from space import Complex, direction, square


def face_with_holes():
    """A plate with a square and a triangular hole, a slit and a vertex in it, and a fin that leans on the slit."""
    c = Complex()
    outer = c.add([(0, 0, 0), (12, 0, 0), (12, 8, 0), (0, 8, 0)])
    window = c.add(square(1, 0, (3.0, 4.0)))
    triangle = c.add([(8, 4.5, 0), (11, 4.5, 0), (9.5, 7, 0)])
    slit = c.add([(6.5, 1.5, 0), (10.5, 2.5, 0)])
    lonely = c.vertex(5.5, 6, 0)
    c.face(
        outer, window, triangle, holes=[(3.0, 4.0, 0.0), (9.5, 5.5, 0.0)], segments=[slit], vertices=[lonely]
    )
    c.face(slit + c.add([(10.5, 2.0, 2), (6.5, 1.0, 2)]))
    c.write("face-with-holes.json")


def plates():
    """Two squares 0.02 apart on one side; the upper one is tilted by 1 degree."""
    c = Complex()
    rise = math.tan(math.radians(1))
    c.face(c.add([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]))
    c.face(c.add([(0.1, 0.05, 0.02), (1.1, 0.05, 0.02 + rise), (1.1, 1.05, 0.02 + rise), (0.1, 1.05, 0.02)]))
    c.write("plates.json")


def near_plates():
    """Two squares a thousandth apart, where corners of them overlap."""
    c = Complex()
    c.face(c.add([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]))
    c.face(c.add([(0.95, 0.92, 0.001), (1.95, 0.92, 0.001), (1.95, 1.92, 0.001), (0.95, 1.92, 0.001)]))
    c.write("near-plates.json")


def wedge():
    """A solid whose two large sides enclose 1 degree."""
    c = Complex()
    h = math.tan(math.radians(1))
    a, b, d = (c.add([(x, 0, z), (x, 1, z)]) for x, z in ((0, 0), (1, 0), (1, h)))
    c.face([a[0], a[1], b[1], b[0]])
    c.face([a[0], d[0], d[1], a[1]])
    c.face([b[0], b[1], d[1], d[0]])
    c.face([a[0], b[0], d[0]])
    c.face([a[1], d[1], b[1]])
    c.write("wedge.json")


def fan_of_faces():
    """Nine unit squares around an axis, 1, 2, 3, 5, 8, 13, 20 and 30 degrees apart."""
    c = Complex()
    bottom, top = c.vertex(0, 0, 0), c.vertex(0, 0, 1)
    angle = 0
    for step in (0, 1, 2, 3, 5, 8, 13, 20, 30):
        angle += step
        x, y = direction(angle)
        c.face([bottom, c.vertex(x, y, 0), c.vertex(x, y, 1), top])
    c.write("fan-of-faces.json")


def book():
    """Forty unit squares around one edge, 9 degrees apart."""
    c = Complex()
    bottom, top = c.vertex(0, 0, 0), c.vertex(0, 0, 1)
    for page in range(40):
        x, y = direction(9 * page)
        c.face([bottom, c.vertex(x, y, 0), c.vertex(x, y, 1), top])
    c.write("book.json")


def tetrahedron(c, base, tip):
    """The four faces of a tetrahedron; base counter-clockwise seen from the tip."""
    c.face(base[::-1])
    for i in range(3):
        c.face([base[i], base[(i + 1) % 3], tip])


def needles():
    """Three tetrahedra, 5, 15 and 40 times as long as wide, that lie side by side."""
    c = Complex()
    for x, width in ((0, 0.2), (0.6, 0.0667), (1.0, 0.025)):
        base = c.add([(x + width * a, width * b, 0) for a, b in (direction(90 + 120 * i) for i in range(3))])
        tetrahedron(c, base, c.vertex(x, 0, 1))
    c.write("needles.json")


def spikes():
    """A star: on each face of an octahedron a spike four and a half times as high as it is wide."""
    c = Complex()
    core = {}
    for axis in range(3):
        for sign in (1, -1):
            core[axis, sign] = c.vertex(*(sign if k == axis else 0 for k in range(3)))
    for signs in itertools.product((1, -1), repeat=3):
        base = [core[axis, sign] for axis, sign in enumerate(signs)]
        tip = c.vertex(*(4.0 * sign for sign in signs))
        for i in range(3):
            loop = [base[i], base[(i + 1) % 3], tip]
            c.face(loop if math.prod(signs) > 0 else loop[::-1])
    c.write("spikes.json")


def segments_at_a_face():
    """Segments that rise from vertices of a plate at 1, 3, 10, 30 and 60 degrees."""
    c = Complex()
    outer = c.add([(0, 0, 0), (6, 0, 0), (6, 2, 0), (0, 2, 0)])
    feet = [c.vertex(1 + i, 0.5, 0) for i in range(5)]
    c.face(outer, vertices=feet)
    for foot, degrees in zip(feet, (1, 3, 10, 30, 60)):
        along, up = direction(degrees)
        x, y, _ = c.vertices[foot]
        c.segment(foot, c.vertex(x, y + along, up))
    c.write("segments-at-a-face.json")


def dangling():
    """A closed box with what a domain need not have: a fin inside and one outside of it, a segment that leaves it, a
    segment and a vertex inside of a side, and a plate that floats within."""
    c = Complex()
    v = {p: c.vertex(*p) for p in itertools.product((0, 2), repeat=3)}
    window = c.add([(0.4, 0, 0.4), (1.2, 0, 0.8)])
    lonely = c.vertex(1.5, 0, 1.5)
    root = c.vertex(0.5, 0, 1.4)
    for axis in range(3):
        for side in (0, 2):
            corners = []
            for a, b in ((0, 0), (2, 0), (2, 2), (0, 2)) if (axis == 1) != (side == 2) else ((0, 0), (0, 2), (2, 2), (2, 0)):
                p = [a, b]
                p.insert(axis, side)
                corners.append(v[tuple(p)])
            if axis == 1 and side == 0:
                c.face(corners, segments=[window], vertices=[lonely, root])
            else:
                c.face(corners)
    c.face([*window, c.vertex(1.2, 0.9, 0.6), c.vertex(0.4, 0.9, 0.2)])
    c.face([*window, c.vertex(1.2, -0.5, 1.2), c.vertex(0.4, -0.5, 0.8)])
    c.segment(root, c.vertex(0.5, -1, 1.6))
    c.face(c.add([(0.5, 1.2, 1.2), (1.5, 1.2, 1.3), (1.5, 1.7, 1.5), (0.5, 1.7, 1.4)]))
    c.write("dangling.json")


def schoenhardt():
    """Schönhardt's prism (1928): twisted by 30 degrees, no tetrahedron on its vertices alone fits in."""
    c = Complex()
    low = c.add([(*direction(120 * i), 0) for i in range(3)])
    high = c.add([(*direction(120 * i + 30), 1) for i in range(3)])
    c.face(low[::-1])
    c.face(high)
    for i in range(3):
        j = (i + 1) % 3
        # This diagonal turns by 150 degrees and passes near the axis: each side folds inward.
        c.face([low[i], low[j], high[j]])
        c.face([low[i], high[j], high[i]])
    c.write("schoenhardt.json")


def bad():
    """What `check` must find: faces that cross, a face that is not flat, a segment through a face, a vertex on one."""
    c = Complex()
    c.face(c.add(square(1, 0)))
    c.face(c.add([(-0.5, 0, -1), (0.5, 0, -1), (0.5, 0.2, 1), (-0.5, 0.2, 1)]))
    c.write("bad/crossing-faces.json")

    c = Complex()
    c.face(c.add([(0, 0, 0), (1, 0, 0), (1, 1, 0.01), (0, 1, 0)]))
    c.write("bad/non-planar-face.json")

    c = Complex()
    c.face(c.add(square(1, 0)))
    c.segment(c.vertex(0.25, 0.25, -1), c.vertex(0.25, 0.5, 1))
    c.write("bad/pierced-face.json")

    c = Complex()
    c.face(c.add(square(1, 0)))
    c.vertex(0.25, 0.5, 0)
    c.write("bad/vertex-on-face.json")


if __name__ == "__main__":
    face_with_holes()
    plates()
    near_plates()
    wedge()
    fan_of_faces()
    book()
    needles()
    spikes()
    segments_at_a_face()
    dangling()
    schoenhardt()
    bad()
