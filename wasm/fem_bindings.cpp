// The laboratory of chapter 7 for JavaScript; see bindings.cpp for what may cross.
#include <emscripten/bind.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "circumball/fem_laboratory.h"
#include "circumball/io.h"
#include "circumball/report.h"
#include "json_face.h"
#include "session.h"

namespace circumball {

namespace {

constexpr const char* kNoMemory = "there is not enough memory";

template <class Numbers>
val numbers(const Numbers& list) {
  val result = val::array();
  for (const double x : list) result.call<void>("push", x);
  return result;
}
val point(const Point2& p) { return numbers(std::array<double, 2>{p.x, p.y}); }

val seminorms(const Seminorms& u) {
  val result = val::object();
  result.set("l2", u.l2);
  result.set("h1", u.h1);
  result.set("h2", u.h2);
  return result;
}

val functions() {
  val list = val::array();
  for (const NamedFunction& f : fem_functions()) {
    val entry = val::object();
    entry.set("id", f.id);
    entry.set("title", f.title);
    entry.set("expression", f.expression);
    entry.set("sentence", f.sentence);
    entry.set("regularity", f.regularity);
    val outline = val::array();
    for (const Point2& p : f.outline) outline.call<void>("push", point(p));
    entry.set("outline", outline);
    entry.set("zeroOnBoundary", f.zero_on_boundary);
    list.call<void>("push", entry);
  }
  return list;
}

val families() {
  val list = val::array();
  for (const FamilyInfo& f : mesh_families()) {
    val entry = val::object();
    entry.set("id", f.id);
    entry.set("title", f.title);
    entry.set("sentence", f.sentence);
    list.call<void>("push", entry);
  }
  return list;
}

val family_answer(const std::string& error, const val& mesh) {
  val result = val::object();
  result.set("ok", error.empty());
  result.set("error", error);
  result.set("mesh", mesh);
  return result;
}

/// A count that JavaScript gave; 0 for what is none.
std::uint32_t count(double x) { return x >= 1 && x <= 4e9 ? static_cast<std::uint32_t>(x) : 0; }

val family(const std::string& id, double n, double degeneration) {
  try {
    for (const FamilyInfo& f : mesh_families()) {
      if (f.id != id) continue;
      std::string error;
      const Mesh mesh = family_mesh(f.family, count(n), count(degeneration), &error);
      return family_answer(error, error.empty() ? mesh_arrays(mesh) : val::null());
    }
    return family_answer("there is no family '" + id + "'", val::null());
  } catch (...) {
    return family_answer(kNoMemory, val::null());
  }
}

/// The members of `FemField`.
val field_answer(const ErrorField& field) {
  const bool ok = field.error.empty();
  val size = val::object();
  size.set("vertices", static_cast<double>(field.size.vertices));
  size.set("cells", static_cast<double>(field.size.cells));
  size.set("flatCells", static_cast<double>(field.size.flat_cells));
  size.set("h", field.size.h);
  size.set("maxCircumradius", field.size.max_circumradius);
  size.set("minAngle", field.size.min_angle_degrees);
  size.set("maxAngle", field.size.max_angle_degrees);
  size.set("area", field.size.area);
  val result = val::object();
  result.set("ok", ok);
  result.set("error", field.error);
  result.set("warning", field.warning);
  result.set("size", size);
  result.set("l2", field.l2);
  result.set("h1", field.h1);
  result.set("u", seminorms(field.u));
  result.set("nodal", copied(field.nodal));
  result.set("cellL2", copied(field.cell_l2));
  result.set("cellH1", copied(field.cell_h1));
  result.set("points", static_cast<double>(field.points));
  result.set("unsettledCells", static_cast<double>(field.unsettled_cells));
  return result;
}
val answer(const ErrorField& field) { return field_answer(field); }
val answer(const PoissonSolution& solution) {
  val result = field_answer(solution);
  result.set("unknowns", static_cast<double>(solution.unknowns));
  result.set("factorEntries", static_cast<double>(solution.factor_entries));
  result.set("weakLoad", solution.weak_load);
  return result;
}
val answer(const AveragedField& field) {
  val result = field_answer(field);
  result.set("averagingRadius", field.averaging_radius);
  return result;
}

/// The mesh of a run, or of arrays that the wrapper has seen to.
Mesh mesh_from(const val& source, std::string* error) {
  Mesh mesh;
  if (source.isNumber()) {
    const Session* session = find(source.as<int>());
    if (session) return session->run->mesh();
    *error = "there is no such run";
    return mesh;
  }
  mesh.dimension = source["dimension"].as<int>();
  if (mesh.dimension != 2) return mesh;  // what is wrong is said later
  const auto coordinates = emscripten::convertJSArrayToNumberVector<double>(source["vertices"]);
  mesh.cells = emscripten::convertJSArrayToNumberVector<std::uint32_t>(source["cells"]);
  for (std::size_t i = 0; i + 1 < coordinates.size(); i += 2) {
    mesh.vertices.push_back({coordinates[i], coordinates[i + 1], 0});
  }
  return mesh;
}

/// Reads mesh and function, and answers with what `measure` makes of them.
template <class Field, class Measure>
val measured(const val& source, const std::string& expression, Measure measure) {
  Field field;
  try {
    PlaneFunction u;
    if (PlaneFunction::parse(expression, &u, &field.error)) {
      const Mesh mesh = mesh_from(source, &field.error);
      if (field.error.empty()) field = measure(mesh, u);
    }
  } catch (...) {
    field = Field();
    field.error = kNoMemory;
  }
  return answer(field);
}

val interpolated(const val& mesh, const std::string& expression) {
  return measured<ErrorField>(mesh, expression, interpolate);
}
val poisson(const val& mesh, const std::string& expression) {
  return measured<PoissonSolution>(
      mesh, expression, [](const Mesh& m, const PlaneFunction& u) { return solve_poisson(m, u); });
}
val averaged(const val& mesh, const std::string& expression, double h) {
  return measured<AveragedField>(mesh, expression, [h](const Mesh& m, const PlaneFunction& u) {
    return interpolate_averaged(m, u, h);
  });
}

val triangle(double ax, double ay, double bx, double by, double cx, double cy,
             const std::string& expression) {
  PlaneFunction u;
  std::string error;
  const bool given = !expression.empty();
  const bool understood = given && PlaneFunction::parse(expression, &u, &error);
  const TriangleStudy t = study_triangle({ax, ay}, {bx, by}, {cx, cy}, understood ? &u : nullptr);
  val result = val::object();
  result.set("ok", t.error.empty());
  result.set("error", t.error);
  result.set("lengths", numbers(t.lengths));
  result.set("angles", numbers(t.angles_degrees));
  result.set("h", t.h);
  result.set("area", t.area);
  result.set("circumradius", t.circumradius);
  result.set("inradius", t.inradius);
  result.set("radiusEdge", t.radius_edge);
  result.set("circumcenter", point(t.circumcenter));
  result.set("alpha", t.alpha);
  result.set("beta", t.beta);
  result.set("circumradiusBound", t.circumradius_bound);
  result.set("h1Constant", t.h1_constant);
  result.set("l2Constant", t.l2_constant);
  result.set("worstQuadratic", numbers(t.worst_quadratic));
  result.set("kobayashiBound", t.kobayashi_bound);
  val interpolation = val::null();
  if (t.interpolation) {
    interpolation = val::object();
    interpolation.set("l2", t.interpolation->l2);
    interpolation.set("h1", t.interpolation->h1);
    interpolation.set("u", seminorms(t.interpolation->u));
  }
  result.set("interpolation", interpolation);
  result.set("interpolationError", given && !understood ? error : t.interpolation_error);
  return result;
}

val study_answer(const std::string& error, const std::vector<Defect>& defects,
                 const std::string& status) {
  val result = val::object();
  result.set("ok", error.empty() && defects.empty());
  result.set("error", error);
  result.set("defects", defects_json(defects));
  result.set("status", status);
  result.set("mesh", val::null());
  result.set("interpolation", val::null());
  result.set("poisson", val::null());
  return result;
}

val study(const std::string& complex, const std::string& options_text,
          const std::string& expression, double size) {
  const std::string none = name(Status::kCancelled);
  try {
    std::string error;
    PlaneFunction u;
    if (!PlaneFunction::parse(expression, &u, &error)) return study_answer(error, {}, none);
    const ReadResult input = read(complex, "input.json");
    if (!input.ok()) return study_answer("", input.defects, none);
    Options options;
    options.limits.max_vertices = 200'000;
    if (!options_from_json(options_text, &options, &error)) return study_answer(error, {}, none);
    if (!(size > 0) || std::isinf(size)) {
      return study_answer("the size of a study is a positive number", {}, none);
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", size);
    options.size = text;
    std::vector<Defect> defects;
    const auto run = Run::create(input.complex, options, nullptr, &defects, &error);
    if (!run) return study_answer(error, defects, none);
    run->advance();
    const Mesh mesh = run->mesh();
    val result = study_answer("", {}, name(run->status()));
    result.set("mesh", mesh_arrays(mesh));
    result.set("interpolation", answer(interpolate(mesh, u)));
    result.set("poisson", answer(solve_poisson(mesh, u)));
    return result;
  } catch (...) {
    return study_answer(kNoMemory, {}, none);
  }
}

}  // namespace

EMSCRIPTEN_BINDINGS(circumball_fem) {
  emscripten::function("femFunctions", &functions);
  emscripten::function("femFamilies", &families);
  emscripten::function("femFamily", &family);
  emscripten::function("femInterpolate", &interpolated);
  emscripten::function("femPoisson", &poisson);
  emscripten::function("femAveraged", &averaged);
  emscripten::function("femTriangle", &triangle);
  emscripten::function("femStudy", &study);
}

}  // namespace circumball
