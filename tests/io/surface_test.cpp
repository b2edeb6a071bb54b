#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "circumball/io.h"
#include "io_test_util.h"

namespace circumball {
namespace {

using io_test::names;
using io_test::put;

using Quads = std::vector<std::array<int, 4>>;

/// The corners of the grid {0, 1, … n}^3, and the quadrilaterals of the surface of the cells for
/// which `solid` holds, counter-clockwise from outside.
struct Voxels {
  std::vector<Point3> vertices;
  Quads quads;
};

template <class Solid>
Voxels voxels(int n, Solid solid) {
  Voxels out;
  std::vector<int> number(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)), -1);
  const auto vertex = [&](const int* p) {
    int& v = number[static_cast<std::size_t>((p[2] * (n + 1) + p[1]) * (n + 1) + p[0])];
    if (v < 0) {
      v = static_cast<int>(out.vertices.size());
      out.vertices.push_back({double(p[0]), double(p[1]), double(p[2])});
    }
    return v;
  };
  const auto inside = [&](const int* p) {
    for (int k = 0; k < 3; ++k)
      if (p[k] < 0 || p[k] >= n) return false;
    return static_cast<bool>(solid(p[0], p[1], p[2]));
  };
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z)
        for (int axis = 0; axis < 3; ++axis)
          for (int way = -1; way <= 1; way += 2) {
            int cell[3] = {x, y, z}, beside[3] = {x, y, z};
            beside[axis] += way;
            if (!inside(cell) || inside(beside)) continue;
            const int b = (axis + 1) % 3, c = (axis + 2) % 3;
            int p[3] = {x, y, z};
            if (way > 0) ++p[axis];
            std::array<int, 4> quad{};
            static constexpr int kAround[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
            for (int k = 0; k < 4; ++k) {
              int q[3] = {p[0], p[1], p[2]};
              q[b] += kAround[way > 0 ? k : 3 - k][0];
              q[c] += kAround[way > 0 ? k : 3 - k][1];
              quad[static_cast<std::size_t>(k)] = vertex(q);
            }
            out.quads.push_back(quad);
          }
  return out;
}

std::vector<std::array<int, 3>> triangles(const Quads& quads) {
  std::vector<std::array<int, 3>> out;
  for (const auto& q : quads) {
    out.push_back({q[0], q[1], q[2]});
    out.push_back({q[0], q[2], q[3]});
  }
  return out;
}

std::string off(const std::vector<Point3>& vertices, const std::vector<std::array<int, 3>>& faces) {
  std::string text =
      "OFF\n" + std::to_string(vertices.size()) + " " + std::to_string(faces.size()) + " 0\n";
  for (const Point3& p : vertices)
    text += format_double(p.x) + " " + format_double(p.y) + " " + format_double(p.z) + "\n";
  for (const auto& f : faces)
    text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " + std::to_string(f[2]) +
            "\n";
  return text;
}

