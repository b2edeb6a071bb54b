#include <algorithm>
#include <numeric>
#include <utility>

#include "delaunay/delaunay2.h"
#include "delaunay/spatial_order.h"

namespace circumball {

Delaunay2::Batch Delaunay2::begin_batch(std::uint32_t first, std::uint32_t last) {
  Batch batch;
  last = std::min(last, vertex_count());
  batch.order.reserve(last > first ? last - first : 0);
  for (std::uint32_t v = first; v < last; ++v)
    if (!inserted(VertexId(v))) batch.order.push_back(v);
  const auto at = [this](std::uint32_t v) -> const Point2& { return points_[v]; };
  for (const auto& [vertex, of] : sort_along_hilbert_curve(at, &batch.order))
    batch.duplicates.push_back({VertexId(vertex), VertexId(of)});
  triangles_.reserve(triangles_.size() + 2 * batch.order.size());
  if (!tags_.empty()) tags_.reserve(4 * triangles_.capacity());
  return batch;
}

void Delaunay2::deal(Batch* batch) { deal_rounds(&batch->order); }

bool Delaunay2::insert_next(std::uint32_t v, Batch* batch) {
  if (probe(VertexId(v), last_born_) == Probe::kDuplicate) {
    batch->duplicates.push_back({VertexId(v), duplicate_of_});
    return false;
  }
  commit(VertexId(v));
  return true;
}

void Delaunay2::insert_silently(Batch* batch) {
  if (dimension_ < 0) {
    build_in_order(batch);
  } else {
    deal(batch);
    for (const std::uint32_t v : batch->order) insert_next(v, batch);
  }
  died_.clear();
  born_.clear();
}

// From nothing: with vertices renumbered along the curve, neighbors are near each other in memory.
void Delaunay2::build_in_order(Batch* batch) {
  const std::vector<std::uint32_t>& numbers = batch->order;
  Delaunay2 build;
  build.numbers_ = numbers.data();
  build.births_ = births_;
  build.triangles_.swap(triangles_);
  build.points_.reserve(numbers.size());
  for (const std::uint32_t v : numbers) build.points_.push_back(points_[v]);
  build.triangle_of_.resize(numbers.size(), kNone);
  std::vector<std::uint32_t> order(numbers.size());
  std::iota(order.begin(), order.end(), 0u);
  deal_rounds(&order);
  for (const std::uint32_t v : order) build.insert_plainly(VertexId(v));

  triangles_.swap(build.triangles_);
  for (Triangle& t : triangles_)
    for (VertexId& v : t.v)
      if (v != kGhost) v = VertexId(numbers[v.value]);
  for (std::size_t i = 0; i < numbers.size(); ++i) triangle_of_[numbers[i]] = build.triangle_of_[i];
  dimension_ = build.dimension_;
  if (build.only_vertex_.valid()) only_vertex_ = VertexId(numbers[build.only_vertex_.value]);
  ghost_triangle_ = build.ghost_triangle_;
  last_born_ = build.last_born_;
  births_ = build.births_;
}

std::vector<Delaunay2::Duplicate> Delaunay2::end_batch(Batch* batch) {
  // A vertex equal to one of the batch that turned out equal to one inserted before names the
  // latter.
  std::vector<Duplicate>& list = batch->duplicates;
  std::sort(list.begin(), list.end(),
            [](const Duplicate& a, const Duplicate& b) { return a.vertex < b.vertex; });
  for (Duplicate& d : list) {
    if (inserted(d.of)) continue;
    const auto it = std::lower_bound(list.begin(), list.end(), d.of,
                                     [](const Duplicate& e, VertexId v) { return e.vertex < v; });
    d.of = it->of;
  }
  return std::move(list);
}

}  // namespace circumball
