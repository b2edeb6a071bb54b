#include "quality/chains.h"
#include "quality/context.h"
#include "quality/context3.h"

namespace circumball {

template <class Context>
Check check_input_segments(const Context& context) {
  Check check;
  check.name = "input-segments";
  check.bound = 0;
  const ChainFinder<Context> finder(context);
  std::size_t missing = 0, pieces = 0, labeled = 0, walked = 0, elsewhere = 0;
  for (std::uint32_t s = 0; s < context.complex.segments.size(); ++s) {
    if (!context.segment_wanted[s]) {
      ++elsewhere;
      continue;
    }
    const Chain chain = finder.find(s);
    if (chain.vertices.empty()) {
      if (missing++ > 0) continue;
      check.worst = chain.at;
      const auto& ends = context.complex.segments[s];
      check.detail = "input segment " + std::to_string(s) + " (" +
                     vertices_text({ends[0], ends[1]}) +
                     ") is not a union of edges: " + chain.problem;
      if (!chain.at.empty()) check.detail += " (vertices " + vertices_text(chain.at) + ")";
      continue;
    }
    pieces += chain.vertices.size() - 1;
    ++(chain.labeled ? labeled : walked);
  }
  check.ok = missing == 0;
  check.observed = static_cast<double>(missing);
  if (!check.ok) {
    if (missing > 1) check.detail += " (" + std::to_string(missing) + " such)";
    return check;
  }
  check.detail = count_text(labeled + walked, "input segment") +
                 ", each a union of edges in order, " + count_text(pieces, "subsegment") +
                 " in all";
  if (walked > 0)
    check.detail += "; " + std::to_string(walked) +
                    " without labels: vertices count as on them within 1e-9 of the diameter";
  if (elsewhere > 0)
    check.detail +=
        "; " + std::to_string(elsewhere) + " do not bound the domain, or repeat another";
  return check;
}

template Check check_input_segments(const VerifyContext&);
template Check check_input_segments(const VerifyContext3&);

}  // namespace circumball
