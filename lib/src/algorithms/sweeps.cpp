#include "algorithms/sweeps.h"

#include <algorithm>
#include <cmath>

#include "delaunay/constructions.h"
#include "refinement/split_at.h"

namespace circumball {
namespace {

class InsertVertices final : public Stage {
 public:
  InsertVertices() : Stage("0", "Delaunay triangulation of the input vertices") {}

  bool advance(Workspace& w, Budget&) override {
    Delaunay2& dt = w.live.triangulation();
    const std::uint32_t count = dt.vertex_count();
    dt.reserve(2 * count);
    if (w.recorder.on()) {
      dt.insert_batch(0, count, [&](VertexId v) {
        const Reason what = w.live.is_box_corner(v) ? Reason::kBox : Reason::kInput;
        w.recorder.inserted(w.recorder.insertion(what), v, 0);
      });
    } else {
      dt.insert_batch(0, count, nullptr);  // the faster way
    }
    w.inserted = count;
    w.live.create_subsegments();
    return true;
  }
};

class ClassifyTriangles final : public Stage {
 public:
  ClassifyTriangles() : Stage("domain", "Which triangles are inside") {}

  bool advance(Workspace& w, Budget&) override {
    w.live.classify();
    w.recorder.relabeled(w.live.take_relabeled());
    return true;
  }
};

class DivideSegments final : public Stage {
 public:
  explicit DivideSegments(double h)
      : Stage("1", "Divide the input segments to between h and sqrt 3 h"), h_(h) {}

  bool advance(Workspace& w, Budget& budget) override {
    const auto count = static_cast<std::uint32_t>(w.live.complex().segments.size());
    for (; segment_ < count; ++segment_, part_ = 0) {
      if (part_ == 0 && !begin_segment(w)) continue;
      for (; part_ < parts_; ++part_) {
        if (!budget.spend() || !w.within_limits()) return false;
        insert_point(w);
      }
    }
    return true;
  }

 private:
  bool begin_segment(const Workspace& w) {
    rest_ = SubsegmentId(segment_);
    const Subsegment& whole = w.live.subsegment(rest_);
    if (!whole.alive) return false;
    const Delaunay2& dt = w.live.triangulation();
    a_ = dt.point(whole.a);
    b_ = dt.point(whole.b);
    const double parts = std::floor(distance(a_, b_) / h_);
    if (!(parts >= 2)) return false;
    parts_ = static_cast<std::uint32_t>(std::min(parts, 4e9));
    part_ = 1;
    return true;
  }

  void insert_point(Workspace& w) {
    const Point2 p = division_point(a_, b_, part_, parts_);
    if (const auto halves = split_at(w, rest_, p, Reason::kDivision)) rest_ = (*halves)[1];
  }

  double h_;
  std::uint32_t segment_ = 0, part_ = 0, parts_ = 0;  // what is inserted next
  SubsegmentId rest_;                                 // of the segment, not divided yet
  Point2 a_, b_;
};

}  // namespace

std::unique_ptr<Stage> insert_vertices() { return std::make_unique<InsertVertices>(); }
std::unique_ptr<Stage> classify_triangles() { return std::make_unique<ClassifyTriangles>(); }
std::unique_ptr<Stage> divide_segments(double h) { return std::make_unique<DivideSegments>(h); }

double default_division_length(const Complex& complex) {
  Delaunay2 dt;
  for (const Point3& p : complex.vertices) dt.add_vertex(xy(p));
  dt.insert_batch(0, dt.vertex_count(), nullptr);
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
