#include "algorithms/registry3.h"

namespace circumball {

std::vector<AlgorithmInfo> algorithms_in_space() {
  const ParameterInfo box{"box-scale", "3", "1.5", "1000",
                          "side of the box of the domain `box`, in sizes of the input"};

  AlgorithmInfo delaunay;
  delaunay.id = "delaunay";
  delaunay.title = "Delaunay tetrahedralization";
  delaunay.dimension = 3;
  delaunay.thesis = "Step 0 (Definition 2.1.1)";
  delaunay.action = "Insert the next input vertex.";
  delaunay.priority = "Along a space-filling curve: any order gives the same tetrahedralization.";
  delaunay.unacceptability =
      "A tetrahedron is unacceptable if its circumball holds an input vertex.";
  delaunay.safety = "It is safe to insert any vertex.";
  delaunay.parameters = {box};
  delaunay.guarantee =
      "The circumball of every tetrahedron is empty; exactly, whatever the input. Segments and "
      "faces are not enforced.";
  delaunay.checks = {"topology", "delaunay", "input-vertices", "volume"};
  delaunay.default_domain = "hull";

  AlgorithmInfo feature_size = delaunay;
  feature_size.id = "feature-size";
  feature_size.title = "Feature size estimate";
  feature_size.thesis = "Algorithms 4.1, 4.2 and 4.3";
  feature_size.action =
      "Steps 1b and 2b: insert the circumcenter of a segment or of a triangle of a face. (Step 1a "
      "splits segments at $N(q_0)/3$ from their input vertices, step 2a into four equal parts.)";
  feature_size.priority =
      "Step 1b: longer segments are processed first. Step 2b: triangles are given highest "
      "priority, "
      "in any order; segments are then prioritized by length.";
  feature_size.unacceptability =
      "Step 1b: a segment $s$ is unacceptable if an endpoint $q$ of a segment in "
      "$\\mathrm{Spind}(s)$ "
      "has a Delaunay neighbor $p$ with $|q - p| < |s|$ that is a 1-feature size witness for $s$. "
      "Step 2b: if an endpoint $q$ of $s$ has one that is a local or a 1-feature size witness; a "
      "triangle $t$ of a face if a vertex $q$ has a Delaunay neighbor $p$ outside of the face with "
      "$|p - q| < 2 R_t$.";
  feature_size.safety =
      "It is safe to split any segment. It is not safe to split a triangle of face $f$ if its "
      "circumcenter $c$ lies outside of $f$, or will have a Delaunay neighbor $q$ that is the "
      "endpoint of a segment $s$ in $f$ with $|c - q| < |s|$.";
  feature_size.parameters = {{"step2a", "fourths", "fourths|halves|adaptive", "",
                              "how step 2a splits segments: into fourths as proved; into halves, "
                              "which the thesis observed "
                              "to do as well; or into fourths only where $|s| \\le "
                              "\\mathrm{lfs}_1(s) / (2 \\sqrt 2)$ is in "
                              "doubt"},
                             box};
  feature_size.guarantee =
      "It ends for every complex, and for every segment $|s| \\le \\min(\\sqrt "
      "2\\,\\mathrm{fs}_1(s), "
      "\\frac{5}{3}\\,\\mathrm{lfs}(s))$ and $\\min(\\frac{1}{16}\\,\\mathrm{fs}_1(s), "
      "\\frac{1}{4}\\,"
      "\\mathrm{lfs}(s)) \\le |s|$, the latter throughout (Theorems 4.1 and 4.2).";
  feature_size.checks = {"topology", "delaunay",      "input-vertices",
                         "volume",   "segment-lower", "segment-upper"};

  AlgorithmInfo ruppert;
  ruppert.id = "ruppert";
  ruppert.title = "Ruppert's algorithm in space";
  ruppert.dimension = 3;
  ruppert.thesis = "Algorithm 6.2 without protection (Shewchuk 1998)";
  ruppert.action =
      "Insert the circumcenter of a simplex, unless it encroaches upon the diametral ball of a "
      "simplex of lower dimension, a segment or a triangle of a face: this is queued instead.";
  ruppert.priority = "Simplices are prioritized by dimension, lower ones are processed first.";
  ruppert.unacceptability =
      "A segment, or a Delaunay triangle of a face, is unacceptable if its diametral ball is not "
      "empty. A tetrahedron $t$ is unacceptable if its radius-edge ratio is greater than $\\tau$.";
  ruppert.safety = "It is safe to split any simplex.";
  ruppert.parameters = {
      {"tau", "2.1", "0.6", "1000",
       "radius-edge threshold: circumradius over shortest edge; above 2 the end is proved"},
      {"size", "0", "0", "1e55", "upper bound on the circumradius of every tetrahedron; 0: none"},
      {"slivers", "keep", "keep|remove", "",
       "what becomes of tetrahedra with a small dihedral angle: a last step removes those that it "
       "can without losing anything"},
      {"dihedral", "10", "0.1", "30",
       "degrees: with a smaller dihedral angle a tetrahedron is a sliver, to be removed"},
      box};
  ruppert.guarantee =
      "Where segments and faces meet at right or obtuse angles and $\\tau > 2$ it ends; then every "
      "segment is a union of edges, every face a union of facets, and every tetrahedron has a "
      "radius-edge ratio of at most $\\tau$. Dihedral angles have no bound. Sharp angles may keep "
      "it "
      "from ending.";
  ruppert.checks = {"topology",    "delaunay", "input-vertices", "input-segments",
                    "input-faces", "volume",   "radius-edge"};
  ruppert.default_domain = "closed";

  AlgorithmInfo collar = ruppert;
  collar.id = "collar";
  collar.title = "Refinement with collars in space";
  collar.thesis = "Algorithms 6.1 and 6.2";
  collar.action =
      "Split segments at acute angles until they are short against their feature sizes, end "
      "segments at a vertex alike; put collar vertices beside them into every face. Then insert "
      "the "
      "circumcenter of a simplex, unless it encroaches upon the diametral ball of a simplex of "
      "lower dimension, collar segment or collar arc: this is queued instead. Collar segments are "
      "split at their midpoint, collar arcs at the midpoint of the arc.";
  collar.priority =
      "Collar segments and arcs are given the highest priority. Simplices are prioritized by "
      "dimension, lower ones are processed first.";
  collar.unacceptability =
      "A segment, collar segment, collar arc or triangle of a face is unacceptable if its "
      "circumball is not empty. A tetrahedron $t$ is unacceptable if its radius-edge ratio is "
      "greater than $\\tau$.";
  collar.safety =
      "It is not safe to split any collar simplex: pieces of protected segments, and triangles of "
      "faces between them and the collar segments and arcs.";
  collar.parameters[0].default_value = "2.3";
  collar.parameters.push_back({"protect", "acute", "acute|all", "",
                               "which vertices and segments are protected: those at which others "
                               "meet them at less than 90 degrees, or all"});
  collar.parameters.push_back({"sizes", "exact", "exact|estimate", "",
                               "how protected segments are sized: by their distances from other "
                               "features, or by Algorithm 4.1"});
  collar.parameters.push_back({"size-factor", "0.8", "0.05", "0.95",
                               "the c of (H2): pieces of protected segments are shorter than this "
                               "part of their feature sizes"});
  collar.parameters.push_back({"height", "0.6", "0.51", "0.75",
                               "of collars, in lengths of the pieces of segments; times "
                               "`size-factor` below 1/2"});
  collar.guarantee =
      "For every complex and $\\tau > 2$ it ends, every segment is a union of edges and every face "
      "a "
      "union of facets; and the circumcenter of every tetrahedron with a radius-edge ratio above "
      "$\\tau$ lies in the ball of a collar simplex (Theorem 6.11).";
  collar.checks = {"topology", "delaunay",    "input-vertices", "input-segments", "input-faces",
                   "volume",   "radius-edge", "collar",         "protection"};

  AlgorithmInfo structured = ruppert;
  structured.id = "intestine-structured";
  structured.title = "Refinement with intestines in space, by rings";
  structured.thesis = "Algorithms 6.1 and 6.4";
  structured.parameters[0].default_value = "2.3";
  structured.parameters.push_back({"protect", "acute", "acute|all", "",
                                   "which input vertices and segments get spheres and tubes: the "
                                   "acutely adjacent, or all but those of the box"});
  structured.parameters.push_back(collar.parameters[collar.parameters.size() - 3]);  // sizes
  structured.parameters.push_back({"size-factor", "0.6", "0.05", "0.75",
                                   "the c of (H2): pieces of protected segments are shorter than "
                                   "this part of their feature sizes"});
  structured.action =
      "Split segments until they are short against their distances from other features, end "
      "segments at a vertex alike; put spheres about input vertices and rings about segments, "
      "whose "
      "tubes keep them apart from the rest. Then insert the circumcenter of a simplex, unless it "
      "encroaches upon the ball of a simplex, arc or patch of lower dimension: this is queued "
      "instead. Arcs are split at their midpoint, patches of spheres at their circumcenter on the "
      "sphere; where a collar segment or a patch of a tube is to be split, a ring is put in the "
      "middle between its two.";
  structured.priority =
      "Simplices are prioritized by dimension, lower ones are processed first; patches of spheres "
      "and tubes before triangles of faces.";
  structured.unacceptability =
      "Outside of the intestine, an arc, a collar segment, a patch or a triangle of a face is "
      "unacceptable if its smallest ball is not empty, and a patch of a sphere if its angular "
      "radius is above 45 degrees. A tetrahedron is unacceptable if its radius-edge ratio is "
      "greater than $\\tau$.";
  structured.safety =
      "It is safe to split any simplex outside of the intestine and on its surface.";
  structured.guarantee =
      "When it ends, every segment is a union of edges and every face a union of facets, and every "
      "tetrahedron outside of spheres and tubes has a radius-edge ratio of at most $\\tau$ "
      "(Theorem "
      "6.14). No complex was met where it does not end; that it always does is Conjecture 6.16.";
  structured.checks = {"topology",    "delaunay", "input-vertices", "input-segments",
                       "input-faces", "volume",   "intestine",      "protection"};

  AlgorithmInfo intestine = structured;
  intestine.id = "intestine";
  intestine.title = "Refinement with intestines in space";
  intestine.thesis = "Algorithms 6.1 and 6.3";
  intestine.action =
      "Split segments until they are short against their distances from other features, end "
      "segments at a vertex alike; put spheres about input vertices and tubes about segments, "
      "which "
      "keep them apart from the rest. Then insert the circumcenter of a simplex, on a sphere or "
      "tube its projection onto it, unless it encroaches upon the ball of a simplex, arc or patch "
      "of lower dimension: this is queued instead. Arcs are split at their midpoint.";
  intestine.guarantee =
      "When it ends, every tetrahedron outside of spheres and tubes has a radius-edge ratio of at "
      "most $\\tau$ (Theorem 6.15). Inside of the tubes the Delaunay tetrahedralization need not "
      "conform: one that does and matches takes its place there, and the check says which of its "
      "cells are not Delaunay. That it always ends is Conjecture 6.16.";
  intestine.checks[1] = "delaunay-outside";
  return {delaunay, feature_size, ruppert, collar, structured, intestine};
}

}  // namespace circumball
