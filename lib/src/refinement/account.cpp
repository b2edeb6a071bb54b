#include "refinement/account.h"

namespace circumball {
namespace {

template <class Live>
Unresolved account(const Live& live, std::vector<std::uint32_t> simplex, Reason rule,
                   Reason refusal, const std::string& stop) {
  Unresolved u;
  u.rule = name(rule);
  u.reason = refusal == Reason::kNone ? stop : name(refusal);
  for (const std::uint32_t v : simplex) {
    const Feature& f = live.feature(VertexId(v));
    if (f.kind == FeatureKind::kVertex) {
      u.near = "input vertex " + std::to_string(f.index);
      break;
    }
    if (f.kind == FeatureKind::kSegment && u.near.empty()) {
      u.near = "input segment " + std::to_string(f.index);
    }
    if (f.kind == FeatureKind::kFace && u.near.empty()) {
      u.near = "input face " + std::to_string(f.index);
    }
  }
  u.simplex = std::move(simplex);
  return u;
}

}  // namespace

Unresolved account_for(const Live2& live, SubsegmentId s, Reason rule, Reason refusal,
                       const std::string& stop) {
  const Subsegment& u = live.subsegment(s);
  return account(live, {u.a.value, u.b.value}, rule, refusal, stop);
}

Unresolved account_for(const Live2& live, TriangleRef t, Reason rule, Reason refusal,
                       const std::string& stop) {
  const auto& v = live.triangulation().triangle(t.id).v;
  return account(live, {v[0].value, v[1].value, v[2].value}, rule, refusal, stop);
}

Unresolved account_for(const Live3& live, SubsegmentId s, Reason rule, Reason refusal,
                       const std::string& stop) {
  const Subsegment& u = live.subsegment(s);
  return account(live, {u.a.value, u.b.value}, rule, refusal, stop);
}

Unresolved account_for(const Live3& live, const FaceTriangle& t, Reason rule, Reason refusal,
                       const std::string& stop) {
  const FaceRefinement& face = live.face(t.face);
  std::vector<std::uint32_t> simplex;
  for (const VertexId v : face.triangulation().triangle(t.id).v) {
    simplex.push_back(face.global(v).value);
  }
  return account(live, simplex, rule, refusal, stop);
}

Unresolved account_for(const Live3& live, PatchId id, Reason rule, Reason refusal,
                       const std::string& stop) {
  std::vector<std::uint32_t> simplex;
  for (const VertexId v : live.intestine().patch(id).v) {
    if (v.valid()) simplex.push_back(v.value);
  }
  return account(live, simplex, rule, refusal, stop);
}

Unresolved account_for(const Live3& live, const CellRef& c, Reason rule, Reason refusal,
                       const std::string& stop) {
  std::vector<std::uint32_t> simplex;
  for (std::uint32_t i = 0; i < 4; ++i) {
    simplex.push_back(live.triangulation().corner(c.slot, i).value);
  }
  return account(live, simplex, rule, refusal, stop);
}

}  // namespace circumball
