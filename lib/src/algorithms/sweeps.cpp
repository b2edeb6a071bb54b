#include "algorithms/sweeps.h"

#include <algorithm>
#include <cmath>

#include "delaunay/constructions.h"
#include "refinement/view.h"

namespace circumball {
namespace {

class InsertVertices final : public Stage {
 public:
  InsertVertices() : Stage("0", "Delaunay triangulation of the input vertices") {}

  bool advance(Workspace& w, Budget&) override {
    Delaunay2& dt = w.live.triangulation();
    dt.insert_batch(0, dt.vertex_count(), [&](VertexId v) {
      ++w.inserted;
      if (!w.recorder.on()) return;
      w.recorder.inserted(w.recorder.insertion(Reason::kInput), v, 0);
    });
    w.live.create_subsegments();
    return true;
  }
};

class ClassifyTriangles final : public Stage {
 public:
  ClassifyTriangles() : Stage("domain", "Which triangles are inside") {}

  bool advance(Workspace& w, Budget&) override {
    w.live.classify();
    w.recorder.classified();
    return true;
  }
};

class DivideSegments final : public Stage {
 public:
  explicit DivideSegments(double h)
      : Stage("1", "Divide the input segments to between h and sqrt 3 h"), h_(h) {}

  bool advance(Workspace& w, Budget& budget) override {
    for (; next_ < w.live.complex().segments.size(); ++next_) {
      if (!w.live.subsegment(SubsegmentId(next_)).alive) continue;
      if (!budget.spend() || !w.within_limits()) return false;
      divide(w, SubsegmentId(next_));
    }
    return true;
  }

 private:
  void divide(Workspace& w, SubsegmentId s) {
    Delaunay2& dt = w.live.triangulation();
    const Subsegment whole = w.live.subsegment(s);
    const Point2 a = dt.point(whole.a), b = dt.point(whole.b);
    const double pieces = std::floor(distance(a, b) / h_);
    if (!(pieces >= 2)) return;
    const double most = w.limits.max_vertices ? static_cast<double>(w.limits.max_vertices) : 4e9;
    const auto n = static_cast<std::uint32_t>(std::min(pieces, most));
    View view(w.live, w.recorder.on());
    for (std::uint32_t i = 1; i < n; ++i) {
      if (!w.within_limits()) return;
      const Point2 p = view.outward(division_point(a, b, i, n), s);
      ++w.iterations;
      if (view.look_at_midpoint(p, s) == Outlook::kCoincides) {
        ++w.refused;
        w.refusal_limit = Reason::kLimitPrecision;
        w.recorder.refused(s, Reason::kPrecision, p);
        continue;
      }
      const double radius = w.recorder.on() ? view.insertion_radius(p) : 0;
      const Event event = w.recorder.insertion_of(s, Reason::kDivision);
      const VertexId v = w.live.add_vertex(p, {FeatureKind::kSegment, whole.segment.value});
      w.live.commit(v, s.value);
      ++w.inserted;
      w.recorder.inserted(event, v, radius);
      s = w.live.split(s, v)[1];
    }
  }

  double h_;
  std::uint32_t next_ = 0;
};

}  // namespace

std::unique_ptr<Stage> insert_vertices() { return std::make_unique<InsertVertices>(); }
std::unique_ptr<Stage> classify_triangles() { return std::make_unique<ClassifyTriangles>(); }
std::unique_ptr<Stage> divide_segments(double h) { return std::make_unique<DivideSegments>(h); }

double default_division_length(const Complex& complex) {
  Delaunay2 dt;
  for (const Point3& p : complex.vertices) dt.add_vertex(xy(p));
  dt.insert_batch(0, dt.vertex_count(), [](VertexId) {});
  double shortest2 = HUGE_VAL;
  // A nearest neighbour is a Delaunay neighbour, so the closest pair is an edge.
  for (std::uint32_t i = 0; i < dt.vertex_count(); ++i) {
    dt.for_each_neighbor(VertexId(i), [&](VertexId q) {
      shortest2 = std::min(shortest2, squared_distance(dt.point(VertexId(i)), dt.point(q)));
      return true;
    });
  }
  return 0.5 * std::sqrt(shortest2);
}

}  // namespace circumball
