#include <cstring>

#include "quality/context.h"
#include "quality/context3.h"

namespace circumball {

template <class Context>
Check check_input_vertices(const Context& context) {
  Check check;
  check.name = "input-vertices";
  check.bound = 0;
  const auto same_bits = [](double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  std::size_t missing = 0, elsewhere = 0;
  const auto fail = [&](std::uint32_t v, const std::string& why) {
    if (missing++ > 0) return;
    check.worst = {v};
    check.detail = "input vertex " + std::to_string(v) + " " + why;
  };
  for (std::uint32_t i = 0; i < context.complex.vertices.size(); ++i) {
    const Point3& p = context.complex.vertices[i];
    if (context.by_number) {
      const Point3& q = context.mesh.vertices[i];
      if (!same_bits(p.x, q.x) || !same_bits(p.y, q.y) ||
          (context.complex.dimension == 3 && !same_bits(p.z, q.z))) {
        fail(i, "has moved");
        continue;
      }
    }
    const std::uint32_t v = context.mesh_vertex[i];
    if (v == kNoIndex) {
      // A vertex that the domain does not reach may be left out of a mesh with its own numbering.
      if (context.vertex_wanted[i])
        fail(i, "is not in the mesh");
      else
        ++elsewhere;
      continue;
    }
    if (context.vertex_wanted[i] && !context.used[v] && !context.cells.empty())
      fail(i, "is not a vertex of any cell");
    if (!context.vertex_wanted[i]) ++elsewhere;
  }
  check.ok = missing == 0;
  check.observed = static_cast<double>(missing);
  if (!check.ok) {
    if (missing > 1) check.detail += " (" + std::to_string(missing) + " such)";
    return check;
  }
  check.detail = "all " + count_text(context.complex.vertices.size(), "input vertex") + " found " +
                 (context.by_number ? "under their numbers, bit for bit" : "by their coordinates");
  const std::string plural = "input vertexs";
  if (const std::size_t at = check.detail.find(plural); at != std::string::npos)
    check.detail.replace(at, plural.size(), "input vertices");
  if (elsewhere > 0) check.detail += "; " + std::to_string(elsewhere) + " outside the domain";
  return check;
}

template Check check_input_vertices(const VerifyContext&);
template Check check_input_vertices(const VerifyContext3&);

}  // namespace circumball
