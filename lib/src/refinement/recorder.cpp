#include "refinement/recorder.h"

namespace circumball {
namespace {

/// Regions are inside, too.
std::uint32_t traced(std::uint32_t label) {
  return label >= kFirstRegion && label != kVisited ? kInside : label;
}

}  // namespace

bool Recorder::append(const Delaunay2::Triangle& t, std::uint32_t label) {
  for (const VertexId v : t.v) {
    if (v == Delaunay2::kGhost) return false;
  }
  for (const VertexId v : t.v) stream_.push_back(v.value);
  stream_.push_back(traced(label));
  return true;
}

void Recorder::inserted(Event e, VertexId v, double insertion_radius) {
  if (!sink_) return;
  const Delaunay2& dt = live_.triangulation();
  e.subject = v.value;
  place(dt.point(v), &e);
  e.value = insertion_radius;
  stream_.clear();
  std::uint32_t died = 0, born = 0;
  for (const Delaunay2::Triangle& t : dt.died()) died += append(t, t.label);
  for (const TriangleId t : dt.born()) born += append(dt.triangle(t), dt.triangle(t).label);
  e.other[0] = died;
  e.other[1] = born;
  send_with_stream(e);
}

void Recorder::relabeled(const std::vector<Live2::Relabeled>& triangles) {
  if (!sink_ || triangles.empty()) return;
  const Delaunay2& dt = live_.triangulation();
  Event e = blank(EventKind::kRelabeled);
  stream_.clear();
  for (const auto& [t, before] : triangles) append(dt.triangle(t), before);
  for (const auto& [t, before] : triangles) append(dt.triangle(t), dt.triangle(t).label);
  e.other[0] = e.other[1] = static_cast<std::uint32_t>(stream_.size() / 8);
  send_with_stream(e);
}

}  // namespace circumball
