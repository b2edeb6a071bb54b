#include "circumball/trace.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>

namespace circumball {
namespace {

constexpr char kMagic[] = "circumball-trace 1\n";
constexpr std::size_t kMagicSize = sizeof(kMagic) - 1;

// Events and numbers are written as they lie in memory: every platform that we build for is
// little-endian.
template <class T>
void append(const T* data, std::size_t count, std::string* bytes) {
  bytes->append(reinterpret_cast<const char*>(data), count * sizeof(T));
}

template <class T>
bool take(const std::string& bytes, std::size_t* at, std::uint64_t count, T* out) {
  if (count > (bytes.size() - *at) / sizeof(T)) return false;
  if (count > 0) std::memcpy(out, bytes.data() + *at, count * sizeof(T));
  *at += count * sizeof(T);
  return true;
}

/// Large traces grow by factors of 4 where addresses are plenty: pages that are never touched cost
/// nothing, and those that are copied are most of what recording costs.
template <class T>
void make_room(std::vector<T>* all, std::size_t more) {
  if (all->capacity() - all->size() >= more) return;
  constexpr std::size_t kFactor = sizeof(void*) > 4 ? 4 : 2;
  all->reserve(std::max(all->size() + more, kFactor * all->capacity()));
}

/// Whether simplices of an event follow in the stream.
bool has_record(const Event& e) {
  return e.kind == EventKind::kInserted || e.kind == EventKind::kRelabeled ||
         e.kind == EventKind::kFaceChanged || e.kind == EventKind::kProtection;
}

/// How many vertices a simplex of an event has.
unsigned corners(const Event& e) { return e.dimension == 0 ? 0 : e.dimension + 1u; }

std::string list_of(const Event& e) {
  std::string text;
  for (unsigned i = 0; i < corners(e); ++i) {
    if (i) text += i + 1 == corners(e) ? " and " : ", ";
    text += std::to_string(e.simplex[i]);
  }
  return text;
}

/// In space: to a triangle of a face, not to a subsegment.
bool yields_to_triangle(const Event& e) { return e.kind == EventKind::kYielded && e.value > 0; }
std::uint32_t third_corner(const Event& e) { return static_cast<std::uint32_t>(e.value) - 1; }

std::string simplex_words(const Event& e) {
  switch (e.dimension) {
    case 1:
      if (e.simplex[2] != kNoIndex && e.simplex[3] != kNoIndex) {
        return "The arc of a ring about segment " + std::to_string(e.simplex[3]) +
               " between vertices " + list_of(e);
      }
      if (e.simplex[2] != kNoIndex) {
        return "The arc about input vertex " + std::to_string(e.simplex[2]) + " between vertices " +
               list_of(e);
      }
      if (e.simplex[3] == kNoIndex) return "The collar segment between vertices " + list_of(e);
      return "The piece of segment " + std::to_string(e.simplex[3]) + " between vertices " +
             list_of(e);
    case 2:
      if (e.simplex[3] != kNoIndex) {
        return "The triangle of face " + std::to_string(e.simplex[3]) + " with vertices " +
               list_of(e);
      }
      return "The triangle of vertices " + list_of(e);
    default:
      return "The tetrahedron of vertices " + list_of(e);
  }
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

std::string why_queued(const Event& e) {
  const std::string witness = std::to_string(e.subject);
  switch (e.reason) {
    case Reason::kEncroached:
      return " is unacceptable: vertex " + witness + " lies inside its diametral " +
             (e.dimension == 1 ? "disk" : "ball") + ".";
    case Reason::kMissing:
      return e.dimension == 1
                 ? " is unacceptable: it is not an edge of the Delaunay triangulation."
                 : " is unacceptable: an edge of the Delaunay triangulation crosses it.";
    case Reason::kRadiusEdge:
      return " is unacceptable: its radius-edge ratio is " + number(e.value) +
             ", more than the threshold.";
    case Reason::kSize:
      return " is unacceptable: its circumradius is " + number(e.value) + ", more than its bound.";
    case Reason::kRegionSize:
      return std::string(" is unacceptable: its ") + (e.dimension == 3 ? "volume" : "area") +
             " is " + number(e.value) + ", more than the bound of its region.";
    case Reason::kTooLong:
      return " is unacceptable: its length is " + number(e.value) +
             ", more than twice that of the shortest in its spindle, and vertex " + witness +
             " lies inside its diametral disk.";
    case Reason::kWitness:
      return " is unacceptable: vertex " + witness +
             " is a 1-feature size witness inside its diametral disk.";
    case Reason::kNearWitness:
      return " is unacceptable: vertex " + witness +
             ", a Delaunay neighbor of one of its ends or of an end in its spindle, is a 1-feature "
             "size witness for it at distance " +
             number(e.value) + ", less than its length.";
    case Reason::kNearLocalWitness:
      return " is unacceptable: vertex " + witness +
             ", a Delaunay neighbor of one of its ends, is a local feature size witness for it at "
             "distance " +
             number(e.value) + ", less than its length.";
    case Reason::kNearVertex:
      return " is unacceptable: vertex " + witness +
             ", a Delaunay neighbor of one of its vertices, does not lie in the face and is at "
             "distance " +
             number(e.value) + ", less than its circumdiameter.";
    case Reason::kWide:
      return " is unacceptable: seen from the center of its sphere, its angular radius is above 45 "
             "degrees.";
    case Reason::kYieldedTo:
      return " is queued: a circumcenter yields to it.";
    case Reason::kReturned:
      return " goes back to the queue and waits for that split.";
    default:
      return std::string(" is queued: ") + name(e.reason) + ".";
  }
}

/// A protecting element, with the names that its kind gives to its numbers.
nlohmann::ordered_json element_json(const std::uint32_t* r) {
  const auto kind = static_cast<ProtectingKind>(r[4]);
  nlohmann::ordered_json line = {{"kind", name(kind)}};
  const bool patch = kind == ProtectingKind::kSpherePatch || kind == ProtectingKind::kTubePatch;
  line["vertices"] = std::vector<std::uint32_t>(r, r + (patch ? 3 : 2));
  if (!patch && r[2] != kNoIndex) line["center"] = r[2];
  const bool in_face = kind == ProtectingKind::kCollarSegment || kind == ProtectingKind::kCollarArc;
  const char* carrier = in_face                                ? "face"
                        : kind == ProtectingKind::kSpherePatch ? "vertex"
                                                               : "segment";
  line[carrier] = r[3];
  return line;
}

/// What a vertex is that splits nothing.
std::string without_simplex(const Event& e) {
  const std::string in_face =
      e.simplex[3] == kNoIndex ? "" : " in face " + std::to_string(e.simplex[3]);
  const std::string circle = e.simplex[1] == kNoIndex
                                 ? " a protecting circle"
                                 : " the circle about input vertex " + std::to_string(e.simplex[1]);
  switch (e.reason) {
    case Reason::kBox:
      return ", a corner of the box,";
    case Reason::kCircle:
      return ", on" + circle + in_face + ",";
    case Reason::kCollar:
      if (e.simplex[1] != kNoIndex) return ", of the collar" + in_face + ", on" + circle + ",";
      if (e.simplex[0] == kNoIndex) return ", of a collar,";
      return ", of the collar" + in_face + ", across from vertex " + std::to_string(e.simplex[0]) +
             " of its segment,";
    case Reason::kRing:
      return ", on a ring about a segment at vertex " + std::to_string(e.simplex[0]) + in_face +
             ",";
    case Reason::kSeed:
      return ", a seed on the sphere about input vertex " + std::to_string(e.simplex[1]) + ",";
    default:
      return " of the input";
  }
}

std::string place_inserted(Reason reason) {
  switch (reason) {
    case Reason::kOffCenter:
      return "at the off-center of";
    case Reason::kDivision:
      return "at an equal division of";
    case Reason::kCollar:
      return "at the distance that protects its acute angle, on";
    case Reason::kEqualLength:
      return "for pieces of equal length at a common vertex, on";
    case Reason::kThird:
      return "a third of the nearest neighbor's distance from its input vertex, on";
    case Reason::kShell:
      return "where a concentric shell about its input vertex crosses";
    case Reason::kArcMidpoint:
      return "at the midpoint of";
    case Reason::kRing:
      return "on a ring that splits";
    case Reason::kSurface:
      return "on the sphere or tube, above the circumcenter of";
    case Reason::kPicked:
      return "near the circumcenter, where slivers become fewer, of";
    default:
      return std::string("at the ") + name(reason) + " of";
  }
}

std::string why_refused(Reason reason) {
  switch (reason) {
    case Reason::kOutsideDomain:
      return "its circumcenter lies outside the domain";
    case Reason::kProtected:
      return "only protected simplices are in its way";
    case Reason::kMinEdge:
      return "that would make an edge shorter than the shortest allowed";
    case Reason::kPrecision:
      return "the new vertex would coincide with another one in double precision";
    case Reason::kSeditious:
      return "its shortest edge is seditious: it joins two segments of a small angle, equally far "
             "from where they meet";
    case Reason::kOutsideFace:
      return "its circumcenter lies outside of the face";
    case Reason::kNearSegment:
      return "an end of a segment of the face would be a Delaunay neighbor of its circumcenter, "
             "nearer than that segment is long";
    case Reason::kNoRoom:
      return "all points tried in its ball encroach upon a segment or a face, or lie outside";
    case Reason::kNotImproved:
      return "no point tried in its ball leaves fewer slivers and keeps radius-edge ratios and "
             "sizes";
    case Reason::kFrozen:
      return "its circumcenter would yield to a piece of a segment that is not split any more";
    default:
      return name(reason);
  }
}

}  // namespace

void Trace::event(const Event& e, const std::uint32_t* data, std::size_t count) {
  make_room(&events, 1);
  make_room(&simplices, count);
  events.push_back(e);
  simplices.insert(simplices.end(), data, data + count);
}

std::string to_bytes(const Trace& trace) {
  std::string bytes(kMagic, kMagicSize);
  const std::uint64_t head[4] = {static_cast<std::uint64_t>(trace.dimension), trace.steps.size(),
                                 trace.events.size(), trace.simplices.size()};
  append(head, 4, &bytes);
  for (const std::string& step : trace.steps) {
    const std::uint64_t size = step.size();
    append(&size, 1, &bytes);
    bytes += step;
  }
  append(trace.events.data(), trace.events.size(), &bytes);
  append(trace.simplices.data(), trace.simplices.size(), &bytes);
  return bytes;
}

bool trace_from_bytes(const std::string& bytes, Trace* trace, std::string* error) {
  *trace = Trace();
  *error = "this is not a trace of circumball, version 1";
  if (bytes.compare(0, kMagicSize, kMagic) != 0) return false;
  std::size_t at = kMagicSize;
  std::uint64_t head[4];
  *error = "the trace ends early";
  if (!take(bytes, &at, 4, head) || (head[0] != 2 && head[0] != 3)) return false;
  trace->dimension = static_cast<int>(head[0]);
  for (std::uint64_t i = 0; i < head[1]; ++i) {
    std::uint64_t size;
    if (!take(bytes, &at, 1, &size) || size > bytes.size() - at) return false;
    trace->steps.push_back(bytes.substr(at, size));
    at += size;
  }
  // Counts are held against the bytes that there are before memory is taken.
  const std::uint64_t rest = bytes.size() - at;
  if (head[2] > rest / sizeof(Event) ||
      head[3] > (rest - head[2] * sizeof(Event)) / sizeof(std::uint32_t)) {
    return false;
  }
  trace->events.resize(head[2]);
  trace->simplices.resize(head[3]);
  take(bytes, &at, head[2], trace->events.data());
  take(bytes, &at, head[3], trace->simplices.data());
  // What a replay relies on: counts of simplices that the stream has, kinds that there are.
  std::uint64_t used = 0;
  const std::uint64_t stride = head[0] + 2;
  for (const Event& e : trace->events) {
    if (!has_record(e)) continue;
    const std::uint64_t first = used;
    used += (std::uint64_t{e.other[0]} + e.other[1]) * stride;
    if (used > head[3]) return false;
    if (e.kind != EventKind::kProtection) continue;
    *error = "the trace protects by what this version does not know";
    if (stride != 5) return false;
    for (std::uint64_t i = first; i < used; i += stride) {
      if (trace->simplices[i + 4] >= kProtectingKinds) return false;
    }
    *error = "the trace ends early";
  }
  error->clear();
  return true;
}

std::string to_jsonl(const Trace& trace) {
  std::string text;
  std::size_t at = 0;
  const std::size_t stride = static_cast<std::size_t>(trace.dimension) + 2;
  for (const Event& e : trace.events) {
    nlohmann::ordered_json line = {
        {"event", name(e.kind)}, {"step", e.step < trace.steps.size() ? trace.steps[e.step] : ""}};
    if (e.reason != Reason::kNone) line["reason"] = name(e.reason);
    if (corners(e) > 0) {
      line["simplex"] = std::vector<std::uint32_t>(e.simplex, e.simplex + corners(e));
      if (e.dimension == 1 && e.simplex[3] != kNoIndex) line["segment"] = e.simplex[3];
      if (e.dimension == 1 && e.simplex[2] != kNoIndex) line["center"] = e.simplex[2];
      if (e.dimension == 2 && e.simplex[3] != kNoIndex) line["face"] = e.simplex[3];
    } else if (e.kind == EventKind::kInserted) {
      if (e.simplex[0] != kNoIndex) line["at-vertex"] = e.simplex[0];
      if (e.simplex[1] != kNoIndex) line["center"] = e.simplex[1];
      if (e.simplex[3] != kNoIndex) line["face"] = e.simplex[3];
    }
    if (e.kind == EventKind::kFaceChanged) line["face"] = e.subject;
    if (e.kind == EventKind::kInserted) line["vertex"] = e.subject;
    if (e.kind == EventKind::kQueued && e.subject != kNoIndex) line["witness"] = e.subject;
    if (e.kind == EventKind::kYielded) {
      line["to"] = {e.other[0], e.other[1]};
      if (yields_to_triangle(e)) line["to"].push_back(third_corner(e));
      if (e.subject != kNoIndex) line[yields_to_triangle(e) ? "face" : "segment"] = e.subject;
    }
    if (e.kind == EventKind::kInserted || e.kind == EventKind::kRefused ||
        e.kind == EventKind::kYielded) {
      line["at"] = std::vector<double>(e.at, e.at + trace.dimension);
    }
    if (e.value != 0 && !yields_to_triangle(e)) line["value"] = e.value;
    if (has_record(e)) {
      // A triangle of a face has one vertex less than a cell.
      const std::size_t size = stride - (e.kind == EventKind::kFaceChanged ? 2 : 1);
      const auto simplices = [&](std::uint32_t count) {
        nlohmann::ordered_json list = nlohmann::ordered_json::array();
        for (std::uint32_t i = 0; i < count; ++i, at += stride) {
          if (e.kind == EventKind::kProtection) {
            list.push_back(element_json(&trace.simplices[at]));
            continue;
          }
          list.push_back(std::vector<std::uint32_t>(
              trace.simplices.begin() + static_cast<std::ptrdiff_t>(at),
              trace.simplices.begin() + static_cast<std::ptrdiff_t>(at + size)));
        }
        return list;
      };
      line["died"] = simplices(e.other[0]);
      line["born"] = simplices(e.other[1]);
    }
    text += line.dump();
    text += '\n';
  }
  return text;
}

std::string describe(const Event& e, const std::vector<std::string>& steps) {
  const std::string step = e.step < steps.size() ? steps[e.step] : "?";
  switch (e.kind) {
    case EventKind::kStepBegan:
      return "Step " + step + " begins.";
    case EventKind::kStepEnded:
      return "Step " + step + " ends: " + std::to_string(e.subject) + " vertices inserted, " +
             std::to_string(e.other[0]) + " simplices refused.";
    case EventKind::kQueued:
      return simplex_words(e) + why_queued(e);
    case EventKind::kDropped:
      return simplex_words(e) + " is dropped: it " +
             (e.reason == Reason::kDied ? "has died." : "is acceptable.");
    case EventKind::kRefused:
      return simplex_words(e) + " is not split: " + why_refused(e.reason) + ".";
    case EventKind::kYielded:
      if (yields_to_triangle(e) && e.subject == kNoIndex) {
        return simplex_words(e) +
               " yields: its circumcenter encroaches upon the patch between "
               "vertices " +
               std::to_string(e.other[0]) + ", " + std::to_string(e.other[1]) + " and " +
               std::to_string(third_corner(e)) + ", which is queued instead.";
      }
      if (yields_to_triangle(e)) {
        return simplex_words(e) +
               " yields: its circumcenter encroaches upon the triangle of face " +
               std::to_string(e.subject) + " between vertices " + std::to_string(e.other[0]) +
               ", " + std::to_string(e.other[1]) + " and " + std::to_string(third_corner(e)) +
               ", which is queued instead.";
      }
      return simplex_words(e) + " yields: its circumcenter encroaches upon the " +
             (e.subject == kNoIndex ? std::string("arc")
                                    : "piece of segment " + std::to_string(e.subject)) +
             " between vertices " + std::to_string(e.other[0]) + " and " +
             std::to_string(e.other[1]) + ", which is queued instead.";
    case EventKind::kInserted: {
      const std::string vertex = "Vertex " + std::to_string(e.subject);
      if (e.dimension == 0) {
        return vertex + without_simplex(e) + " is inserted.";
      }
      std::string split = simplex_words(e);
      split[0] = 't';
      return vertex + " is inserted " + place_inserted(e.reason) + " " + split + ", at distance " +
             number(e.value) + " from its nearest neighbor.";
    }
    case EventKind::kFaceChanged:
      return "The triangulation of face " + std::to_string(e.subject) +
             " changes: " + std::to_string(e.other[0]) + " triangles die, " +
             std::to_string(e.other[1]) + " are born.";
    case EventKind::kProtection:
      return "What protects the input changes: " + std::to_string(e.other[0]) +
             " of its elements die, " + std::to_string(e.other[1]) + " are born.";
    case EventKind::kRelabeled:
      if (e.reason == Reason::kMatching) {
        return "In the tubes, " + std::to_string(e.other[1]) +
               " tetrahedra that conform take the "
               "place of " +
               std::to_string(e.other[0]) + " Delaunay ones, and match what is around.";
      }
      return "The triangles are told apart: inside and outside of the domain.";
    case EventKind::kLimit:
      return std::string("The run stops: ") + name(e.reason) + ".";
  }
  return "";
}

}  // namespace circumball