std::string ascii_stl(const std::vector<Point3>& vertices,
                      const std::vector<std::array<int, 3>>& faces) {
  std::string text = "solid a thing\n";
  for (const auto& f : faces) {
    text += " facet normal 0 0 nan\n  outer loop\n";
    for (const int v : f) {
      const Point3& p = vertices[static_cast<std::size_t>(v)];
      text += "   VERTEX " + format_double(p.x) + " " + format_double(p.y) + " " +
              format_double(p.z) + "\n";
    }
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid a thing\n";
}

std::string binary_stl(const std::vector<Point3>& vertices,
                       const std::vector<std::array<int, 3>>& faces) {
  std::string text = "solid but binary" + std::string(64, ' ');
  const auto count = static_cast<std::uint32_t>(faces.size());
  put(&text, &count, 4);
  for (const auto& f : faces) {
    text += std::string(12, '\0');
    for (const int v : f) {
      const Point3& p = vertices[static_cast<std::size_t>(v)];
      for (const double x : {p.x, p.y, p.z}) {
        const auto single = static_cast<float>(x);
        put(&text, &single, 4);
      }
    }
    text += std::string(2, '\0');
  }
  return text;
}

/// Area of the faces, holes cut out, without their number: by fans of the loops, inner ones
/// negative.
double area(const Complex& c) {
  double sum = 0;
  for (const Face& face : c.faces) {
    Point3 normal;
    for (const auto& loop : face.loops)
      for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
        const Point3 &p = c.vertices[loop[0]], &q = c.vertices[loop[i]],
                     &r = c.vertices[loop[i + 1]];
        normal.x += (q.y - p.y) * (r.z - p.z) - (q.z - p.z) * (r.y - p.y);
        normal.y += (q.z - p.z) * (r.x - p.x) - (q.x - p.x) * (r.z - p.z);
        normal.z += (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
      }
    // All faces of these solids are parallel to two axes.
    sum += std::abs(normal.x + normal.y + normal.z) / 2;
  }
  return sum;
}

TEST(MergedFaces, ACubeHasSixFacesWhateverTheFormat) {
  const Voxels cube = voxels(2, [](int, int, int) { return true; });
  const auto faces = triangles(cube.quads);
  ASSERT_EQ(faces.size(), 48u);
  for (const std::string& text : {off(cube.vertices, faces), ascii_stl(cube.vertices, faces),
                                  binary_stl(cube.vertices, faces)}) {
    const ReadResult r = read(text, "a");
    EXPECT_EQ(names(r), "(merged)");
    EXPECT_EQ(r.complex.vertices.size(), 26u);
    ASSERT_EQ(r.complex.faces.size(), 6u);
    EXPECT_EQ(r.complex.segments.size(), 24u);
    EXPECT_EQ(area(r.complex), 24);
    for (const Face& face : r.complex.faces) {
      ASSERT_EQ(face.loops.size(), 1u);
      EXPECT_EQ(face.loops[0].size(), 8u);
      EXPECT_EQ(face.vertices.size(), 1u);  // the middle, which no loop has
    }
  }
  ReadOptions each;
  each.merge_coplanar = false;
  EXPECT_EQ(read(off(cube.vertices, faces), "a", nullptr, each).complex.faces.size(), 48u);
}

TEST(MergedFaces, HolesAreLoopsWithAPointInEach) {
  // A plate of 5 x 5 cells with two holes through it, one of them L-shaped.
  const Voxels plate = voxels(5, [](int x, int y, int z) {
    return z == 0 && !(x == 1 && y == 1) && !(x == 3 && y >= 2 && y <= 3) && !(x == 2 && y == 3);
  });
  const ReadResult r = read(off(plate.vertices, triangles(plate.quads)), "a.off");
  ASSERT_EQ(names(r), "(merged)");
  std::size_t with_holes = 0;
  for (const Face& face : r.complex.faces) {
    EXPECT_EQ(face.loops.size(), face.holes.size() + 1);
    if (face.holes.empty()) continue;
    ++with_holes;
    ASSERT_EQ(face.holes.size(), 2u);
    for (const Point3& hole : face.holes) {
      const int x = static_cast<int>(hole.x), y = static_cast<int>(hole.y);
      EXPECT_TRUE((x == 1 && y == 1) || (x == 3 && (y == 2 || y == 3)) || (x == 2 && y == 3))
          << hole.x << " " << hole.y;
    }
  }
  EXPECT_EQ(with_holes, 2u);
  EXPECT_EQ(r.complex.faces.size(), 6u + 4 + 6);
  EXPECT_EQ(area(r.complex), static_cast<double>(plate.quads.size()));
}

TEST(MergedFaces, AHoleThatTouchesTheBorderInAVertexIsALoopOfItsOwn) {
  // The hole's corner (1, 1) and the notch meet in one vertex.
  const Voxels plate =
      voxels(4, [](int x, int y, int z) { return z == 0 && !(x == 1 && y == 1) && !(x + y == 0); });
  const ReadResult r = read(off(plate.vertices, triangles(plate.quads)), "a.off");
  for (const Face& face : r.complex.faces)
    for (const auto& loop : face.loops) {
      std::vector<std::uint32_t> sorted = loop;
      std::sort(sorted.begin(), sorted.end());
      EXPECT_EQ(std::adjacent_find(sorted.begin(), sorted.end()), sorted.end());
    }
  EXPECT_EQ(area(r.complex), static_cast<double>(plate.quads.size()));
}

TEST(MergedFaces, RandomSolidsKeepTheirAreaAndTheirSides) {
  io_test::SplitMix64 random(3);
  for (int round = 0; round < 60; ++round) {
    bool full[4][4][4];
    for (auto& plane : full)
      for (auto& row : plane)
        for (bool& cell : row) cell = random.below(3) > 0;
    const Voxels solid = voxels(4, [&](int x, int y, int z) { return full[x][y][z]; });
    std::vector<std::array<int, 3>> faces = triangles(solid.quads);
    for (auto& f : faces)  // nobody promises that neighbors turn alike
      if (round % 2 && random.below(2)) std::swap(f[0], f[1]);
    const ReadResult r = read(off(solid.vertices, faces), "a.off");
    ASSERT_TRUE(r.ok()) << names(r);
    EXPECT_EQ(area(r.complex), static_cast<double>(solid.quads.size())) << round;
    for (const Face& face : r.complex.faces) {
      EXPECT_EQ(face.loops.size(), face.holes.size() + 1);
      for (const std::uint32_t s : face.segments) EXPECT_LT(s, r.complex.segments.size());
    }
  }
}

TEST(MergedFaces, WhatAThirdTriangleStandsOnIsASegmentInTheFace) {
  // A fan of four triangles around the middle of a square; a fin on one spoke.
  const std::vector<Point3> vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0},
                                        {0, 2, 0}, {1, 1, 0}, {1, 1, 1}};
  const ReadResult r =
      read(off(vertices, {{0, 1, 4}, {1, 2, 4}, {3, 2, 4}, {3, 0, 4}, {0, 4, 5}}), "a.off");
  ASSERT_EQ(names(r), "(merged)");
  ASSERT_EQ(r.complex.faces.size(), 2u);
  const Face& square = r.complex.faces[0];
  EXPECT_EQ(square.loops.size(), 1u);
  EXPECT_EQ(square.loops[0].size(), 4u);
  ASSERT_EQ(square.segments.size(), 1u);
  EXPECT_EQ(r.complex.segments[square.segments[0]], (std::array<std::uint32_t, 2>{0, 4}));
  EXPECT_TRUE(square.vertices.empty());
}

