// SPDX-License-Identifier: Apache-2.0
#pragma once
// Directions of the unit circle without libm, whose sines differ from library to library.

#include "model/exact.hpp"

namespace quadbound {

/// (cos, sin) of 2 pi numerator / denominator to a few units in the last place, the same bits on
/// every machine with IEEE doubles. Exact at multiples of a quarter turn.
/// Requires: 0 <= numerator < denominator < 2^50.
inline Point direction_of_turn(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t quarter = 4 * numerator / denominator;
  const std::int64_t rest = 4 * numerator - quarter * denominator;  // of a quarter turn
  constexpr double kHalfPi = 1.57079632679489661923;
  const double angle = kHalfPi * (static_cast<double>(rest) / static_cast<double>(denominator));
  // Taylor series in Horner's form; at most pi/2, so that the terms left out are below 2^-53.
  const double square = angle * angle;
  double cosine = 0;
  double sine = 0;
  for (int k = 13; k >= 0; --k) {
    cosine = 1 - square / static_cast<double>((2 * k + 1) * (2 * k + 2)) * cosine;
    sine = 1 - square / static_cast<double>((2 * k + 2) * (2 * k + 3)) * sine;
  }
  Point point{cosine, angle * sine};
  for (std::int64_t i = 0; i < quarter; ++i) point = {-point.y, point.x};
  return point;
}

}  // namespace quadbound
