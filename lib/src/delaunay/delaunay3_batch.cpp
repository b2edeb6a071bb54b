#include <algorithm>
#include <numeric>
#include <utility>

#include "delaunay/delaunay3.h"
#include "delaunay/spatial_order.h"

namespace circumball {

Delaunay3::Batch Delaunay3::begin_batch(std::uint32_t first, std::uint32_t last) {
  Batch batch;
  last = std::min(last, vertex_count());
  batch.order.reserve(last > first ? last - first : 0);
  for (std::uint32_t v = first; v < last; ++v)
    if (!inserted(VertexId(v))) batch.order.push_back(v);
  const auto at = [this](std::uint32_t v) -> const Point3& { return points_[v]; };
  for (const auto& [vertex, of] : sort_along_hilbert_curve(at, &batch.order))
    batch.duplicates.push_back({VertexId(vertex), VertexId(of)});
  std::size_t cells = links_.size() + 7 * batch.order.size();
  if (cells > links_.capacity()) {
    // Many small batches must not move everything each time.
    cells = std::max(cells, links_.size() + links_.size() / 2);
    links_.reserve(cells);
    notes_.reserve(cells);
    mark_.reserve(cells);
  }
  return batch;
}

void Delaunay3::deal(Batch* batch) { deal_rounds(&batch->order); }

bool Delaunay3::insert_next(std::uint32_t v, Batch* batch) {
  if (probe(VertexId(v), last_born_) == Probe::kDuplicate) {
    batch->duplicates.push_back({VertexId(v), duplicate_of_});
    return false;
  }
  commit(VertexId(v));
  return true;
}

void Delaunay3::insert_silently(Batch* batch) {
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
void Delaunay3::build_in_order(Batch* batch) {
  const std::vector<std::uint32_t>& numbers = batch->order;
  Delaunay3 build;
  build.numbers_ = numbers.data();
  build.links_.swap(links_);
  build.mark_.swap(mark_);
  build.points_.reserve(numbers.size());
  for (const std::uint32_t v : numbers) build.points_.push_back(points_[v]);
  build.cell_of_.resize(numbers.size(), kNone);
  std::vector<std::uint32_t> order(numbers.size());
  std::iota(order.begin(), order.end(), 0u);
  deal_rounds(&order);
  for (const std::uint32_t v : order) build.insert_plainly(VertexId(v));

  links_.swap(build.links_);
  mark_.swap(build.mark_);
  free_.swap(build.free_);
  notes_.assign(links_.size(), Note());
  for (CellSlot c = 0; c < slot_count(); ++c) {
    if (!alive(c)) continue;
    notes_[c].birth = births_++;
    for (VertexId& v : links_[c].v)
      if (v != kGhost) v = VertexId(numbers[v.value]);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i) cell_of_[numbers[i]] = build.cell_of_[i];
  dimension_ = build.dimension_;
  for (const VertexId v : build.line_) line_.push_back(VertexId(numbers[v.value]));
  off_plane_ = build.off_plane_;
  ghost_cell_ = build.ghost_cell_;
  last_born_ = build.last_born_;
}

std::vector<Delaunay3::Duplicate> Delaunay3::end_batch(Batch* batch) {
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
