// SPDX-License-Identifier: Apache-2.0
#pragma once
// Angles at corners as exact rational tests; no square root, no trigonometry, no degrees.
//
// A corner with edge vectors u and v (counter-clockwise from u to v) is the pair cross = u x v,
// dot = u . v, up to a common positive factor. Its angle lies strictly between 0 and 180 degrees
// exactly when cross > 0; cot(angle) = dot / cross then falls strictly as the angle grows.

namespace quadbound {

/// arctan(numerator / denominator), both positive.
struct Arctangent {
  int numerator;
  int denominator;
  friend bool operator==(const Arctangent&, const Arctangent&) = default;
};

/// The interval [smallest, 180 degrees - from_straight].
struct AngleInterval {
  Arctangent smallest;
  Arctangent from_straight;
  friend bool operator==(const AngleInterval&, const AngleInterval&) = default;
};

/// thm-1: [arctan(1/2), 180 - arctan(1/2)] = [45 - arctan(1/3), 135 + arctan(1/3)] degrees.
inline constexpr AngleInterval kTheorem1{{1, 2}, {1, 2}};
/// thm-13: [arctan(1/3), 135 + 2 arctan(1/3)] degrees, and 135 + 2 arctan(1/3) = 180 - arctan(1/7).
inline constexpr AngleInterval kTheorem13{{1, 3}, {1, 7}};

template <class Number>
struct Corner {
  Number cross;
  Number dot;
};

/// The corner at `at` from the edge towards `next` to the edge towards `previous`. Points need
/// members x and y; differences are taken in Number, which must hold their products.
template <class Number, class PointType>
Corner<Number> corner_at(const PointType& at, const PointType& next, const PointType& previous) {
  const Number ux = Number(next.x) - Number(at.x);
  const Number uy = Number(next.y) - Number(at.y);
  const Number vx = Number(previous.x) - Number(at.x);
  const Number vy = Number(previous.y) - Number(at.y);
  return {Number(ux * vy - uy * vx), Number(ux * vx + uy * vy)};
}

/// angle >= arctan(bound), and angle < 180 degrees.
template <class Number>
bool at_least(const Corner<Number>& corner, Arctangent bound) {
  return corner.cross > 0 &&
         (corner.dot <= 0 || bound.denominator * corner.cross >= bound.numerator * corner.dot);
}

/// angle <= 180 degrees - arctan(bound), and angle > 0.
template <class Number>
bool at_most_straight_minus(const Corner<Number>& corner, Arctangent bound) {
  return corner.cross > 0 &&
         (corner.dot >= 0 || bound.denominator * corner.cross >= -bound.numerator * corner.dot);
}

template <class Number>
bool within(const Corner<Number>& corner, const AngleInterval& interval) {
  return at_least(corner, interval.smallest) &&
         at_most_straight_minus(corner, interval.from_straight);
}

}  // namespace quadbound
