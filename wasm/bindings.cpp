// The Embind module: text and typed arrays in, JSON text and typed arrays out. Whatever is handed
// out is a copy that the caller owns (a view would be detached when the memory grows), and no
// exception crosses: an uncaught one would arrive in JavaScript without a message. circumball.mjs
// turns the JSON text into objects.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstdint>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "circumball/io.h"
#include "circumball/predicates.h"
#include "circumball/refine.h"
#include "circumball/registry.h"
#include "circumball/report.h"
#include "json_face.h"
#include "session.h"

namespace circumball {

val mesh_arrays(const Mesh& mesh) {
  const std::size_t dimension = static_cast<std::size_t>(mesh.dimension);
  std::vector<double> coordinates;
  coordinates.reserve(mesh.vertices.size() * dimension);
  for (const Point3& p : mesh.vertices) {
    coordinates.push_back(p.x);
    coordinates.push_back(p.y);
    if (dimension == 3) coordinates.push_back(p.z);
  }
  std::vector<std::uint32_t> features, edges;
  for (const Feature& f : mesh.vertex_features) {
    features.push_back(static_cast<std::uint32_t>(f.kind));
    features.push_back(f.index);
  }
  for (const MeshEdge& e : mesh.edges) edges.insert(edges.end(), {e.a, e.b, e.segment});
  std::vector<std::uint32_t> facets;
  for (const MeshFacet& f : mesh.facets) facets.insert(facets.end(), {f.a, f.b, f.c, f.face});
  val result = val::object();
  result.set("dimension", mesh.dimension);
  result.set("inputVertices", mesh.input_vertices);
  result.set("boxVertices", mesh.box_vertices);
  result.set("vertices", copied(coordinates));
  result.set("cells", copied(mesh.cells));
  result.set("cellRegions", copied(mesh.cell_regions));
  result.set("vertexFeatures", copied(features));
  result.set("edges", copied(edges));
  result.set("facets", copied(facets));
  return result;
}

namespace {

val failure(const std::string& error) {
  val result = val::object();
  result.set("ok", false);
  result.set("error", error);
  result.set("files", val::array());
  return result;
}

val written(const std::vector<OutputFile>& files, const std::string& error) {
  if (files.empty()) return failure(error);
  val list = val::array();
  for (const OutputFile& file : files) {
    val entry = val::object();
    entry.set("extension", file.extension);
    entry.set("bytes", copied_bytes(file.bytes));
    list.call<void>("push", entry);
  }
  val result = val::object();
  result.set("ok", true);
  result.set("error", std::string());
  result.set("files", list);
  return result;
}

val read_files(val files) {
  return guarded(val::null(), [&] {
    const std::size_t count = files["length"].as<std::size_t>();
    std::map<std::string, std::string> siblings;
    std::string first_name, first_bytes;
    for (std::size_t i = 0; i < count; ++i) {
      const std::string name = files[i]["name"].as<std::string>();
      const std::string bytes = files[i]["bytes"].as<std::string>();
      if (i == 0) {
        first_name = name;
        first_bytes = bytes;
      }
      siblings.emplace(name, bytes);
    }
    ReadResult input = read(first_bytes, first_name, [&](const std::string& name) {
      const auto found = siblings.find(name);
      return found == siblings.end() ? std::nullopt : std::optional(found->second);
    });
    // What refers to nothing cannot be drawn or edited: then all that is wrong is told.
    if (input.ok() && !check_numbers(input.complex, 1).empty()) {
      for (Defect& defect : check(input.complex)) input.defects.push_back(std::move(defect));
      input.complex = Complex();
      input.mesh.reset();
    }
    std::string error;
    const std::vector<OutputFile> text = write_complex(input.complex, ".json", &error);
    val result = val::object();
    result.set("ok", input.ok());
    result.set("format", input.format);
    result.set("complex", text.empty() ? std::string() : text.front().bytes);
    result.set("mesh", input.mesh ? mesh_arrays(*input.mesh) : val::null());
    result.set("defects", defects_json(input.defects));
    return result;
  });
}

std::string check_text(const std::string& text) {
  try {
    const ReadResult input = read(text, "input.json");
    std::vector<Defect> defects = input.defects;
    if (input.ok()) {
      for (Defect& defect : check(input.complex)) defects.push_back(std::move(defect));
    }
    return defects_json(defects);
  } catch (const std::exception& error) {
    return defects_json({{"internal", {}, {}, error.what(), false}});
  }
}

val face_triangles(const std::string& text) {
  return guarded(copied(std::vector<std::uint32_t>()), [&] {
    const ReadResult input = read(text, "input.json");
    std::vector<std::uint32_t> triangles;
    if (!input.ok() || !check_numbers(input.complex, 1).empty()) return copied(triangles);
    for (std::uint32_t face = 0; face < input.complex.faces.size(); ++face) {
      for (const auto& [a, b, c] : triangulate_face(input.complex, face))
        triangles.insert(triangles.end(), {a, b, c, face});
    }
    return copied(triangles);
  });
}

val face_frames(const std::string& text) {
  return guarded(copied(std::vector<double>()), [&] {
    const ReadResult input = read(text, "input.json");
    std::vector<double> frames;
    if (!input.ok() || !check_numbers(input.complex, 1).empty()) return copied(frames);
    const double none = std::numeric_limits<double>::quiet_NaN();
    for (std::uint32_t face = 0; face < input.complex.faces.size(); ++face) {
      const FaceFrame frame =
          face_frame(input.complex, face).value_or(FaceFrame{{none, none, none}, {}, {}, {}});
      for (const Point3& p : {frame.origin, frame.first, frame.second, frame.normal})
        frames.insert(frames.end(), {p.x, p.y, p.z});
    }
    return copied(frames);
  });
}

val started(int id, const std::string& error, const std::vector<Defect>& defects) {
  const Session* session = find(id);
  val result = val::object();
  result.set("ok", session != nullptr);
  result.set("run", id);
  result.set("error", error);
  result.set("defects", defects_json(defects));
  val steps = val::array();
  if (session) {
    for (const std::string& step : session->run->step_names()) steps.call<void>("push", step);
  }
  result.set("steps", steps);
  result.set("tau", session ? session->run->tau() : 0.0);
  result.set("domain", std::string(session ? name(session->run->domain()) : ""));
  result.set("algorithm", session ? session->run->options().algorithm : std::string());
  return result;
}

val start(const std::string& complex, const std::string& options_text) {
  static int last_id = 0;
  try {
    ReadResult input = read(complex, "input.json");
    if (!input.ok()) return started(0, "", input.defects);
    Options options;
    std::string error;
    if (!options_from_json(options_text, &options, &error)) return started(0, error, {});
    const int id = ++last_id;
    Session& session = sessions()[id];
    session.input = std::move(input.complex);
    std::vector<Defect> defects;
    session.run = Run::create(session.input, options, &session.trace, &defects, &error);
    if (!session.run) {
      sessions().erase(id);
      return started(0, error, defects);
    }
    return started(id, error, defects);
  } catch (const std::exception& error) {
    return started(0, error.what(), {});
  }
}

val progress(const Session* session) {
  val result = val::object();
  const Progress now = session ? session->run->progress() : Progress();
  result.set("status", std::string(name(session ? session->run->status() : Status::kCancelled)));
  result.set("step", now.step);
  result.set("vertices", static_cast<double>(now.vertices));
  result.set("queued", static_cast<double>(now.queued));
  result.set("iterations", static_cast<double>(now.iterations));
  result.set("seconds", now.seconds);
  return result;
}

val advance(int id, double iterations, double seconds) {
  Session* session = find(id);
  try {
    if (session) session->run->advance(static_cast<std::uint64_t>(iterations), seconds);
  } catch (...) {
    session->run->cancel();  // out of memory: what is there stays, and the status says so
  }
  return progress(session);
}

val cancel(int id) {
  Session* session = find(id);
  if (session) {
    session->run->cancel();
    session->run->advance(1);  // the next iteration is what ends it
  }
  return progress(session);
}

val take_trace(int id) {
  Session* session = find(id);
  Trace empty;
  Trace& trace = session ? session->trace : empty;
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(trace.events.data());
  val result = val::object();
  result.set("events", copied(bytes, trace.events.size() * sizeof(Event)));
  result.set("simplices", copied(trace.simplices));
  val steps = val::array();
  if (session) {
    for (const std::string& step : session->run->step_names()) steps.call<void>("push", step);
  }
  result.set("steps", steps);
  // The page keeps the trace: recording it twice would double the memory of a long run.
  std::vector<Event>().swap(trace.events);
  std::vector<std::uint32_t>().swap(trace.simplices);
  return result;
}

val mesh_of(int id) {
  return guarded(val::null(), [&] {
    const Session* session = find(id);
    return session ? mesh_arrays(session->run->mesh()) : val::null();
  });
}

std::string report_of(int id, bool verified) {
  try {
    const Session* session = find(id);
    if (!session) return "null";
    const Mesh mesh = session->run->mesh();
    std::vector<Check> checks;
    if (verified) checks = verify(mesh, session->run->complex(), promised_checks(*session->run));
    ReportOptions options;
    options.worst_offenders = true;
    options.indent = -1;
    return report_json(*session->run, session->input, mesh, checks, options);
  } catch (...) {
    return "null";
  }
}

val write_run(int id, const std::string& extension) {
  return guarded(failure("out of memory"), [&] {
    const Session* session = find(id);
    if (!session) return failure("there is no such run");
    std::string error;
    const std::vector<OutputFile> files =
        write_mesh(session->run->mesh(), session->run->complex(), extension, {}, &error);
    return written(files, error);
  });
}

val write_complex_text(const std::string& text, const std::string& extension) {
  return guarded(failure("out of memory"), [&] {
    const ReadResult input = read(text, "input.json");
    for (const Defect& defect : input.defects)
      if (!defect.warning) return failure(defect.message);
    const std::vector<Defect> wrong = check_numbers(input.complex, 1);
    if (!wrong.empty()) return failure(wrong.front().message);
    std::string error;
    const std::vector<OutputFile> files = write_complex(input.complex, extension, &error);
    return written(files, error);
  });
}

val extensions(int dimension) {
  val result = val::array();
  for (const std::string& extension : mesh_extensions(dimension)) {
    result.call<void>("push", extension);
  }
  return result;
}

std::string run_complex(int id) {
  try {
    const Session* session = find(id);
    std::string error;
    if (!session) return "";
    const std::vector<OutputFile> text = write_complex(session->run->complex(), ".json", &error);
    return text.empty() ? std::string() : text.front().bytes;
  } catch (...) {
    return "";
  }
}

void release(int id) { sessions().erase(id); }

}  // namespace

EMSCRIPTEN_BINDINGS(circumball) {
  emscripten::function(
      "version", +[] { return std::string(version()); });
  emscripten::function(
      "selfTest", +[] { return std::string(predicate_self_test()); });
  emscripten::function("algorithms", &registry_json);
  emscripten::function("traceNames", &trace_names_json);
  emscripten::function("read", &read_files);
  emscripten::function("check", &check_text);
  emscripten::function("faceTriangles", &face_triangles);
  emscripten::function("faceFrames", &face_frames);
  emscripten::function("start", &start);
  emscripten::function("advance", &advance);
  emscripten::function("cancel", &cancel);
  emscripten::function("takeTrace", &take_trace);
  emscripten::function("runComplex", &run_complex);
  emscripten::function("mesh", &mesh_of);
  emscripten::function("report", &report_of);
  emscripten::function("write", &write_run);
  emscripten::function("writeComplex", &write_complex_text);
  emscripten::function("meshExtensions", &extensions);
  emscripten::function("release", &release);
}

}  // namespace circumball
