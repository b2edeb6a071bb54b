#ifndef CIRCUMBALL_COMPLEX_CARRIED_H_
#define CIRCUMBALL_COMPLEX_CARRIED_H_

#include "circumball/complex.h"
#include "circumball/mesh.h"

namespace circumball {

/// What the vertices of a mesh carry from the complex: markers of the features that they lie on,
/// and attributes, interpolated on segments. Needs the vertices and their features. O(n).
void carry_attributes(const Complex& complex, Mesh* mesh);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_CARRIED_H_
