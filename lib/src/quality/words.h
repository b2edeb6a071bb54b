#ifndef CIRCUMBALL_QUALITY_WORDS_H_
#define CIRCUMBALL_QUALITY_WORDS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// Tolerances and words that the checks share.
namespace circumball {

/// A vertex counts as on a segment or face within this, relative to the diameter, where no label
/// says so (architecture.md, "Numbers").
constexpr double kOnSegment = 1e-9;
/// Distances between vertices that were rounded onto segments and circles are held against a bound
/// with this slack, relative (architecture.md, "Numbers"): where a theorem's bound is attained,
/// rounding decides.
constexpr double kRoundedPosition = 1e-10;
/// Areas and volumes agree within this, relative (circumball/verify.h).
constexpr double kAreaTolerance = 1e-9;

// Words for the sentences.
std::string vertices_text(const std::vector<std::uint32_t>& vertices);  ///< "5, 7 and 9"
std::string count_text(std::size_t n, const char* thing);               ///< "1 cell", "2 cells"
std::string value_text(double value);                                   ///< six digits

}  // namespace circumball

#endif  // CIRCUMBALL_QUALITY_WORDS_H_
