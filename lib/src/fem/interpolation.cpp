#include <cmath>

#include "fem/elements.h"

namespace circumball {

ErrorField interpolate(const Mesh& mesh, const PlaneFunction& u) {
  ErrorField field;
  field.error = fem::unusable(mesh);
  if (!field.error.empty()) return field;
  field.nodal.assign(mesh.vertices.size(), 0);
  for (const std::uint32_t v : mesh.cells) {
    const Point2 p = xy(mesh.vertices[v]);
    field.nodal[v] = u.at(p);
    if (!std::isfinite(field.nodal[v])) {
      field.error = "u has no finite value at the vertex " + fem::place(p) +
                    ": interpolation needs one (averaged interpolation does not)";
      return field;
    }
  }
  fem::measure_error(mesh, u, &field);
  return field;
}

}  // namespace circumball
