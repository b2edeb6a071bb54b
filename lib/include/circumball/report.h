#ifndef CIRCUMBALL_REPORT_H_
#define CIRCUMBALL_REPORT_H_

#include <cstddef>
#include <string>
#include <vector>

#include "circumball/complex.h"
#include "circumball/mesh.h"
#include "circumball/refine.h"
#include "circumball/verify.h"

/// What a run has to say for itself: the report of the command and of the page, and the checks that
/// it promises.
namespace circumball {

/// Version of the library, "major.minor.patch".
const char* version();

/// The checks that the registry promises for the algorithm of a run, with the run's own tau, size
/// and domain. Excused are the cells that Safety rightly refused; what a limit or a cancellation
/// left over is not. O(u log u) for u unresolved simplices.
VerifyOptions promised_checks(const Run& run);

struct ReportOptions {
  std::size_t max_unresolved =
      1000;                      ///< how many unresolved simplices are listed; the total is told
  bool worst_offenders = false;  ///< adds to each check the vertices of its worst offender
  int indent = 2;                ///< spaces; negative: all on one line
};

/// The report as JSON: schema 1, keys in the order in which the manual of the command shows them.
/// `mesh` is what `run.mesh()` returned, before any compaction: its fingerprint and measures are
/// reported. O(n log n) for n cells.
std::string report_json(const Run& run, const Complex& input, const Mesh& mesh,
                        const std::vector<Check>& checks, const ReportOptions& options = {});

/// The estimates of a run of `feature-size`, as comma-separated values with a line of names. In
/// space one line for every subsegment: its input segment, its ends, its length |s|, and what
/// Theorem 4.2 says of it, fs_1(s) >= |s| / sqrt 2 and lfs(s) >= 3/5 |s| (by Theorem 4.1 also
/// fs_1(s) <= 16 |s| or lfs(s) <= 4 |s|). In the plane one for every input vertex: N(q0), and N(q0)
/// / sqrt 2 <= lfs(q0) <= 2 N(q0) (Theorems 3.2 and 3.3). Lower bounds are empty unless the run is
/// complete.
std::string size_table(const Run& run, const Mesh& mesh);

/// "complete", "limit", "cancelled" or "running"; "hull", "box", "closed" or "default".
const char* name(Status status);
const char* name(Domain domain);
/// The limit that ended a run, as the manual names it: "vertices", "min-edge", "seconds",
/// "precision", "memory".
std::string limit_name(const Run& run);

}  // namespace circumball

#endif  // CIRCUMBALL_REPORT_H_
