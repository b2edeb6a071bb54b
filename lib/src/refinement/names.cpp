#include "circumball/trace.h"

namespace circumball {

const char* name(EventKind kind) {
  switch (kind) {
    case EventKind::kStepBegan:
      return "step-began";
    case EventKind::kStepEnded:
      return "step-ended";
    case EventKind::kQueued:
      return "queued";
    case EventKind::kDropped:
      return "dropped";
    case EventKind::kRefused:
      return "refused";
    case EventKind::kYielded:
      return "yielded";
    case EventKind::kInserted:
      return "inserted";
    case EventKind::kRelabeled:
      return "relabeled";
    case EventKind::kLimit:
      return "limit";
    case EventKind::kFaceChanged:
      return "face-changed";
    case EventKind::kProtection:
      return "protection";
  }
  return "unknown";
}

const char* name(ProtectingKind kind) {
  switch (kind) {
    case ProtectingKind::kCollarSegment:
      return "collar-segment";
    case ProtectingKind::kCollarArc:
      return "collar-arc";
    case ProtectingKind::kRingArc:
      return "ring-arc";
    case ProtectingKind::kSpherePatch:
      return "sphere-patch";
    case ProtectingKind::kTubePatch:
      return "tube-patch";
    case ProtectingKind::kProtectedSubsegment:
      return "protected-subsegment";
  }
  return "unknown";
}

const char* name(Reason reason) {
  switch (reason) {
    case Reason::kNone:
      return "none";
    case Reason::kEncroached:
      return "encroached";
    case Reason::kMissing:
      return "missing";
    case Reason::kRadiusEdge:
      return "radius-edge";
    case Reason::kSize:
      return "size";
    case Reason::kRegionSize:
      return "region-size";
    case Reason::kTooLong:
      return "too-long";
    case Reason::kYieldedTo:
      return "yielded-to";
    case Reason::kReturned:
      return "returned";
    case Reason::kWitness:
      return "witness";
    case Reason::kNearWitness:
      return "near-witness";
    case Reason::kNearLocalWitness:
      return "near-local-witness";
    case Reason::kNearVertex:
      return "near-vertex";
    case Reason::kSliver:
      return "sliver";
    case Reason::kInput:
      return "input";
    case Reason::kBox:
      return "box";
    case Reason::kMidpoint:
      return "midpoint";
    case Reason::kCircumcenter:
      return "circumcenter";
    case Reason::kOffCenter:
      return "off-center";
    case Reason::kDivision:
      return "division";
    case Reason::kCollar:
      return "collar";
    case Reason::kCircle:
      return "circle";
    case Reason::kArcMidpoint:
      return "arc-midpoint";
    case Reason::kEqualLength:
      return "equal-length";
    case Reason::kShell:
      return "shell";
    case Reason::kThird:
      return "third";
    case Reason::kPicked:
      return "picked";
    case Reason::kNoRoom:
      return "no-room";
    case Reason::kNotImproved:
      return "not-improved";
    case Reason::kMatching:
      return "matching";
    case Reason::kWide:
      return "wide";
    case Reason::kRing:
      return "ring";
    case Reason::kSeed:
      return "seed";
    case Reason::kSurface:
      return "surface";
    case Reason::kOutsideFace:
      return "outside-face";
    case Reason::kNearSegment:
      return "near-segment";
    case Reason::kOutsideDomain:
      return "outside-domain";
    case Reason::kProtected:
      return "protected";
    case Reason::kMinEdge:
      return "min-edge";
    case Reason::kPrecision:
      return "precision";
    case Reason::kFrozen:
      return "frozen";
    case Reason::kSeditious:
      return "seditious";
    case Reason::kDied:
      return "died";
    case Reason::kAcceptable:
      return "acceptable";
    case Reason::kLimitVertices:
      return "limit-vertices";
    case Reason::kLimitMinEdge:
      return "limit-min-edge";
    case Reason::kLimitSeconds:
      return "limit-seconds";
    case Reason::kLimitPrecision:
      return "limit-precision";
    case Reason::kLimitMemory:
      return "limit-memory";
    case Reason::kCancelled:
      return "cancelled";
  }
  return "unknown";
}

}  // namespace circumball