TEST(MergedFaces, NeighborsThatAreNotExactlyCoplanarOrOverlapStayApart) {
  const std::vector<Point3> vertices = {{0, 0, 0},      {1, 0, 0},     {0, 1, 0},
                                        {1, 1, 1e-300}, {1, 1, 1e-40}, {.25, .25, 0}};
  EXPECT_EQ(read(off(vertices, {{0, 1, 2}, {1, 4, 2}}), "a").complex.faces.size(), 2u);
  EXPECT_EQ(read(off(vertices, {{0, 1, 2}, {1, 3, 2}}), "a").complex.faces.size(), 2u);
  EXPECT_EQ(read(off(vertices, {{0, 1, 2}, {1, 5, 2}, {0, 1, 4}}), "a").complex.faces.size(), 3u);
}

TEST(Weld, MovesVerticesOntoTheFirstThatIsNear) {
  const std::vector<Point3> vertices = {{0, 0, 0},       {1, 0, 0},     {0, 1, 0},
                                        {1e-7, 0, 1e-7}, {1, 1e-7, 0.}, {0.5, 0.5, 1.0001},
                                        {0, -0.0, 0}};
  const std::string text = off(vertices, {{0, 1, 2}, {3, 4, 5}, {0, 6, 1}});
  const auto at = [&](double tolerance) {
    ReadOptions options;
    options.weld = tolerance;
    return read(text, "a.off", nullptr, options);
  };
  EXPECT_EQ(read(text, "a.off").complex.vertices.size(), 7u);
  EXPECT_EQ(names(at(0)), "(ignored)");  // the third triangle has two corners left
  EXPECT_EQ(at(0).complex.vertices.size(), 6u);
  EXPECT_EQ(at(0).complex.faces.size(), 2u);
  const ReadResult welded = at(1e-6);
  EXPECT_EQ(names(welded), "(welded) (ignored)");
  EXPECT_EQ(welded.complex.vertices.size(), 4u);
  EXPECT_EQ(welded.complex.faces[1].loops[0], (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(Weld, IsTheSameAsByBruteForce) {
  io_test::SplitMix64 random(8);
  std::vector<Point3> vertices;
  for (int i = 0; i < 300; ++i)
    vertices.push_back({random.unit() - .5, random.unit() - .5, random.unit() / 8});
  for (const double tolerance : {0.01, 0.05, 0.3}) {
    std::vector<Point3> kept;
    for (const Point3& p : vertices)
      if (std::none_of(kept.begin(), kept.end(), [&](const Point3& q) {
            const double x = p.x - q.x, y = p.y - q.y, z = p.z - q.z;
            return x * x + y * y + z * z <= tolerance * tolerance;
          }))
        kept.push_back(p);
    ReadOptions options;
    options.weld = tolerance;
    EXPECT_EQ(read(off(vertices, {{0, 1, 2}}), "a", nullptr, options).complex.vertices, kept);
  }
}

/// A tetrahedron with a line and other data, in one of the encodings.
std::string ply(const std::string& encoding) {
  const bool ascii = encoding == "ascii", big = encoding == "binary_big_endian";
  std::string text = "ply\nformat " + encoding +
                     " 1.0\ncomment nothing\nelement material 1\nproperty uchar red\n"
                     "element vertex 5\nproperty double x\nproperty uchar u\nproperty float y\n"
                     "property short z\nelement face 4\nproperty list uchar int vertex_indices\n"
                     "property list ushort double other\nelement edge 1\nproperty int vertex1\n"
                     "property int vertex2\nend_header\n";
  const auto number = [&](double value, const char* type) {
    if (ascii) {
      text += format_double(value) + " ";
    } else if (*type == 'd') {
      put(&text, &value, 8, big);
    } else if (*type == 'f') {
      const auto single = static_cast<float>(value);
      put(&text, &single, 4, big);
    } else {
      const auto integer = static_cast<std::int32_t>(value);
      const std::size_t size = *type == 'c' ? 1 : *type == 's' ? 2 : 4;
      put(&text, &integer, size, big);  // of a little-endian machine
    }
  };
  const auto end = [&] {
    if (ascii) text += "\n";
  };
  number(7, "c");
  end();
  const double points[5][3] = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.5, 0}, {0, 0, -3}, {1.0 / 3, 1, 300}};
  for (const auto& p : points) {
    number(p[0], "double"), number(255, "c"), number(p[1], "float"), number(p[2], "short");
    end();
  }
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for (const auto& f : faces) {
    number(3, "c");
    for (const int v : f) number(v, "i");
    number(2, "short"), number(0.5, "double"), number(0.25, "double");
    end();
  }
  number(3, "i"), number(4, "i");
  end();
  return text;
}

TEST(Ply, AllEncodingsHoldTheSame) {
  for (const char* encoding : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string text = ply(encoding);
    const ReadResult r = read(text, "a.ply");
    ASSERT_EQ(names(r), "(ignored)") << encoding;
    EXPECT_EQ(r.format, "ply");
    EXPECT_EQ(
        r.complex.vertices,
        (std::vector<Point3>{{0, 0, 0}, {0.1, 0, 0}, {0, 0.5, 0}, {0, 0, -3}, {1.0 / 3, 1, 300}}));
    EXPECT_EQ(r.complex.faces.size(), 4u);
    EXPECT_EQ(r.complex.segments.size(), 7u);
    EXPECT_EQ(r.complex.segments[0], (std::array<std::uint32_t, 2>{3, 4}));
    for (std::size_t cut = 0; cut + 4 < text.size(); cut += 3) {
      const ReadResult part = read(text.substr(0, cut), "a.ply");
      EXPECT_FALSE(part.ok()) << encoding << " " << cut;
    }
  }
}

TEST(Ply, InThePlaneTrianglesAreCells) {
  const ReadResult r = read(
      "ply\r\nformat ascii 1.0\r\nelement vertex 3\r\nproperty float x\r\nproperty float y\r\n"
      "element face 1\r\nproperty list uchar int vertex_index\r\nend_header\r\n0 0\n1 0\n0 1\n3 0 "
      "1 "
      "2\n",
      "a");
  ASSERT_TRUE(r.ok()) << names(r);
  EXPECT_EQ(r.complex.dimension, 2);
  EXPECT_EQ(r.mesh->cells.size(), 3u);
}

TEST(SurfaceMalformed, EachFileHasItsNamedDefect) {
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\n";
  const std::pair<std::string, std::string> cases[] = {
      {"ply\nformat ascii 1.0\n", "truncated"},
      {"ply\nformat braille 1.0\nend_header\n", "unsupported"},
      {header + "end_header\n1\n", "unsupported"},
      {header + "property int y\nend_header\n1 2\n", ""},
      {header + "property int y\nend_header\n1 x\n", "truncated"},
      {header + "property what y\nend_header\n1 2\n", "syntax"},
      {header + "property int y\nelement face 999999\nproperty list int int "
                "vertex_indices\nend_header\n1 2\n",
       "truncated"},
      {header + "property int y\nelement face 1\nproperty list int int "
                "vertex_indices\nend_header\n1 2\n-5 2\n",
       "truncated"},
      {header + "property int y\nelement face 1\nproperty list int int "
                "vertex_indices\nend_header\n1 2\n1 0\n",
       "syntax"},
      {"ply\nformat ascii 1.0\nend_header\n", "empty"},
      {"solid\nendsolid\n", "empty"},
      {"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "truncated"},
      {"solid\nvertex 0 0 0\nendsolid\n", "syntax"},
      {"solid\nouter loop\nvertex 0 0\nendsolid\n", "syntax"},
      {"solid\nouter loop\nendloop\nendsolid\n", "syntax"},
      {"solid\nhello\nendsolid\n", "syntax"},
      {"COFF\n3 1 0\n0 0 1 255 0 0\n1 0 1 255 0 0\n0 1 1 0 0 0\n3 0 1 2 255 0 0\n", ""},
      {std::string(80, ' ') + std::string("\x02\0\0\0", 4) + std::string(50, '\0'),
       "unknown-format"},
  };
  for (const auto& [text, name] : cases) EXPECT_EQ(names(read(text, "a")), name) << text;
}

}  // namespace
}  // namespace circumball
