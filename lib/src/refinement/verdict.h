#ifndef CIRCUMBALL_REFINEMENT_VERDICT_H_
#define CIRCUMBALL_REFINEMENT_VERDICT_H_

#include "circumball/trace.h"
#include "circumball/types.h"

/// What rules say, in the plane and in space.
namespace circumball {

/// The answer of an Unacceptability or Safety rule: a reason (kNone: acceptable, safe), its
/// witness, a measure.
struct Verdict {
  Reason reason = Reason::kNone;
  VertexId witness;
  double value = 0;
  explicit operator bool() const { return reason != Reason::kNone; }
};

/// The answer of an Action rule: insert `at`, or queue what it encroaches instead, or nothing.
enum class ProposalKind : std::uint8_t { kInsert, kYield, kRefuse };
template <class Point>
struct ProposalOf {
  ProposalKind kind = ProposalKind::kRefuse;
  Reason reason = Reason::kNone;
  Point at;
  Feature feature = {};  ///< that a vertex inserted for a cell lies on
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_VERDICT_H_
