#ifndef CIRCUMBALL_REFINE_H_
#define CIRCUMBALL_REFINE_H_

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "circumball/mesh.h"
#include "circumball/trace.h"

/// Delaunay refinement of a complex by an algorithm of the registry.
namespace circumball {

struct Limits {
  std::uint64_t max_vertices = 10'000'000;  ///< 0: none
  double min_edge = 0;                      ///< no edge shorter than this is made; 0: none
  double max_seconds = 0;                   ///< 0: none
  std::uint64_t max_bytes = 0;              ///< of the kernel's arrays; 0: none
};

struct Options {
  std::string algorithm;      ///< id of the registry; empty: the default for the input (cli.md)
  std::optional<double> tau;  ///< radius-edge threshold; default: from min_angle_degrees
  std::optional<double> min_angle_degrees;  ///< in the plane: tau = 1 / (2 sin). Default 20.7
  std::string
      size;  ///< upper bound on the circumradius: a number, or an expression in x, y; empty: none
  Domain domain = Domain::kDefault;
  Limits limits;
  std::map<std::string, std::string> parameters;  ///< any other that the registry lists
};

enum class Status : std::uint8_t { kRunning, kComplete, kLimit, kCancelled };

struct StepReport {
  std::string name, title;
  std::uint64_t vertices = 0;  ///< in the triangulation when the step ended
  std::uint64_t inserted = 0, refused = 0, yielded = 0;
  double seconds = 0;
};

/// A simplex that is still unacceptable, and why it was not split.
struct Unresolved {
  std::vector<std::uint32_t> simplex;
  std::string rule;    ///< why it is unacceptable (a name of Reason)
  std::string reason;  ///< why it was not split (a name of Reason)
  std::string near;    ///< e.g. "input vertex 7"
};

/// What the step that removes slivers (parameter `slivers`) has to say.
struct SliverRemoval {
  double degrees = 0;            ///< with a smaller dihedral angle a cell is a sliver
  DihedralHistogram before;      ///< of the mesh when the step began
  std::vector<Unresolved> kept;  ///< slivers that are there still, and why
};

struct Progress {
  std::string step;
  std::uint64_t vertices = 0, queued = 0, iterations = 0;
  double seconds = 0;
};

/// One run of one algorithm on one complex; it can be advanced by steps, stopped, watched and asked
/// for its mesh at any moment. Never throws on input.
class Run {
 public:
  /// Checks complex and options. On failure returns null and fills `defects` (input) or `error`
  /// (options).
  static std::unique_ptr<Run> create(const Complex& complex, const Options& options,
                                     TraceSink* sink, std::vector<Defect>* defects,
                                     std::string* error);
  ~Run();

  /// Performs up to `iterations` iterations of the loop (0: until the end), and at most about
  /// `seconds` (0: no bound).
  Status advance(std::uint64_t iterations = 0, double seconds = 0);
  /// May be called from another thread or a signal handler; the next iteration ends the run with
  /// kCancelled.
  void cancel();

  Status status() const;
  Reason limit() const;  ///< which limit was reached
  Progress progress() const;
  const std::vector<std::string>& step_names() const;
  const std::vector<StepReport>& steps() const;

  /// The mesh so far (valid, Delaunay), restricted to the domain.
  Mesh mesh() const;
  /// What is still unacceptable, at most `max` of it.
  std::vector<Unresolved> unresolved(std::size_t max = 1000) const;
  /// Of the step that removes slivers: nothing where there is none, or it has not begun. At most
  /// `max` of the slivers that it left.
  std::optional<SliverRemoval> sliver_removal(std::size_t max = 1000) const;
  /// The complex that is refined: the input, and the box where one was added.
  const Complex& complex() const;
  const Options& options() const;  ///< with every default filled in
  double tau() const;
  Domain domain() const;
  /// False where a run in space was stopped, or something refused, before faces kept inside and
  /// outside (or regions) apart: mesh() is all of the convex hull then, without regions.
  bool domain_known() const;
  std::uint64_t peak_bytes() const;

 private:
  Run();
  struct Impl;
  template <class World>
  struct ImplOf;
  std::unique_ptr<Impl> impl_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_REFINE_H_
