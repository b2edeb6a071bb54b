"""What the generators of the examples in space share: a complex that is put together, and its file."""

import json
import math
import os

HERE = os.path.dirname(os.path.abspath(__file__))


class Complex:
    """Vertices, segments and faces; sides of faces are segments, shared sides once."""

    def __init__(self):
        self.vertices, self.segments, self.faces = [], [], []

    def vertex(self, *p):
        self.vertices.append([c + 0.0 for c in p])
        return len(self.vertices) - 1

    def add(self, points):
        return [self.vertex(*p) for p in points]

    def segment(self, a, b):
        for i, s in enumerate(self.segments):
            if set(s) == {a, b}:
                return i
        self.segments.append([a, b])
        return len(self.segments) - 1

    def face(self, *loops, holes=(), segments=(), vertices=()):
        for loop in loops:
            for i, v in enumerate(loop):
                self.segment(v, loop[(i + 1) % len(loop)])
        face = {"loops": [list(loop) for loop in loops]}
        if holes:
            face["holes"] = [list(h) for h in holes]
        if segments:
            face["segments"] = [self.segment(a, b) for a, b in segments]
        if vertices:
            face["vertices"] = list(vertices)
        self.faces.append(face)

    def free_points(self, center, half_width):
        """The surface of a 3x3x3 grid: 26 vertices of no segment, as a box around the rest."""
        steps = (-half_width, 0.0, half_width)
        for z in steps:
            for y in steps:
                for x in steps:
                    if x or y or z:
                        self.vertex(center[0] + x, center[1] + y, center[2] + z)

    def write(self, name, **more):
        lines = ['{"circumball": 1, "dimension": 3,']
        lists = {"vertices": self.vertices, "segments": self.segments, "faces": self.faces, **more}
        lists = {key: value for key, value in lists.items() if value}
        for key, value in lists.items():
            texts, line = [json.dumps(item) for item in value], ""
            lines.append(f'"{key}": [')
            for i, text in enumerate(texts):
                text += "," if i + 1 < len(texts) else ""
                if line and len(line) + len(text) > 110:
                    lines.append(line)
                    line = ""
                line += (" " if line else "") + text
            lines.append(line + ("]," if key != list(lists)[-1] else "]}"))
        with open(os.path.join(HERE, name), "w", encoding="utf-8") as file:
            file.write("\n".join(lines) + "\n")


def square(half, z, center=(0.0, 0.0)):
    """Corners of a horizontal square, counter-clockwise from above."""
    return [(center[0] + half * sx, center[1] + half * sy, z) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1))]


def direction(degrees):
    return math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
