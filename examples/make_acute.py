"""Writes star.json, comb.json and coast.json: small angles and narrow gaps.

    python3 examples/make_acute.py
"""

import json
import math
import os
import random

HERE = os.path.dirname(os.path.abspath(__file__))


def write(name, points):
    n = len(points)
    complex_ = {
        "circumball": 1,
        "dimension": 2,
        "vertices": points,
        "segments": [[i, (i + 1) % n] for i in range(n)],
    }
    with open(os.path.join(HERE, name), "w", encoding="utf-8") as file:
        json.dump(complex_, file)
        file.write("\n")


def polar(radius, degrees):
    a = math.radians(degrees)
    return [round(radius * math.cos(a), 6), round(radius * math.sin(a), 6)]


def star():
    """Seven needles of 12 to 1 degrees at their tips."""
    points = []
    for i, tip in enumerate([12, 8, 5, 4, 3, 2, 1]):
        middle, core, reach = 90 + 360 / 7 * i, 0.3, 0.8 + 0.04 * i
        half = 0.5 * tip * (reach - core) / core
        points += [polar(core, middle - half), polar(reach, middle), polar(core, middle + half)]
    write("star.json", points)


def comb():
    """A bar with four slits that are a millionth of it wide, two of them ending in a point."""
    gap = 1e-6
    points, x = [[0.0, 0.0]], 0.0
    for i, depth in enumerate([4e-5, 1e-4, 4e-5, 2e-4]):
        x = round(x + 0.2, 6)
        points.append([x, 0.0])
        if i % 2:
            points += [[x, depth], [x + gap, depth]]
        else:
            points.append([x + gap / 2, depth])
        points.append([x + gap, 0.0])
    points += [[1.0, 0.0], [1.0, 0.4], [0.0, 0.4]]
    write("comb.json", points)


def coast():
    """Land below a rough line: noise of octaves, with capes and inlets."""
    noise = random.Random(2009)
    n = 96
    height = [0.0] * (n + 1)
    amplitude, waves = 0.45, 2
    while waves <= n:
        knots = [noise.random() - 0.5 for _ in range(waves + 2)]
        for i in range(n + 1):
            k, s = divmod(i * waves / n, 1)
            height[i] += amplitude * ((1 - s) * knots[int(k)] + s * knots[int(k) + 1])
        amplitude *= 0.85
        waves *= 2
    points = [[0.0, -0.8], [2.0, -0.8]]
    points += [[round(2 * i / n, 6), round(height[i], 6)] for i in range(n, -1, -1)]
    write("coast.json", points)


if __name__ == "__main__":
    star()
    comb()
    coast()
