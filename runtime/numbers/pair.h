// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

/// Numbers of twice a double's precision, as the sum of two doubles. Every step is an IEEE
/// operation rounded to 53 bits, so boards agree on each bit. This includes a 486 as long as no
/// magnitude comes near the ends of a double's range; the caller must ensure that.
///
/// Sources: Knuth, The Art of Computer Programming, vol. 2, 4.2.2 (the error of a sum); Dekker,
/// Numerische Mathematik 18 (1971), 224-242 (splitting, the error of a product).
namespace glider::runtime {

/// The value is high + low; low is at most half a unit in the last place of high.
struct Pair {
  double high;
  double low;
};

inline Pair negated(const Pair& a) {
  return {-a.high, -a.low};
}

inline Pair halved(const Pair& a) {
  return {a.high * 0.5, a.low * 0.5};
}

/// a + b, exactly.
inline Pair sumOf(double a, double b) {
  const double sum = a + b;
  const double part_of_b = sum - a;
  const double part_of_a = sum - part_of_b;
  return {sum, (a - part_of_a) + (b - part_of_b)};
}

/// a - b, exactly.
inline Pair differenceOf(double a, double b) {
  return sumOf(a, -b);
}

/// a * b, exactly; both below 2^900 in magnitude, and the product above 2^-900 or zero.
inline Pair productOf(double a, double b) {
  constexpr double kSplit = 134217729.0;  // 2^27 + 1
  const double wide_a = kSplit * a;
  const double wide_b = kSplit * b;
  const double head_a = wide_a - (wide_a - a);
  const double head_b = wide_b - (wide_b - b);
  const double tail_a = a - head_a;
  const double tail_b = b - head_b;
  const double product = a * b;
  const double missing = ((head_a * head_b - product) + head_a * tail_b + tail_a * head_b);
  return {product, missing + tail_a * tail_b};
}

/// a + b, to about 100 bits unless they cancel.
inline Pair sumOf(const Pair& a, const Pair& b) {
  const Pair sum = sumOf(a.high, b.high);
  return sumOf(sum.high, sum.low + (a.low + b.low));
}

inline Pair sumOf(const Pair& a, double b) {
  const Pair sum = sumOf(a.high, b);
  return sumOf(sum.high, sum.low + a.low);
}

/// a * b, to about 100 bits.
inline Pair productOf(const Pair& a, const Pair& b) {
  const Pair product = productOf(a.high, b.high);
  return sumOf(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/// a / b, to about 100 bits; b is not zero.
inline Pair quotientOf(const Pair& a, const Pair& b) {
  const double quotient = a.high / b.high;
  const Pair covered = productOf(quotient, b.high);
  const double rest = ((a.high - covered.high) - covered.low) + (a.low - quotient * b.low);
  return sumOf(quotient, rest / b.high);
}

}  // namespace glider::runtime
