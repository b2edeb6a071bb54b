#include "quality/enclosed_parts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "circumball/predicates.h"
#include "feature_size/vectors.h"
#include "quality/tetrahedron_measure.h"

namespace circumball {
namespace {

std::vector<FaceShells::Triangle> triangles_of(const Complex& complex) {
  std::vector<FaceShells::Triangle> all;
  for (std::uint32_t f = 0; f < complex.faces.size(); ++f) {
    const auto triangles = triangulate_face(complex, f);
    all.insert(all.end(), triangles.begin(), triangles.end());
  }
  return all;
}

}  // namespace

std::uint32_t EnclosedParts::root(std::uint32_t i) {
  while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
  return i;
}
void EnclosedParts::join(std::uint32_t i, std::uint32_t j) {
  i = root(i), j = root(j);
  parent_[std::max(i, j)] = std::min(i, j);
}

EnclosedParts::EnclosedParts(const Complex& complex) : shells_(complex, triangles_of(complex)) {
  const auto& triangles = shells_.triangles();
  const auto count = static_cast<std::uint32_t>(triangles.size());
  parent_.resize(2 * std::size_t{count} + 1);
  std::iota(parent_.begin(), parent_.end(), 0u);
  for (const auto& t : triangles) {
    const Point3 &a = complex.vertices[t[0]], &b = complex.vertices[t[1]],
                 &c = complex.vertices[t[2]];
    centroids_.push_back({(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3, (a.z + b.z + c.z) / 3});
  }
  nest(complex);
  if (!known_) return;

  // Levels, by how many faces are between a part and the outside.
  std::vector<std::vector<std::uint32_t>> beyond(parent_.size());
  for (std::uint32_t t = 0; t < count; ++t) {
    const std::uint32_t front = part_of(2 * t), back = part_of(2 * t + 1);
    if (front == back) continue;
    beyond[front].push_back(back);
    beyond[back].push_back(front);
  }
  std::vector<std::uint32_t> level(parent_.size(), kNoIndex), now{root(2 * count)};
  level[now[0]] = 0;
  for (std::size_t k = 0; k < now.size(); ++k) {
    for (const std::uint32_t part : beyond[now[k]]) {
      if (level[part] != kNoIndex) continue;
      level[part] = level[now[k]] + 1;
      now.push_back(part);
    }
  }
  const bool parity = complex.hole_rule == HoleRule::kAuto
                          ? complex.holes.empty() && complex.regions.empty()
                          : complex.hole_rule == HoleRule::kParity;
  std::vector<bool> inside(parent_.size(), false);
  for (std::size_t i = 0; i < level.size(); ++i) {
    inside[i] = level[i] != kNoIndex && (parity ? level[i] % 2 == 1 : level[i] > 0);
  }
  for (const Point3& hole : complex.holes) {
    const std::uint32_t part = part_at(hole);
    if (part != kNoIndex) inside[part] = false;
  }
  measure(complex, inside);
}

/// Joins the outer shell of each connected set of faces with the shell of the innermost set around
/// it that it lies in.
void EnclosedParts::nest(const Complex& complex) {
  struct Component {
    std::uint32_t triangle = kNoIndex;                            // some one of it
    std::uint32_t outer = kNoIndex;                               // a side
    std::vector<std::pair<std::uint32_t, std::uint32_t>> around;  // component, side of it
  };
  std::map<std::uint32_t, Component> components;
  for (std::uint32_t t = 0; t < shells_.triangles().size(); ++t) {
    Component& c = components[shells_.component(t)];
    if (c.triangle == kNoIndex) c.triangle = t;
  }
  std::vector<FaceShells::Hit> hits;
  for (auto& [name, c] : components) {
    bool decided = false;
    for (int attempt = 0; attempt < FaceShells::kAttempts && !decided; ++attempt) {
      if (!shells_.cast(centroids_[c.triangle], attempt, &hits, c.triangle)) continue;
      std::map<std::uint32_t, std::vector<FaceShells::Hit>> parts;
      for (const auto& hit : hits) parts[shells_.component(hit.triangle)].push_back(hit);
      const auto& t = shells_.triangles()[c.triangle];
      const Sign above =
          orient3d(complex.vertices[t[0]], complex.vertices[t[1]], complex.vertices[t[2]],
                   shells_.end_of_ray(centroids_[c.triangle], attempt));
      if (above == Sign::kZero) continue;
      c.outer = 2 * c.triangle + (above == Sign::kPositive);  // unless the ray meets its own faces
      decided = true;
      c.around.clear();
      for (const auto& [other, list] : parts) {
        decided = decided && FaceShells::is_first(list) && FaceShells::is_last(list);
        const auto side = [](const FaceShells::Hit& hit, bool front) {
          return 2 * hit.triangle + !front;
        };
        const std::uint32_t first = side(list[0], list[0].front),
                            last = side(list.back(), !list.back().front);
        if (other == name) {
          c.outer = last;
        } else if (part_of(first) != part_of(last)) {
          c.around.push_back({other, first});
        }
      }
    }
    known_ = known_ && decided;
  }
  if (!known_) return;
  for (const auto& [name, c] : components) {
    const std::pair<std::uint32_t, std::uint32_t>* innermost = nullptr;
    for (const auto& other : c.around) {
      if (innermost == nullptr ||
          components[other.first].around.size() > components[innermost->first].around.size()) {
        innermost = &other;
      }
    }
    join(part_of(c.outer), innermost != nullptr
                               ? part_of(innermost->second)
                               : root(static_cast<std::uint32_t>(parent_.size() - 1)));
  }
}

/// kNoIndex if p is in a face, or rays do not decide.
std::uint32_t EnclosedParts::part_at(const Point3& p) {
  std::vector<FaceShells::Hit> hits;
  for (int attempt = 0; attempt < FaceShells::kAttempts; ++attempt) {
    if (!shells_.cast(p, attempt, &hits) || !FaceShells::is_first(hits)) continue;
    if (hits.empty()) return root(static_cast<std::uint32_t>(parent_.size() - 1));
    return part_of(2 * hits[0].triangle + !hits[0].front);
  }
  return kNoIndex;
}

/// The pyramids over the sides toward the parts inside (divergence theorem).
void EnclosedParts::measure(const Complex& complex, const std::vector<bool>& inside) {
  if (shells_.triangles().empty()) return;
  const Point3& top = complex.vertices[shells_.triangles()[0][0]];
  Twofold six;
  for (std::uint32_t t = 0; t < shells_.triangles().size(); ++t) {
    const bool front = inside[part_of(2 * t)], back = inside[part_of(2 * t + 1)];
    const auto& v = shells_.triangles()[t];
    const Point3 &a = complex.vertices[v[0]], &b = complex.vertices[v[1]],
                 &c = complex.vertices[v[2]];
    if (front || back) area_ += 0.5 * std::sqrt(cross2(b - a, c - a));
    if (front == back) continue;
    // Seen from the front counter-clockwise: outward where the back is inside.
    six = six +
          (back ? measure_tetrahedron(a, b, c, top) : measure_tetrahedron(c, b, a, top)).six_volume;
  }
  volume_ = six.high / 6;
}

}  // namespace circumball
