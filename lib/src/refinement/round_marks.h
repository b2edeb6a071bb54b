#ifndef CIRCUMBALL_REFINEMENT_ROUND_MARKS_H_
#define CIRCUMBALL_REFINEMENT_ROUND_MARKS_H_

#include <cstddef>
#include <cstdint>
#include <vector>

namespace circumball {

/// Which members of rows have been met in this round: to begin a round costs nothing, a member one
/// look. Rows and members are small numbers, such as faces and slots of their triangles.
class RoundMarks {
 public:
  void begin() { ++round_; }
  bool met(std::uint32_t row, std::uint32_t member) const {
    return row < marks_.size() && member < marks_[row].size() && marks_[row][member] == round_;
  }
  /// Whether the member was not met in this round yet; from now on it is.
  bool meet(std::uint32_t row, std::uint32_t member) {
    if (marks_.size() <= row) marks_.resize(row + std::size_t{row} / 2 + 1);
    auto& marks = marks_[row];
    if (marks.size() <= member) marks.resize(member + std::size_t{member} / 2 + 1, 0);
    if (marks[member] == round_) return false;
    marks[member] = round_;
    return true;
  }

 private:
  std::uint64_t round_ = 0;
  std::vector<std::vector<std::uint64_t>> marks_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_ROUND_MARKS_H_
