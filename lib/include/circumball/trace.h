#ifndef CIRCUMBALL_TRACE_H_
#define CIRCUMBALL_TRACE_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "circumball/types.h"

/// The trace: everything that a run did, and why. Replaying it rebuilds the mesh exactly, forwards
/// and backwards.
namespace circumball {

enum class EventKind : std::uint8_t {
  kStepBegan = 0,  ///< `step` begins
  kStepEnded = 1,  ///< `subject` vertices inserted, `other[0]` refusals in the step
  kQueued = 2,     ///< `simplex` became unacceptable: `reason`, witness `subject`, `value`
  kDropped = 3,    ///< `simplex` was popped, and dropped: kDied or kAcceptable. Triangles that die
                   ///< leave the queue without an event
  kRefused =
      4,  ///< `simplex` was popped, and is not safe to split: `reason`; `at` is the refused point
  kYielded = 5,  ///< `simplex` proposed `at`, which encroaches subsegment `other` (input segment
                 ///< `subject`): that is queued, `simplex` goes back. In space also a triangle of
                 ///< face `subject`: two corners in `other`, and `value` is the third plus 1; of a
                 ///< subsegment `value` is 0
  kInserted =
      6,  ///< vertex `subject` inserted at `at`, splitting `simplex` (popped): died[other[0]],
          ///< born[other[1]] follow in the simplex stream; `value` is the insertion radius
  kRelabeled = 7,    ///< triangles (in space: tetrahedra) got a new domain label: as kInserted, but
                     ///< without a vertex
  kLimit = 8,        ///< a limit stopped the run: `reason`
  kFaceChanged = 9,  ///< in space, after the insertion that it belongs to (or at the end of step
                     ///< 0): died[other[0]], born[other[1]] triangles of the refinement of face
                     ///< `subject` follow in the simplex stream
  kProtection = 10,  ///< in space, after the insertion (and its face changes) that it belongs to,
                     ///< or at the end of a step: died[other[0]], born[other[1]] protecting
                     ///< elements follow in the simplex stream, each as a ProtectingElement
};

/// What a protecting element is (thesis, Table 6.1 and Section 6.3): the last number of its record.
enum class ProtectingKind : std::uint32_t {
  kCollarSegment = 0,        ///< a, b; `carrier` is the face
  kCollarArc = 1,            ///< from a to b about the input vertex c; `carrier` is the face
  kRingArc = 2,              ///< from a to b about the vertex c on the input segment `carrier`
  kSpherePatch = 3,          ///< a, b, c on the sphere about the input vertex `carrier`
  kTubePatch = 4,            ///< a, b, c on the tube about the input segment `carrier`
  kProtectedSubsegment = 5,  ///< a, b of the input segment `carrier`; never split any more
};
constexpr std::uint32_t kProtectingKinds = 6;

/// One element of what protects acute input features: a record of kProtection.
struct ProtectingElement {
  ProtectingKind kind = ProtectingKind::kCollarSegment;
  std::uint32_t a = kNoIndex, b = kNoIndex, c = kNoIndex;  ///< vertices
  std::uint32_t carrier = kNoIndex;                        ///< by its kind
};

/// Why: one list for all kinds of events.
enum class Reason : std::uint8_t {
  kNone = 0,
  // why a simplex is unacceptable
  kEncroached = 1,  ///< `subject` lies in the diametral ball
  kMissing = 2,     ///< the subsegment is not an edge of the Delaunay triangulation
  kRadiusEdge = 3,  ///< `value` = circumradius / shortest edge > tau
  kSize = 4,        ///< `value` = circumradius > size bound
  kRegionSize = 5,  ///< `value` = area > the bound of its region
  kTooLong = 6,     ///< the subsegment is longer than the algorithm allows: `value` = length
  kYieldedTo = 7,   ///< a circumcentre yielded to it
  kReturned = 8,    ///< its circumcentre yielded: it waits for that split at the head of the queue
  kWitness = 9,     ///< `subject` lies in its diametral disk and is a 1-feature size witness for it
  kNearWitness = 10,       ///< a Delaunay neighbor `subject` of an end of it, or of its spindle, is
                           ///< nearer than its length, and a 1-feature size witness for it (4.2);
                           ///< `value` = that distance
  kNearLocalWitness = 11,  ///< the same, a local feature size witness (4.3)
  kNearVertex =
      12,  ///< a vertex of this triangle of a face has a Delaunay neighbor `subject` outside
           ///< of the face, nearer than its circumdiameter (4.3); `value` = that distance
  kMatching = 14,  ///< kRelabeled: other tetrahedra take the place of the Delaunay ones in tubes,
                   ///< and match what is around (thesis, Theorem 6.15)
  kWide = 13,      ///< a patch of a sphere has an angular radius above 45 degrees
  kSliver = 15,    ///< `value` = smallest dihedral angle in degrees < the bound
  // where a vertex was inserted
  kInput = 16,         ///< an input vertex (step 0)
  kBox = 17,           ///< a corner of the box
  kMidpoint = 18,      ///< midpoint of a subsegment
  kCircumcenter = 19,  ///< circumcentre of a triangle
  kOffCenter = 20,     ///< off-centre of a triangle
  kDivision = 21,      ///< one of the points that divide a segment into equal parts
  kCollar = 22,        ///< on a segment at an acute input angle, at the distance that protects it
  kCircle = 23,        ///< on the circle that protects an acute input angle, off the segments
  kArcMidpoint = 24,   ///< midpoint of an arc of such a circle
  kEqualLength = 25,   ///< on a segment, so that adjacent segments get pieces of equal lengths
  kShell = 26,         ///< on a segment, on a concentric shell about its input vertex
  kThird = 27,         ///< on a segment, a third of N(q0) from its input vertex q0 (4.1, step 1a)
  kRing = 28,          ///< on a ring about a segment that is protected
  kSeed = 29,          ///< on the sphere about a protected input vertex, where nothing else is near
  kSurface = 30,       ///< the projection of a circumcenter onto the sphere or tube of its patch
  kPicked = 31,        ///< near the circumcenter of a tetrahedron, so that slivers become fewer
  // why a simplex was refused
  kOutsideDomain = 32,  ///< its circumcentre lies outside what is meshed
  kProtected = 33,      ///< only protected simplices are in the way
  kMinEdge = 34,        ///< it would make an edge shorter than --min-edge
  kPrecision = 35,    ///< the new vertex would coincide with another one, or leave its segment, in
                      ///< double precision
  kFrozen = 36,       ///< it would yield to a subsegment that was refused itself
  kSeditious = 37,    ///< its shortest edge joins two segments of a small angle, on one shell
  kOutsideFace = 38,  ///< its circumcenter lies outside of its face
  kNearSegment = 39,  ///< its circumcenter would have an end of a segment of its face for a
                      ///< Delaunay neighbor, nearer than that segment is long
  kNoRoom = 46,       ///< all points tried encroach upon segments or faces, or lie outside
  kNotImproved = 47,  ///< no point tried leaves fewer slivers and keeps all else
  // why a simplex was dropped
  kDied = 48,
  kAcceptable = 49,
  // limits
  kLimitVertices = 64,
  kLimitMinEdge = 65,
  kLimitSeconds = 66,
  kLimitPrecision = 67,
  kLimitMemory = 68,
  kCancelled = 69,
};

/// One event: 64 bytes, little-endian on every platform that we build for.
struct Event {
  EventKind kind = EventKind::kStepBegan;
  std::uint8_t dimension = 0;  ///< of `simplex`: 0 vertex, 1 subsegment, 2 triangle, 3 tetrahedron
  Reason reason = Reason::kNone;
  std::uint8_t step = 0;  ///< index into Trace::steps
  std::uint32_t simplex[4] = {
      kNoIndex, kNoIndex, kNoIndex,
      kNoIndex};  ///< vertices; a subsegment has its input segment in simplex[3]; an arc (kNoIndex
                  ///< there) the center of its circle, an input vertex, in simplex[2]; an arc of
                  ///< a ring has both, the segment and a vertex on it; in space a
                  ///< triangle of a face has the face in simplex[3]; a vertex that splits nothing
                  ///< and protects (kCollar, kCircle, kRing, kSeed) has in simplex[0] the vertex of
                  ///< the segment that it stands across from, in simplex[1] the input vertex whose
                  ///< circle it lies on, in simplex[3] the face, as far as there are such
  std::uint32_t subject = kNoIndex;
  std::uint32_t other[2] = {kNoIndex, kNoIndex};
  double at[3] = {0, 0, 0};
  double value = 0;
};
static_assert(sizeof(Event) == 64, "events are fixed-size records");

/// Receives events as they happen. A null sink costs one predictable branch an event.
class TraceSink {
 public:
  virtual ~TraceSink() = default;
  /// One event. For kInserted and kRelabeled, `simplices` holds the dead, then the born: (dimension
  /// + 2) numbers each, the vertices (counter-clockwise) and the domain label (0 unknown, 1 inside,
  /// 2 outside). Simplices at infinity are left out. For kFaceChanged, triangles: three vertices,
  /// counter-clockwise about the normal of the face, kNoIndex, and 4 * face + label (1 inside of
  /// the polygon, 2 outside of it). For kProtection, elements: a, b, c, carrier, kind.
  virtual void event(const Event& event, const std::uint32_t* simplices, std::size_t count) = 0;
};

/// A recorded trace, in memory.
struct Trace final : TraceSink {
  int dimension = 2;
  std::vector<std::string> steps;  ///< names of the steps, by Event::step
  std::vector<Event> events;
  std::vector<std::uint32_t> simplices;  ///< the simplex stream: (dimension + 2) numbers a simplex
  void event(const Event& e, const std::uint32_t* simplices, std::size_t count) override;
};

/// Binary form of a trace ("circumball-trace 1"), and back. `trace_from_bytes` fails with a
/// sentence in `error`.
std::string to_bytes(const Trace& trace);
bool trace_from_bytes(const std::string& bytes, Trace* trace, std::string* error);
/// One JSON object a line.
std::string to_jsonl(const Trace& trace);
/// The sentence of an event, as the page shows it: what happened and why, in the words of the four
/// rules.
std::string describe(const Event& event, const std::vector<std::string>& steps);
/// Names of the enumerators, kebab-case ("radius-edge").
const char* name(EventKind kind);
const char* name(Reason reason);
const char* name(ProtectingKind kind);

/// Rebuilds the state of a run from its trace, forwards and backwards. The trace must outlive it,
/// and come from a run or from `trace_from_bytes`. A step costs O(k log n) for k dead and born
/// cells.
class Replay {
 public:
  explicit Replay(const Trace& trace);
  ~Replay();
  std::size_t position() const { return position_; }  ///< events applied
  bool forward();                                     ///< applies the next event; false at the end
  bool backward();  ///< takes the last one back; false at the start
  void seek(std::size_t position);
  /// The live cells, (dimension + 2) numbers each as recorded (vertices, domain label), sorted by
  /// their vertices.
  std::vector<std::uint32_t> cells() const;
  /// In space, the live triangles of the refinements of faces, as recorded, by face and vertices.
  std::vector<std::uint32_t> face_triangles() const;
  /// In space, the live protecting elements, by kind, carrier and vertices.
  std::vector<ProtectingElement> protection() const;
  /// The vertices inserted so far, by number.
  const std::map<std::uint32_t, Point3>& vertices() const { return vertices_; }

 private:
  struct State;
  void exchange(const Event& event, std::size_t out_at, std::size_t out, std::size_t in_at,
                std::size_t in);
  const Trace* trace_;
  std::unique_ptr<State> state_;
  std::size_t position_ = 0;
  std::size_t stream_ = 0;  // where the next event's simplices begin
  std::map<std::uint32_t, Point3> vertices_;
};

}  // namespace circumball

#endif  // CIRCUMBALL_TRACE_H_
