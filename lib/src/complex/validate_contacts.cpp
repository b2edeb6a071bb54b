#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

#include "circumball/predicates.h"
#include "complex/box_filters.h"
#include "complex/face_plane.h"
#include "complex/space_contacts.h"
#include "complex/validate_space.h"

namespace circumball {
namespace {

/// Boxes looked at before the search is ended, and pairs that are kept: some seconds, and some
/// hundred megabytes. Reached only by inputs with millions of contacts.
constexpr std::uint64_t kMaxWork = 400'000'000;
constexpr std::size_t kMaxPairs = 2'000'000;
using Pair = std::array<std::uint32_t, 2>;
using Meeting = SpaceContacts::Meeting;

/// Where the line ab meets the plane of t, rounded; on the segment.
Point3 piercing_point(const Point3& a, const Point3& b, const TriangleFilter& t) {
  const auto height = [&](const Point3& p) {
    return t.n.x * (p.x - t.a.x) + t.n.y * (p.y - t.a.y) + t.n.z * (p.z - t.a.z);
  };
  const double ha = height(a), hb = height(b);
  double f = ha != hb ? ha / (ha - hb) : 0.5;
  if (!(f >= 0)) f = 0;
  if (f > 1) f = 1;
  return {a.x + f * (b.x - a.x), a.y + f * (b.y - a.y), a.z + f * (b.z - a.z)};
}

class ContactCheck {
 public:
  ContactCheck(const Complex& complex, const SpaceView& view,
               const std::vector<FaceSurface>& surfaces, SpaceMeetings* meetings)
      : complex_(complex),
        view_(view),
        surfaces_(surfaces),
        contacts_(complex.vertices),
        meetings_(*meetings) {
    std::vector<Box3> boxes;
    for (const std::uint32_t s : view.segments) boxes.push_back(Box3::of(end(s, 0), end(s, 1)));
    segment_tree_ = BoxTree3(std::move(boxes));
    boxes.clear();
    for (std::uint32_t v = 0; v < complex.vertices.size(); ++v)
      if (view.usable_vertex[v]) {
        vertices_.push_back(v);
        boxes.push_back(Box3::of(point(v)));
      }
    vertex_tree_ = BoxTree3(std::move(boxes));
    boxes.clear();
    first_.push_back(0);
    for (std::uint32_t f = 0; f < surfaces.size(); ++f) {
      for (std::uint32_t k = 0; k < surfaces[f].triangles.size(); ++k) {
        const auto& t = surfaces[f].triangles[k];
        boxes.push_back(Box3::of(point(t[0]), point(t[1]), point(t[2])));
        face_of_.push_back(f);
      }
      first_.push_back(static_cast<std::uint32_t>(face_of_.size()));
    }
    triangle_tree_ = BoxTree3(std::move(boxes));
  }

  void run() {
    look_at_segments();
    look_at_vertices();
    look_at_faces();
  }
  void tell(std::size_t max, std::vector<Defect>* defects);

 private:
  using Triangle = SpaceContacts::Triangle;
  const Point3& point(std::uint32_t v) const { return complex_.vertices[v]; }
  const Point3& end(std::uint32_t s, int i) const { return point(complex_.segments[s][i]); }
  const Triangle& triangle(std::uint32_t t) const {
    return surfaces_[face_of_[t]].triangles[t - first_[face_of_[t]]];
  }
  std::uint8_t inner(std::uint32_t t) const {
    return surfaces_[face_of_[t]].inner[t - first_[face_of_[t]]];
  }
  TriangleFilter filter(const Triangle& t) const { return {point(t[0]), point(t[1]), point(t[2])}; }
  bool exhausted() {
    const bool over = work_ > kMaxWork || meetings_.vertex_on_segment.size() > kMaxPairs ||
                      meetings_.segments_cross.size() > kMaxPairs ||
                      meetings_.segments_overlap.size() > kMaxPairs ||
                      segment_crosses_face_.size() > kMaxPairs || faces_cross_.size() > kMaxPairs ||
                      faces_overlap_.size() > kMaxPairs ||
                      meetings_.vertex_in_face.size() > kMaxPairs;
    if (over) meetings_.incomplete = true;
    return over;
  }

