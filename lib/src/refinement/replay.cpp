#include <algorithm>
#include <array>
#include <set>

#include "circumball/trace.h"

namespace circumball {

/// The live cells, triangles of faces and protecting elements, each with its identity and as it was
/// recorded. The identity: its vertices in ascending order; for a triangle of a face, after the
/// face; for a protecting element, after its kind and carrier.
struct Replay::State {
  struct Cell {
    std::array<std::uint32_t, 5> key;
    std::array<std::uint32_t, 5> as_recorded;
    friend bool operator<(const Cell& a, const Cell& b) { return a.key < b.key; }
  };
  std::set<Cell> live, live_in_faces, live_protection;
  static std::vector<std::uint32_t> as_recorded(const std::set<Cell>& cells, int dimension);
  std::set<Cell>& of(const Event& e) {
    return e.kind == EventKind::kFaceChanged  ? live_in_faces
           : e.kind == EventKind::kProtection ? live_protection
                                              : live;
  }
};

namespace {

bool has_record(const Event& e) {
  return e.kind == EventKind::kInserted || e.kind == EventKind::kRelabeled ||
         e.kind == EventKind::kFaceChanged || e.kind == EventKind::kProtection;
}

}  // namespace

Replay::Replay(const Trace& trace) : trace_(&trace), state_(std::make_unique<State>()) {}
Replay::~Replay() = default;

/// Takes the simplices [first, first + out) from the live ones and adds the `in` that follow or
/// precede them.
void Replay::exchange(const Event& e, std::size_t out_at, std::size_t out, std::size_t in_at,
                      std::size_t in) {
  const auto d = static_cast<std::size_t>(trace_->dimension);
  const auto cell = [&](std::size_t at) {
    State::Cell c{};
    std::copy_n(trace_->simplices.begin() + static_cast<std::ptrdiff_t>(at), d + 2,
                c.as_recorded.begin());
    const auto& r = c.as_recorded;
    if (e.kind == EventKind::kFaceChanged) {
      c.key = {r[4] / 4, r[0], r[1], r[2], kNoIndex};
      std::sort(c.key.begin() + 1, c.key.begin() + 4);
    } else if (e.kind == EventKind::kProtection) {
      c.key = {r[4], r[3], r[0], r[1], r[2]};
      std::sort(c.key.begin() + 2, c.key.end());
    } else {
      c.key = {r[0], r[1], r[2], d == 3 ? r[3] : kNoIndex, kNoIndex};
      std::sort(c.key.begin(), c.key.end());
    }
    return c;
  };
  for (std::size_t i = 0; i < out; ++i) state_->of(e).erase(cell(out_at + i * (d + 2)));
  for (std::size_t i = 0; i < in; ++i) state_->of(e).insert(cell(in_at + i * (d + 2)));
}

bool Replay::forward() {
  if (position_ == trace_->events.size()) return false;
  const Event& e = trace_->events[position_++];
  if (!has_record(e)) return true;
  const auto stride = static_cast<std::size_t>(trace_->dimension) + 2;
  const std::size_t born_at = stream_ + e.other[0] * stride;
  exchange(e, stream_, e.other[0], born_at, e.other[1]);
  stream_ = born_at + e.other[1] * stride;
  if (e.kind == EventKind::kInserted) vertices_[e.subject] = {e.at[0], e.at[1], e.at[2]};
  return true;
}

bool Replay::backward() {
  if (position_ == 0) return false;
  const Event& e = trace_->events[--position_];
  if (!has_record(e)) return true;
  const auto stride = static_cast<std::size_t>(trace_->dimension) + 2;
  const std::size_t born_at = stream_ - e.other[1] * stride;
  const std::size_t died_at = born_at - e.other[0] * stride;
  exchange(e, born_at, e.other[1], died_at, e.other[0]);
  stream_ = died_at;
  if (e.kind == EventKind::kInserted) vertices_.erase(e.subject);
  return true;
}

void Replay::seek(std::size_t position) {
  position = std::min(position, trace_->events.size());
  while (position_ < position) forward();
  while (position_ > position) backward();
}

std::vector<std::uint32_t> Replay::State::as_recorded(const std::set<Cell>& cells, int dimension) {
  std::vector<std::uint32_t> all;
  for (const Cell& c : cells) {
    all.insert(all.end(), c.as_recorded.begin(), c.as_recorded.begin() + dimension + 2);
  }
  return all;
}

std::vector<std::uint32_t> Replay::cells() const {
  return State::as_recorded(state_->live, trace_->dimension);
}

std::vector<std::uint32_t> Replay::face_triangles() const {
  return State::as_recorded(state_->live_in_faces, trace_->dimension);
}

std::vector<ProtectingElement> Replay::protection() const {
  std::vector<ProtectingElement> all;
  for (const State::Cell& c : state_->live_protection) {
    const auto& r = c.as_recorded;
    all.push_back({static_cast<ProtectingKind>(r[4]), r[0], r[1], r[2], r[3]});
  }
  return all;
}

}  // namespace circumball
