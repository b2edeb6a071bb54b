#ifndef CIRCUMBALL_REFINEMENT_QUEUE_H_
#define CIRCUMBALL_REFINEMENT_QUEUE_H_

#include <algorithm>
#include <cstdint>
#include <vector>

#include "refinement/view.h"

/// The queues of Algorithm 2.2: subsegments before triangles; ties by order of birth, so that a run
/// is reproducible.
namespace circumball {

/// First in, first out, with a way back to the front. Amortized O(1), no allocation once grown.
template <class T>
class FifoQueue {
 public:
  bool empty() const { return size_ == 0; }
  std::size_t size() const { return size_; }
  void push(const T& item) {
    if (size_ == ring_.size()) grow();
    ring_[(head_ + size_++) & (ring_.size() - 1)] = item;
  }
  void push_front(const T& item) {
    if (size_ == ring_.size()) grow();
    head_ = (head_ - 1) & (ring_.size() - 1);
    ring_[head_] = item;
    ++size_;
  }
  T pop() {
    const T item = ring_[head_];
    head_ = (head_ + 1) & (ring_.size() - 1);
    --size_;
    return item;
  }

 private:
  void grow() {
    std::vector<T> larger(ring_.empty() ? 64 : 2 * ring_.size());
    for (std::size_t i = 0; i < size_; ++i) larger[i] = ring_[(head_ + i) & (ring_.size() - 1)];
    ring_.swap(larger);
    head_ = 0;
  }
  std::vector<T> ring_;  // a power of two
  std::size_t head_ = 0, size_ = 0;
};

/// Triangles in order of birth.
class TrianglesByBirth {
 public:
  bool empty() const { return queue_.empty(); }
  std::size_t size() const { return queue_.size(); }
  void push(TriangleRef t, double) { queue_.push(t); }
  void push_front(TriangleRef t, double) { queue_.push_front(t); }
  TriangleRef pop() { return queue_.pop(); }

 private:
  FifoQueue<TriangleRef> queue_;
};

/// Triangles by a value, the largest first; among equals the oldest.
class TrianglesByValue {
 public:
  bool empty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  void push(TriangleRef t, double value) {
    heap_.push_back({value, t});
    std::push_heap(heap_.begin(), heap_.end());
  }
  void push_front(TriangleRef t, double value) { push(t, value); }
  TriangleRef pop() {
    std::pop_heap(heap_.begin(), heap_.end());
    const TriangleRef t = heap_.back().triangle;
    heap_.pop_back();
    return t;
  }

 private:
  struct Item {
    double value;
    TriangleRef triangle;
    // A total order: the heap's order does not depend on the library's heap.
    friend bool operator<(const Item& a, const Item& b) {
      return a.value != b.value ? a.value < b.value : a.triangle.birth > b.triangle.birth;
    }
  };
  std::vector<Item> heap_;
};

/// A subsegment in the queue: because it is unacceptable, or because the circumcentre of `proposer`
/// yields to it.
struct QueuedSubsegment {
  SubsegmentId subsegment;
  TriangleRef proposer;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_QUEUE_H_