  void look_at_segments();
  void look_at_vertices();
  void look_at_faces();
  Meeting pieces_meet(std::uint32_t t, std::uint32_t u) const;
  bool coplanar(std::uint32_t f, std::uint32_t g) const;
  bool overlap_in_plane(const FaceProjection& project, const Triangle& t, const Triangle& u) const;

  const Complex& complex_;
  const SpaceView& view_;
  const std::vector<FaceSurface>& surfaces_;
  const SpaceContacts contacts_;
  SpaceMeetings& meetings_;
  BoxTree3 segment_tree_, vertex_tree_, triangle_tree_;
  std::vector<std::uint32_t> vertices_, face_of_, first_;
  std::map<Pair, Point3> segment_crosses_face_, faces_cross_, faces_overlap_;
  std::set<Pair> duplicate_faces_;
  std::vector<std::uint8_t> is_member_;
  std::uint64_t work_ = 0;
};

void ContactCheck::look_at_segments() {
  for (std::uint32_t i = 0; i < view_.segments.size() && !exhausted(); ++i) {
    const std::uint32_t s = view_.segments[i];
    const std::uint32_t a = complex_.segments[s][0], b = complex_.segments[s][1];
    const SegmentFilter near(point(a), point(b));
    const auto enter = [&](const Box3& box) {
      ++work_;
      return near.may_meet(box);
    };
    vertex_tree_.query(enter, [&](std::uint32_t k) {
      if (contacts_.on_segment(vertices_[k], a, b))
        meetings_.vertex_on_segment.insert({{vertices_[k], s}, kNoIndex});
      return true;
    });
    segment_tree_.query(enter, [&](std::uint32_t j) {
      if (j <= i) return true;
      const std::uint32_t t = view_.segments[j];
      const Meeting m = contacts_.segments(a, b, complex_.segments[t][0], complex_.segments[t][1]);
      if (m == Meeting::kCross) meetings_.segments_cross.insert({{s, t}, kNoIndex});
      if (m == Meeting::kOverlap) meetings_.segments_overlap.insert({{s, t}, kNoIndex});
      return true;
    });
    triangle_tree_.query(enter, [&](std::uint32_t k) {
      const Triangle& t = triangle(k);
      const bool starts = a == t[0] || a == t[1] || a == t[2];
      const bool ends = b == t[0] || b == t[1] || b == t[2];
      if (starts && ends) return true;  // an edge of the triangle, decided in the face's plane
      Meeting m = contacts_.segment_triangle(a, b, t);
      for (int e = 0; e < 3 && m == Meeting::kNone; ++e)
        if (inner(k) >> e & 1) m = contacts_.segments(a, b, t[(e + 1) % 3], t[(e + 2) % 3]);
      if (m == Meeting::kNone) return true;
      const std::uint32_t f = face_of_[k];
      if (surfaces_[f].has_member(a) && surfaces_[f].has_member(b)) return true;  // likewise
      if (m == Meeting::kOverlap)
        meetings_.segment_in_face.insert({{s, f}, kNoIndex});
      else
        segment_crosses_face_.insert({{s, f}, piercing_point(point(a), point(b), filter(t))});
      return true;
    });
  }
}

void ContactCheck::look_at_vertices() {
  for (const std::uint32_t v : vertices_) {
    if (exhausted()) return;
    const Box3 at = Box3::of(point(v));
    triangle_tree_.query(
        [&](const Box3& box) {
          ++work_;
          return box.meets(at);
        },
        [&](std::uint32_t k) {
          const Triangle& t = triangle(k);
          if (v == t[0] || v == t[1] || v == t[2]) return true;
          bool in = contacts_.in_triangle(v, t);
          for (int e = 0; e < 3 && !in; ++e)
            in = (inner(k) >> e & 1) && contacts_.on_segment(v, t[(e + 1) % 3], t[(e + 2) % 3]);
          if (in && !surfaces_[face_of_[k]].has_member(v))
            meetings_.vertex_in_face.insert({{v, face_of_[k]}, kNoIndex});
          return true;
        });
  }
}

/// The pieces of a face: an open triangle, and its edges inside the face.
Meeting ContactCheck::pieces_meet(std::uint32_t i, std::uint32_t j) const {
  const Triangle &t = triangle(i), &u = triangle(j);
  const Meeting open = contacts_.triangles(t, u);
  if (open != Meeting::kNone) return open;
  const int of_t = inner(i), of_u = inner(j);
  const auto edge = [](const Triangle& x, int e) { return Pair{x[(e + 1) % 3], x[(e + 2) % 3]}; };
  for (int e = 0; e < 3; ++e) {
    if (of_u >> e & 1) {
      const Pair d = edge(u, e);
      if (contacts_.segment_triangle(d[0], d[1], t) != Meeting::kNone) return Meeting::kCross;
    }
    if (!(of_t >> e & 1)) continue;
    const Pair c = edge(t, e);
    if (contacts_.segment_triangle(c[0], c[1], u) != Meeting::kNone) return Meeting::kCross;
    for (int g = 0; g < 3; ++g) {
      if (!(of_u >> g & 1)) continue;
      const Pair d = edge(u, g);
      if (contacts_.segments(c[0], c[1], d[0], d[1]) != Meeting::kNone) return Meeting::kCross;
    }
  }
  return Meeting::kNone;
}

/// Whether the members of two faces determine one plane for both: they share three that are not
/// collinear, and the others are as close to that plane as planarity asks. Then the faces are taken
/// for coplanar, as rounding hides from exact predicates. `is_member_` marks f's.
bool ContactCheck::coplanar(std::uint32_t f, std::uint32_t g) const {
  const FaceProjection& project = surfaces_[f].projection;
  std::uint32_t a = kNoIndex, b = kNoIndex;
  bool area = false;
  for (const std::uint32_t v : surfaces_[g].members) {
    if (!is_member_[v]) continue;
    if (a == kNoIndex) {
      a = v;
    } else if (b == kNoIndex) {
      b = v;
    } else if (orient2d(project(point(a)), project(point(b)), project(point(v))) != Sign::kZero) {
      area = true;
      break;
    }
  }
  if (!area) return false;
  const FacePlane plane(complex_, f);
  Box3 box = Box3::of(point(surfaces_[f].members[0]));
  double highest = 0;
  for (const std::uint32_t v : surfaces_[f].members) box.extend(Box3::of(point(v)));
  for (const std::uint32_t v : surfaces_[g].members) {
    box.extend(Box3::of(point(v)));
    highest = std::max(highest, std::fabs(plane.height(point(v))));
  }
  return highest <= 2 * planarity_of(box);
}

bool ContactCheck::overlap_in_plane(const FaceProjection& project, const Triangle& t,
                                    const Triangle& u) const {
  const auto separated = [&](const Triangle& v, const Triangle& w) {
    const Point2 p[3] = {project(point(v[0])), project(point(v[1])), project(point(v[2]))};
    const int inside = static_cast<int>(orient2d(p[0], p[1], p[2]));
    for (int i = 0; i < 3; ++i) {
      bool beyond = true;
      for (int j = 0; j < 3 && beyond; ++j) {
        if (w[j] == v[i] || w[j] == v[(i + 1) % 3]) continue;
        beyond =
            static_cast<int>(orient2d(p[i], p[(i + 1) % 3], project(point(w[j])))) * inside <= 0;
      }
      if (beyond) return true;
    }
    return false;
  };
  return !separated(t, u) && !separated(u, t);
}

void ContactCheck::look_at_faces() {
  // Larger faces first, so that members of a pair are compared at the cost of the smaller.
  std::vector<std::uint32_t> order(surfaces_.size()), rank(surfaces_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t f, std::uint32_t g) {
    return surfaces_[f].members.size() > surfaces_[g].members.size();
  });
  for (std::uint32_t i = 0; i < order.size(); ++i) rank[order[i]] = i;
  is_member_.assign(complex_.vertices.size(), 0);
  enum class Plane : std::uint8_t { kUnknown, kShared, kOther, kDone };
  std::vector<Plane> plane(surfaces_.size(), Plane::kUnknown);
  std::vector<std::uint32_t> partners;
  for (const std::uint32_t f : order) {
    if (exhausted()) return;
    for (const std::uint32_t v : surfaces_[f].members) is_member_[v] = 1;
    for (std::uint32_t i = first_[f]; i < first_[f + 1]; ++i) {
      const Triangle& t = triangle(i);
      TriangleFilter near = filter(t);
      near.grow(4 * planarity_of(near.box));  // triangles of coplanar faces may be apart
      const auto enter = [&](const Box3& box) {
        ++work_;
        return near.may_meet(box);
      };
      triangle_tree_.query(enter, [&](std::uint32_t j) {
        const std::uint32_t g = face_of_[j];
        if (rank[g] <= rank[f] || plane[g] == Plane::kDone) return true;
        if (plane[g] == Plane::kUnknown) {
          plane[g] = coplanar(f, g) ? Plane::kShared : Plane::kOther;
          partners.push_back(g);
        }
        const Triangle& u = triangle(j);
        const Pair pair{std::min(f, g), std::max(f, g)};
        Meeting m = Meeting::kNone;
        if (plane[g] == Plane::kShared)
          m = overlap_in_plane(surfaces_[f].projection, t, u) ? Meeting::kOverlap : Meeting::kNone;
        else
          m = pieces_meet(i, j);
        if (m == Meeting::kNone) return true;
        Box3 common = triangle_tree_.box(i);
        const Box3& other = triangle_tree_.box(j);
        const Point3 at = {
            0.5 * (std::max(common.lo_x, other.lo_x) + std::min(common.hi_x, other.hi_x)),
            0.5 * (std::max(common.lo_y, other.lo_y) + std::min(common.hi_y, other.hi_y)),
            0.5 * (std::max(common.lo_z, other.lo_z) + std::min(common.hi_z, other.hi_z))};
        (m == Meeting::kOverlap ? faces_overlap_ : faces_cross_).insert({pair, at});
        plane[g] = Plane::kDone;
        return true;
      });
    }
    for (const std::uint32_t g : partners) {
      // Equal triangles, though in another order: the same face.
      if (plane[g] == Plane::kDone &&
          surfaces_[f].triangles.size() == surfaces_[g].triangles.size() &&
          surfaces_[f].members == surfaces_[g].members) {
        const auto sorted = [&](std::uint32_t h) {
          std::vector<Triangle> all = surfaces_[h].triangles;
          for (Triangle& t : all) std::sort(t.begin(), t.end());
          std::sort(all.begin(), all.end());
          return all;
        };
        if (sorted(f) == sorted(g)) duplicate_faces_.insert({std::min(f, g), std::max(f, g)});
      }
      plane[g] = Plane::kUnknown;
    }
    partners.clear();
    for (const std::uint32_t v : surfaces_[f].members) is_member_[v] = 0;
  }
}

std::string name(const char* kind, std::uint32_t i) { return kind + (" " + std::to_string(i)); }
std::string names(const char* kind, const Pair& p) {
  return kind + ("s " + std::to_string(p[0])) + " and " + std::to_string(p[1]);
}
std::string in_plane(std::uint32_t face) {
  return face == kNoIndex ? "" : ", in the plane of face " + std::to_string(face);
}

void ContactCheck::tell(std::size_t max, std::vector<Defect>* defects) {
  constexpr FeatureKind kV = FeatureKind::kVertex, kS = FeatureKind::kSegment,
                        kF = FeatureKind::kFace;
  const auto list = [&](const char* defect, FeatureKind first, FeatureKind second, const auto& map,
                        auto describe) {
    DefectList out(defect, false, max);
    if (meetings_.incomplete) out.set_incomplete();
    for (const auto& item : map) {
      if (!out.has_room()) {
        out.count_only();
        continue;
      }
      Pair pair;
      std::vector<Point3> at;
      std::string message;
      describe(item, &pair, &at, &message);
      out.add({{first, pair[0]}, {second, pair[1]}}, std::move(at), std::move(message));
    }
    out.append_to(defects);
  };
  list("vertex-on-segment", kV, kS, meetings_.vertex_on_segment,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         *at = {point(item.first[0])};
         *text = name("vertex", item.first[0]) + " at " + point_text(at->at(0), 3) +
                 " lies in the interior of " + name("segment", item.first[1]) +
                 in_plane(item.second) + ": split the segment there, or move the vertex";
       });
  list("segments-cross", kS, kS, meetings_.segments_cross,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         const Point3 &a = end(item.first[0], 0), &b = end(item.first[0], 1);
         const Point3 &c = end(item.first[1], 0), &d = end(item.first[1], 1);
         // The plane through the second segment and the common normal cuts the first.
         const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
         const double vx = d.x - c.x, vy = d.y - c.y, vz = d.z - c.z;
         const Point3 n = {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
         const double scale = 1 / std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z),
                                            std::numeric_limits<double>::min()});
         const Point3 beyond = {c.x + n.x * scale, c.y + n.y * scale, c.z + n.z * scale};
         *at = {piercing_point(a, b, TriangleFilter(c, d, beyond))};
         *text = names("segment", item.first) + " cross near " + point_text(at->at(0), 3) +
                 in_plane(item.second) + ": add a vertex there and split both, or move one";
       });
  list("segments-overlap", kS, kS, meetings_.segments_overlap,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         *at = {end(item.first[1], 0), end(item.first[1], 1)};
         *text = names("segment", item.first) + " overlap along the second, from " +
                 point_text(at->at(0), 3) + " to " + point_text(at->at(1), 3) +
                 in_plane(item.second) + ": keep each piece in one of them only";
       });
  list("vertex-in-face", kV, kF, meetings_.vertex_in_face,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         *at = {point(item.first[0])};
         *text = name("vertex", item.first[0]) + " at " + point_text(at->at(0), 3) + " lies in " +
                 name("face", item.first[1]) +
                 ", which does not list it: add it to the face's vertices";
       });
  list("segment-in-face", kS, kF, meetings_.segment_in_face,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         *at = {end(item.first[0], 0), end(item.first[0], 1)};
         *text = name("segment", item.first[0]) + " from " + point_text(at->at(0), 3) + " to " +
                 point_text(at->at(1), 3) + " lies in " + name("face", item.first[1]) +
                 ", which does not list it: add it to the face's segments" +
                 (item.second == kNoIndex ? ", as far as it is inside" : "");
       });
  list("segment-crosses-face", kS, kF, segment_crosses_face_,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         *at = {item.second};
         *text = name("segment", item.first[0]) + " passes through " + name("face", item.first[1]) +
                 " near " + point_text(item.second, 3) +
                 ": add a vertex there, split the segment and list the vertex in the face, or "
                 "move one of them";
       });
  list("duplicate-faces", kF, kF, duplicate_faces_,
       [&](const Pair& item, Pair* pair, auto* at, std::string* text) {
         *pair = item;
         *at = {point(surfaces_[item[0]].members[0])};
         *text = names("face", item) + " are the same polygon: remove one of them";
       });
  for (const Pair& pair : duplicate_faces_) faces_overlap_.erase(pair);
  list("faces-overlap", kF, kF, faces_overlap_,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         *at = {item.second};
         *text = names("face", item.first) + " lie in one plane and overlap near " +
                 point_text(item.second, 3) +
                 ": cut what they share out of one of them (a hole), or make it a face of its own";
       });
  list("faces-cross", kF, kF, faces_cross_,
       [&](const auto& item, Pair* pair, auto* at, std::string* text) {
         *pair = item.first;
         *at = {item.second};
         *text = names("face", item.first) + " cross each other near " +
                 point_text(item.second, 3) +
                 ": make their intersection a segment that both list, or move one of them";
       });
}

}  // namespace

void check_contacts(const Complex& complex, const SpaceView& view,
                    const std::vector<FaceSurface>& surfaces, std::size_t max,
                    SpaceMeetings* meetings, std::vector<Defect>* defects) {
  ContactCheck contacts(complex, view, surfaces, meetings);
  contacts.run();
  contacts.tell(max, defects);
}

}  // namespace circumball
