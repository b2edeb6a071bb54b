#ifndef CIRCUMBALL_REFINEMENT_LOOP_H_
#define CIRCUMBALL_REFINEMENT_LOOP_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "refinement/account.h"
#include "refinement/agenda2.h"
#include "refinement/stage.h"

namespace circumball {

/// Whether what the rules of a loop still call unacceptable is the run's to account for: not, where
/// they only improve a mesh that is as promised.
enum class Account : std::uint8_t { kNone, kUnresolved };

/// Algorithm 2.2, the generic Delaunay refinement algorithm, in the plane and in space:
///
///   queue every unacceptable simplex
///   while the queue is not empty
///     take the simplex of highest priority
///     if it has died or become acceptable, drop it
///     if it is not safe to split, drop it
///     otherwise perform its action: insert a vertex, or queue other simplices instead
///     queue every simplex that became unacceptable
///
/// `Rules` states the four rules, as pure queries over the view of its world, for each kind of
/// simplex that the world has (see ruppert.h; for the rest of what is asked of it, agenda2.h and
/// agenda3.h):
/// - unacceptable(View, simplex) -> Verdict
/// - safe(View, simplex) -> Verdict (kNone: safe)
/// - action(View, simplex) -> Proposal
/// Priority is stated to the agenda.
template <class Rules, class World = Plane>
class Loop final : public StageOf<World> {
 public:
  using Workspace = WorkspaceOf<World>;
  using View = typename World::View;
  using Point = typename World::Point;
  using Agenda = typename World::template Agenda<Rules>;

  Loop(std::string name, std::string title, Rules rules, Account account = Account::kUnresolved)
      : StageOf<World>(std::move(name), std::move(title)),
        rules_(std::move(rules)),
        account_(account) {}

  void begin(Workspace& w) override {
    view_.emplace(w.live, w.recorder.on());
    agenda_.begin(w.live);
    agenda_.for_each_simplex(w.live, rules_, [&](auto s) { queue_if_unacceptable(w, s); });
  }

  bool advance(Workspace& w, Budget& budget) override {
    for (;;) {
      w.queued = agenda_.size();
      if (agenda_.empty() && !look_again(w)) return true;
      if (!budget.spend() || !w.within_limits()) return false;
      ++w.iterations;
      agenda_.take(w.live, [&](auto s, auto proposer) { process(w, s, proposer); });
    }
  }

  bool has_rules() const override { return account_ == Account::kUnresolved; }

  void unresolved(const Workspace& w, const std::string& stop, std::size_t max,
                  std::vector<Unresolved>* list) const override {
    if (Agenda::kNeedsBegin && !view_) return;  // what it looks at is not kept yet
    const View view(w.live, false);
    agenda_.for_each_simplex(w.live, rules_, [&](auto s) {
      if (list->size() >= max) return;
      if (const Verdict why = rules_.unacceptable(view, s)) {
        list->push_back(account_for(w.live, s, why.reason, refusal_of(s), stop));
      }
    });
  }

 private:
  /// Why a simplex was refused; kNone if it was not.
  template <class Simplex>
  Reason refusal_of(const Simplex& s) const {
    const auto found = refusals_.find(View::key(s));
    return found == refusals_.end() ? Reason::kNone : found->second;
  }

  template <class Simplex, class Proposer>
  void process(Workspace& w, const Simplex& s, const Proposer& proposer) {
    if (!view_->alive(s)) {
      // Whatever is not a subsegment leaves the queue without an event when it dies.
      if constexpr (std::is_same_v<Simplex, SubsegmentId>) w.recorder.dropped(s, Reason::kDied);
      return;
    }
    Verdict why = view_->in_domain(s) ? rules_.unacceptable(*view_, s) : Verdict{};
    if (!why) why = agenda_.remembered(*view_, rules_, s);
    // What a circumcenter yielded to is split, as long as the simplex that proposed it is alive.
    if (!why && !view_->alive(proposer)) {
      view_->found_acceptable(s);
      return w.recorder.dropped(s, Reason::kAcceptable);
    }
    if (const Verdict unsafe = rules_.safe(*view_, s)) return refuse(w, s, unsafe.reason, Point());
    const auto p = rules_.action(*view_, s);
    switch (p.kind) {
      case ProposalKind::kRefuse:
        return refuse(w, s, p.reason, p.at);
      case ProposalKind::kYield:
        // Subsegments have nothing to yield to.
        if constexpr (Agenda::kYields && !std::is_same_v<Simplex, SubsegmentId>) {
          return yield(w, s, p);
        }
        return refuse(w, s, p.reason, p.at);
      case ProposalKind::kInsert:
        if (!view_->ready(p.at, s)) return refuse(w, s, Reason::kPrecision, p.at);
        if (too_close(w, p.at)) return refuse(w, s, Reason::kMinEdge, p.at);
        agenda_.insert(w, *view_, rules_, s, p,
                       [&](auto changed, const Verdict& v) { queue(w, changed, v); });
    }
  }

  /// The circumcenter yields to what it encroaches, and the simplex that proposed it goes back to
  /// the queue.
  template <class Simplex, class Yield>
  void yield(Workspace& w, const Simplex& t, const Yield& p) {
    bool queued = false;
    view_->for_each_encroached([&](const auto& s) {
      if (!view_->may_split(s)) return;
      queued = true;
      w.recorder.yielded(t, p.at, s);
      w.recorder.queued(s, {Reason::kYieldedTo, VertexId(), 0});
      agenda_.push_yielded(s, t);
    });
    if (!queued) return refuse(w, t, Reason::kFrozen, p.at);
    ++w.yielded;
    const Verdict why = rules_.unacceptable(*view_, t);
    w.recorder.queued(t, {Reason::kReturned, VertexId(), why.value});
    agenda_.push_front(t, why.value);
  }

  template <class Simplex>
  void refuse(Workspace& w, const Simplex& s, Reason why, const Point& at) {
    ++w.refused;
    if (why == Reason::kMinEdge) w.refusal_limit = Reason::kLimitMinEdge;
    if (why == Reason::kPrecision && w.refusal_limit == Reason::kNone) {
      w.refusal_limit = Reason::kLimitPrecision;
    }
    agenda_.refused(w.live, s, why);
    refusals_[View::key(s)] = why;
    w.recorder.refused(s, why, at);
  }

  bool too_close(const Workspace& w, const Point& p) const {
    return w.limits.min_edge > 0 && view_->insertion_radius(p) < w.limits.min_edge;
  }

  /// Rules that look deeper than the simplices that touch a new vertex are asked once more about
  /// everything when the queue runs empty.
  bool look_again(Workspace& w) {
    agenda_.look_again(w, *view_, rules_, [&](auto s, const Verdict& why) { queue(w, s, why); });
    return !agenda_.empty();
  }

  template <class Simplex>
  void queue_if_unacceptable(Workspace& w, const Simplex& s) {
    if (const Verdict why = rules_.unacceptable(*view_, s)) queue(w, s, why);
  }
  template <class Simplex>
  void queue(Workspace& w, const Simplex& s, const Verdict& why) {
    if (agenda_.push(*view_, rules_, s, why)) w.recorder.queued(s, why);
  }

  Rules rules_;
  Account account_;
  std::optional<View> view_;
  Agenda agenda_;
  std::map<std::uint64_t, Reason> refusals_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINEMENT_LOOP_H_
