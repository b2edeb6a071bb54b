#ifndef CIRCUMBALL_COMPLEX_ENCLOSURE_H_
#define CIRCUMBALL_COMPLEX_ENCLOSURE_H_

#include "circumball/complex.h"

namespace circumball {

/// Whether faces of a 3D complex enclose something, so that the domain `closed` is not empty.
///
/// Faces that enclose a part of space have each side in common with another of them: their boundary
/// modulo 2 is empty, and the other way round (Alexander duality). So it is asked whether some set
/// of faces has that, by reduction of the boundary matrix modulo 2, column by column; the boundary
/// of a face is that of its triangles. About linear for surfaces.
bool faces_enclose_something(const Complex& complex);

}  // namespace circumball

#endif  // CIRCUMBALL_COMPLEX_ENCLOSURE_H_
