#!/usr/bin/env python3
"""Draws examples/lake.json: a lake with smooth shores and three islands. Usage: python3 make_lake.py > lake.json

A shore is a circle with a few harmonics of random amplitude and phase; its vertices are spaced evenly along it.
"""

import json
import math
import random


def shore(rng, center, radius, stretch, roughness, count):
    """A closed curve of `count` vertices around `center`, rounded to centimeters."""
    harmonics = [(k, roughness * radius / k**1.1 * rng.uniform(0.4, 1), rng.uniform(0, 2 * math.pi)) for k in range(2, 7)]

    def at(angle):
        r = radius + sum(a * math.cos(k * angle + phase) for k, a, phase in harmonics)
        return center[0] + stretch * r * math.cos(angle), center[1] + r * math.sin(angle)

    fine = [at(2 * math.pi * i / 4000) for i in range(4001)]
    lengths = [0.0]
    for p, q in zip(fine, fine[1:]):
        lengths.append(lengths[-1] + math.dist(p, q))
    points, j = [], 0
    for i in range(count):
        while lengths[j] < lengths[-1] * i / count:
            j += 1
        points.append([round(c, 2) for c in fine[j]])
    return points


def main():
    rng = random.Random(11)
    vertices, segments = [], []
    for loop in (
        shore(rng, (50, 32), 28, 1.6, 0.34, 96),
        shore(rng, (32, 36), 7, 1.2, 0.28, 26),
        shore(rng, (66, 28), 5, 1.5, 0.25, 24),
        shore(rng, (52, 44), 2, 1.1, 0.2, 14),
    ):
        first = len(vertices)
        vertices += loop
        segments += [[first + i, first + (i + 1) % len(loop)] for i in range(len(loop))]
    lines = ['{"circumball": 1, "dimension": 2,', '"vertices": [']
    for what, end in ((vertices, '], "segments": ['), (segments, "]}")):
        texts = [json.dumps(item) for item in what]
        lines += [", ".join(texts[i : i + 6]) + ("," if i + 6 < len(texts) else "") for i in range(0, len(texts), 6)]
        lines.append(end)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
