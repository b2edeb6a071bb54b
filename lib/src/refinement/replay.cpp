#include <algorithm>
#include <array>
#include <set>

#include "circumball/trace.h"

namespace circumball {

/// The live cells, each with its vertices in ascending order (its identity) and as it was recorded.
struct Replay::State {
  struct Cell {
    std::array<std::uint32_t, 4> key;
    std::array<std::uint32_t, 5> as_recorded;
    friend bool operator<(const Cell& a, const Cell& b) { return a.key < b.key; }
  };
  std::set<Cell> live;
};

namespace {

bool has_record(const Event& e) {
  return e.kind == EventKind::kInserted || e.kind == EventKind::kRelabeled;
}

}  // namespace

Replay::Replay(const Trace& trace) : trace_(&trace), state_(std::make_unique<State>()) {}
Replay::~Replay() = default;

/// Takes the simplices [first, first + out) from the live ones and adds the `in` that follow or
/// precede them.
void Replay::exchange(std::size_t out_at, std::size_t out, std::size_t in_at, std::size_t in) {
  const auto d = static_cast<std::size_t>(trace_->dimension);
  const auto cell = [&](std::size_t at) {
    State::Cell c{};
    c.key.fill(kNoIndex);
    std::copy_n(trace_->simplices.begin() + static_cast<std::ptrdiff_t>(at), d + 2,
                c.as_recorded.begin());
    std::copy_n(c.as_recorded.begin(), d + 1, c.key.begin());
    std::sort(c.key.begin(), c.key.end());
    return c;
  };
  for (std::size_t i = 0; i < out; ++i) state_->live.erase(cell(out_at + i * (d + 2)));
  for (std::size_t i = 0; i < in; ++i) state_->live.insert(cell(in_at + i * (d + 2)));
}

bool Replay::forward() {
  if (position_ == trace_->events.size()) return false;
  const Event& e = trace_->events[position_++];
  if (!has_record(e)) return true;
  const auto stride = static_cast<std::size_t>(trace_->dimension) + 2;
  const std::size_t born_at = stream_ + e.other[0] * stride;
  exchange(stream_, e.other[0], born_at, e.other[1]);
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
  exchange(born_at, e.other[1], died_at, e.other[0]);
  stream_ = died_at;
  if (e.kind == EventKind::kInserted) vertices_.erase(e.subject);
  return true;
}

void Replay::seek(std::size_t position) {
  position = std::min(position, trace_->events.size());
  while (position_ < position) forward();
  while (position_ > position) backward();
}

std::vector<std::uint32_t> Replay::cells() const {
  std::vector<std::uint32_t> all;
  const auto stride = static_cast<std::size_t>(trace_->dimension) + 2;
  for (const State::Cell& c : state_->live) {
    all.insert(all.end(), c.as_recorded.begin(),
               c.as_recorded.begin() + static_cast<std::ptrdiff_t>(stride));
  }
  return all;
}

}  // namespace circumball
