"""Writes small and sharp complexes of space: face-with-holes.json, plates.json, wedge.json, fan-of-faces.json,
schoenhardt.json, and in bad/ four that are not valid, for tests and to see what is said about them.

    python3 examples/make_sharp.py
"""

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
    wedge()
    fan_of_faces()
    schoenhardt()
    bad()
