// Figure 7.1 of the thesis survives as its captions only; these meshes are what those say.

#include "circumball/fem_laboratory.h"

namespace circumball {
namespace {

/// Builds a mesh of the unit square from points and triangles, and then finds its border.
class SquareMesh {
 public:
  SquareMesh() { mesh_.dimension = 2; }
  std::uint32_t add(double x, double y) {
    mesh_.vertices.push_back({x, y, 0});
    return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
  }
  /// Counter-clockwise.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.cells.insert(mesh_.cells.end(), {a, b, c});
  }
  /// An edge of the border, on side 0 (below), 1 (right), 2 (above) or 3 (left).
  void border(std::uint32_t a, std::uint32_t b, std::uint32_t side) {
    mesh_.edges.push_back({a, b, side});
  }
  Mesh take() { return std::move(mesh_); }

 private:
  Mesh mesh_;
};

/// (a) Right triangles, 1/n wide and 1/(n k) high.
Mesh narrow(std::uint32_t n, std::uint32_t k) {
  SquareMesh mesh;
  const std::uint32_t rows = n * k, width = n + 1;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i <= n; ++i) mesh.add(double(i) / n, double(j) / rows);
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = j * width + i, b = a + 1, d = a + width, c = d + 1;
      mesh.triangle(a, b, c);
      mesh.triangle(a, c, d);
    }
    mesh.border(j * width + n, (j + 1) * width + n, 1);
    mesh.border((j + 1) * width, j * width, 3);
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    mesh.border(i, i + 1, 0);
    mesh.border(rows * width + i + 1, rows * width + i, 2);
  }
  return mesh.take();
}

/// (b) Rows 1/(n k) high, every second one shifted by half a column: isosceles triangles with base
/// 1/n, whose apex lies over the middle of the base.
Mesh large_angles(std::uint32_t n, std::uint32_t k) {
  SquareMesh mesh;
  const std::uint32_t rows = n * k;
  std::vector<std::vector<std::uint32_t>> row(rows + 1);
  for (std::uint32_t j = 0; j <= rows; ++j) {
    const double y = double(j) / rows;
    if (j % 2 == 0) {
      for (std::uint32_t i = 0; i <= n; ++i) row[j].push_back(mesh.add(double(i) / n, y));
    } else {
      row[j].push_back(mesh.add(0, y));
      for (std::uint32_t i = 0; i < n; ++i) row[j].push_back(mesh.add((i + 0.5) / n, y));
      row[j].push_back(mesh.add(1, y));
    }
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    // `even` has the vertices at the ends of the columns, `odd` those at their middles.
    const bool up = j % 2 == 0;
    const auto& even = up ? row[j] : row[j + 1];
    const auto& odd = up ? row[j + 1] : row[j];
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (up) {
        mesh.triangle(a, b, c);
      } else {
        mesh.triangle(a, c, b);
      }
    };
    for (std::uint32_t i = 0; i < n; ++i) triangle(even[i], even[i + 1], odd[i + 1]);
    for (std::uint32_t i = 0; i <= n; ++i) triangle(even[i], odd[i + 1], odd[i]);
    mesh.border(row[j].back(), row[j + 1].back(), 1);
    mesh.border(row[j + 1].front(), row[j].front(), 3);
  }
  for (std::size_t i = 0; i + 1 < row[0].size(); ++i) mesh.border(row[0][i], row[0][i + 1], 0);
  for (std::size_t i = 0; i + 1 < row[rows].size(); ++i) {
    mesh.border(row[rows][i + 1], row[rows][i], 2);
  }
  return mesh.take();
}

/// (c) n by n squares; on every second vertical line each of their sides is divided into k pieces,
/// which are seen from the nearer of the two vertices across.
Mesh high_degree(std::uint32_t n, std::uint32_t k) {
  SquareMesh mesh;
  std::vector<std::vector<std::uint32_t>> line(n + 1);
  for (std::uint32_t i = 0; i <= n; ++i) {
    const std::uint32_t pieces = i % 2 == 1 ? n * k : n;
    for (std::uint32_t j = 0; j <= pieces; ++j) {
      line[i].push_back(mesh.add(double(i) / n, double(j) / pieces));
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const bool right = i % 2 == 0;  // the divided line is to the right
    const auto& coarse = right ? line[i] : line[i + 1];
    const auto& fine = right ? line[i + 1] : line[i];
    const auto triangle = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
      if (right) {
        mesh.triangle(a, b, c);
      } else {
        mesh.triangle(a, c, b);
      }
    };
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::uint32_t half = k / 2;
      for (std::uint32_t m = 0; m < k; ++m) {
        triangle(coarse[m < half ? j : j + 1], fine[j * k + m], fine[j * k + m + 1]);
      }
      triangle(coarse[j], fine[j * k + half], coarse[j + 1]);
    }
    mesh.border(line[i].front(), line[i + 1].front(), 0);
    mesh.border(line[i + 1].back(), line[i].back(), 2);
  }
  for (std::size_t j = 0; j + 1 < line[n].size(); ++j) mesh.border(line[n][j], line[n][j + 1], 1);
  for (std::size_t j = 0; j + 1 < line[0].size(); ++j) mesh.border(line[0][j + 1], line[0][j], 3);
  return mesh.take();
}

}  // namespace

const std::vector<FamilyInfo>& mesh_families() {
  static const std::vector<FamilyInfo> families{
      {MeshFamily::kNarrow, "narrow", "Narrow, without large angles",
       "Figure 7.1(a): right triangles become needles, and the error in H1 stays below a multiple "
       "of h."},
      {MeshFamily::kLargeAngles, "large-angles", "Narrow, with large angles",
       "Figure 7.1(b): the largest angle tends to 180 degrees, and the error in H1 grows like the "
       "circumradius."},
      {MeshFamily::kHighDegree, "high-degree", "Narrow, with high degrees",
       "Figure 7.1(c): ever more triangles meet at a vertex, no angle is large, and the error in "
       "H1 stays below a multiple of h."},
  };
  return families;
}

Mesh family_mesh(MeshFamily family, std::uint32_t n, std::uint32_t degeneration,
                 std::string* error) {
  const std::uint64_t cells = family == MeshFamily::kHighDegree
                                  ? std::uint64_t{n} * n * (std::uint64_t{degeneration} + 1)
                                  : (2 * std::uint64_t{n} + 1) * n * degeneration;
  // The first three conditions keep the products within 64 bits.
  if (n == 0 || degeneration == 0 || n > kMaxFamilyCells || degeneration > kMaxFamilyCells ||
      std::uint64_t{n} * n > kMaxFamilyCells || cells > kMaxFamilyCells) {
    *error = "a mesh of the family has between 1 and " + std::to_string(kMaxFamilyCells) +
             " triangles: choose other numbers of columns and of the degeneration";
    return {};
  }
  error->clear();
  switch (family) {
    case MeshFamily::kNarrow:
      return narrow(n, degeneration);
    case MeshFamily::kLargeAngles:
      return large_angles(n, degeneration);
    case MeshFamily::kHighDegree:
      return high_degree(n, degeneration);
  }
  *error = "there is no such family";
  return {};
}

}  // namespace circumball
