"""Writes the inputs of chapter 4 of the thesis: three-squares.json (Figure 4.1), pyramid.json (Example 4.2.1),
wheel.json (Example 4.2.2) and two-non-convex.json (Example 4.2.3), each in 26 free points.

    python3 examples/make_feature_size.py

The thesis prints pictures and, for the wheel, counts, but no sizes: those here are fitted to counts of vertices after
steps 0, 1a, 1b, 2a and 2b, of the thesis for the wheel and of a prototype for the others: 38, 62, 140, 482, 1858;
31, 47, 51, 135, 542; 72, 202, 518, 2051, 11351; 42, 76, 156, 549, 2160.
"""

from space import Complex, direction, square

# Figure 4.1: one large square slightly below two small ones, side by side.
LARGE, SMALL, GAP, HEIGHT = 3.0, 1.0, 0.09, 0.1
SQUARES_BOX = 4.5
# Example 4.2.1: sides of the base are 2 BASE long.
BASE, APEX = 1.0, 1.48
PYRAMID_BOX = 3.0
# Example 4.2.2: unit spokes about an axis of length 1, a square of side 2 PLATE below them.
SPOKES, PLATE, BELOW, SHIFT = 20, 2.5, 0.077, 0.25
WHEEL_BOX = 5.0
# Example 4.2.3: two faces of 8 and 10 sides that share one, at an angle in degrees; the width of the U's notch.
ANGLE, NOTCH = 19.2, 0.42
NON_CONVEX_BOX = 12.0


def three_squares():
    c = Complex()
    c.face(c.add(square(LARGE / 2, 0)))
    for side in (-1, 1):
        c.face(c.add(square(SMALL / 2, HEIGHT, (side * (SMALL + GAP) / 2, 0.0))))
    c.free_points((0.0, 0.0, HEIGHT / 2), SQUARES_BOX)
    c.write("three-squares.json")


def pyramid():
    c = Complex()
    base = c.add(square(BASE, 0))
    apex = c.vertex(0, 0, APEX)
    c.face(base[::-1])
    for i in range(4):
        c.face([base[i], base[(i + 1) % 4], apex])
    c.free_points((0.0, 0.0, APEX / 2), PYRAMID_BOX)
    c.write("pyramid.json")


def wheel():
    c = Complex()
    bottom, top = c.vertex(0, 0, 0), c.vertex(0, 0, 1)
    for i in range(SPOKES):
        x, y = direction(360 * i / SPOKES)
        c.face([bottom, c.vertex(x, y, 0), c.vertex(x, y, 1), top])
    c.face(c.add(square(PLATE, -BELOW, (SHIFT, 0.0))))
    c.free_points((0.0, 0.0, 0.5), WHEEL_BOX)
    c.write("wheel.json")


def two_non_convex():
    """A U that lies, and stairs that lean over it, with the bottom of the U in common."""
    c = Complex()
    left, right = 3 - NOTCH / 2, 3 + NOTCH / 2
    u = c.add([(x, y, 0) for x, y in ((0, 0), (6, 0), (6, 6), (right, 6), (right, 2), (left, 2), (left, 6), (0, 6))])
    c.face(u)
    cos, sin = direction(ANGLE)
    stairs = ((6, 1.5), (5, 1.5), (5, 3), (3.5, 3), (3.5, 4.5), (2, 4.5), (2, 6), (0, 6))
    c.face([u[0], u[1]] + c.add([(x, y * cos, y * sin) for x, y in stairs]))
    c.free_points((3.0, 3.0, 2.0), NON_CONVEX_BOX)
    c.write("two-non-convex.json")


if __name__ == "__main__":
    three_squares()
    pyramid()
    wheel()
    two_non_convex()
