#ifndef CIRCUMBALL_PREDICATES_ELEMENTARY_H_
#define CIRCUMBALL_PREDICATES_ELEMENTARY_H_

/// Elementary functions built from + - * / sqrt and bits alone, so that they give the same double
/// with every compiler, on every processor and in WebAssembly, which the C library's do not. For
/// everything that reaches a coordinate or a decision. Special values are those of C (annex F);
/// errors are NaN, and errno stays.
///
/// The accuracies are upper bounds in units in the last place of the exact result, as the tests
/// check them (tests/predicates/elementary_test.cpp); the analysis stands at each function.
namespace circumball::elementary {

constexpr double kPi = 0x1.921fb54442d18p+1;  ///< pi, to nearest

/// Sine and cosine of x in radians, for all finite x: within 1 ulp. NaN for infinities.
double sin(double x);
double cos(double x);
/// The number modulo 4 of the quarter turn that holds x, exactly: floor(x / (pi/2)). For all finite
/// x.
int quarter_turn(double x);
/// Inverse sine, in [-pi/2, pi/2]: within 4 ulp. NaN outside [-1, 1].
double asin(double x);
/// Inverse cosine, in [0, pi]: within 4 ulp. NaN outside [-1, 1].
double acos(double x);
/// Inverse tangent, in [-pi/2, pi/2]: within 2 ulp.
double atan(double x);
/// Tangent of x in radians: within 4 ulp.
double tan(double x);
/// The angle of (x, y), in (-pi, pi]: within 4 ulp. Both zeros count as positive: pi on the
/// negative x axis, 0 at the origin.
double atan2(double y, double x);
/// e^x: within 1 ulp. Zero or infinity where the result is out of range.
double exp(double x);
/// Natural logarithm: within 1 ulp. Minus infinity at zero, NaN below.
double log(double x);
/// x^y: within 1 ulp, and exact where the result is a double. NaN for negative x unless y is an
/// integer.
double pow(double x, double y);

}  // namespace circumball::elementary

#endif  // CIRCUMBALL_PREDICATES_ELEMENTARY_H_
