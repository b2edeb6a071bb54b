#ifndef CIRCUMBALL_QUALITY_CHAINS_H_
#define CIRCUMBALL_QUALITY_CHAINS_H_

#include <cstdint>
#include <string>
#include <vector>

namespace circumball {

/// The mesh edges that an input segment is made of.
struct Chain {
  std::vector<std::uint32_t>
      vertices;                   ///< from the first to the second end; empty where it is broken
  bool labeled = false;           ///< from the mesh's own labels; else by distance
  std::string problem;            ///< why it is broken
  std::vector<std::uint32_t> at;  ///< mesh vertices where it is broken
};

/// Walks the segments of a complex along edges of the mesh. `Context` is VerifyContext or
/// VerifyContext3.
template <class Context>
class ChainFinder {
 public:
  explicit ChainFinder(const Context& context);
  Chain find(std::uint32_t segment) const;
  /// Along the straight line between two mesh vertices, by distance.
  Chain between(std::uint32_t a, std::uint32_t b) const;

 private:
  Chain find_labeled(std::uint32_t segment, std::uint32_t a, std::uint32_t b) const;

  const Context& context_;
  std::vector<std::uint32_t> label_first_, label_edge_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_CHAINS_H_
