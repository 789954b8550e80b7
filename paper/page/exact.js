// SPDX-License-Identifier: Apache-2.0
// Exact angles in whole numbers (BigInt). No double takes part in anything that is shown as exact.
'use strict';

function absolute(n) {
  return n < 0n ? -n : n;
}

function greatestCommonDivisor(a, b) {
  a = absolute(a);
  b = absolute(b);
  while (b !== 0n) [a, b] = [b, a % b];
  return a;
}

/** "num/den" in lowest terms, "num" where the denominator is one; as the judge writes it. */
function fractionText(numerator, denominator) {
  if (denominator < 0n) [numerator, denominator] = [-numerator, -denominator];
  const common = greatestCommonDivisor(numerator, denominator);
  const rest = denominator / common;
  return rest === 1n ? `${numerator / common}` : `${numerator / common}/${rest}`;
}

/** "num/den" or "num" as {numerator, denominator}. */
function parseFraction(text) {
  const [numerator, denominator = '1'] = text.split('/');
  return {numerator: BigInt(numerator), denominator: BigInt(denominator)};
}

/** A corner is cross = u x v and dot = u . v of its edges u (to the next vertex) and v (to the one
 *  before), up to a common positive factor. Points are {x, y} in BigInt on one lattice. */
function cornerAt(at, next, previous) {
  const ux = next.x - at.x, uy = next.y - at.y;
  const vx = previous.x - at.x, vy = previous.y - at.y;
  return {cross: ux * vy - uy * vx, dot: ux * vx + uy * vy};
}

/** The tangent as the judge gives it; null at a right angle. */
function tangentText(corner) {
  return corner.dot === 0n ? null : fractionText(corner.cross, corner.dot);
}

/** angle >= arctan(n / d) and angle <= 180 degrees - arctan(n / d); see model/angle.hpp. */
function isAtLeast(corner, [n, d]) {
  return corner.cross > 0n && (corner.dot <= 0n || BigInt(d) * corner.cross >= BigInt(n) * corner.dot);
}
function isAtMostStraightMinus(corner, [n, d]) {
  return corner.cross > 0n && (corner.dot >= 0n || BigInt(d) * corner.cross >= -BigInt(n) * corner.dot);
}

function bitLength(n) {
  return absolute(n).toString(2).length;
}

/** For the eye only. */
function degreesOf(corner) {
  const digits = Math.max(bitLength(corner.cross), bitLength(corner.dot));
  const shift = BigInt(Math.max(0, digits - 1000));  // a double ends at 2^1023
  const angle = Math.atan2(Number(corner.cross >> shift), Number(corner.dot >> shift));
  return (angle < 0 ? angle + 2 * Math.PI : angle) * 180 / Math.PI;
}
