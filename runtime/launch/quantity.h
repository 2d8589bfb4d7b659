// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdint.h>

/// Numbers with units, as a person writes them at launch.
namespace glider::runtime {

/// A piece of text that need not end with a zero.
struct Piece {
  const char* begin;
  const char* end;

  [[nodiscard]] uint32_t size() const { return static_cast<uint32_t>(end - begin); }
  [[nodiscard]] bool empty() const { return begin == end; }
  /// Where `c` is in it first; `end`: nowhere.
  [[nodiscard]] const char* find(char c) const;
  /// The same without the spaces at both ends.
  [[nodiscard]] Piece trimmed() const;
  /// True if it equals `text`, which ends with a zero.
  [[nodiscard]] bool is(const char* text) const;
};

/// Walks through GliderParameterInfo::units.
class Units {
 public:
  explicit Units(const char* units) : rest_(units) {}
  /// The next unit, into name() and factor(); false after the last.
  bool next();
  [[nodiscard]] Piece name() const { return name_; }
  /// From the unit to SI units, or degrees.
  [[nodiscard]] double factor() const { return factor_; }

 private:
  const char* rest_;
  Piece name_{nullptr, nullptr};
  double factor_ = 1;
};

/// True if `units` are those of a truth value.
bool isTruth(const char* units);
/// True if `units` are those of a latitude (N, S) or a longitude (E, W), in degrees.
bool isOnEarth(const char* units);

enum class Reading : uint8_t {
  Good,
  NotANumber,
  TooManyDigits,  ///< more than can be read the same on every board
  NoSuchUnit,     ///< of a latitude or longitude also: neither ddmm.mmmm nor with one letter
  SixtyMinutes,   ///< of a degree, or more
  SignAndLetter,  ///< a minus sign and N, S, E or W
};

/// Reads "20", "20 m", "-1.5e3cm", "3 h 30 min", "39.2 N", "39 10.5 N", "3910.5 N", or of a truth
/// value "true" or "false", into `value`, in SI units or degrees. A latitude or longitude without a
/// letter is ddmm.mmmm, as in the language (within 1e-12 degrees of it). The nearest double, on
/// every board: at most 15 digits and powers of ten up to 22, which one correctly rounded operation
/// turns into a double (W. D. Clinger, How to read floating point numbers accurately, PLDI 1990).
Reading readQuantity(const Piece& text, const char* units, double& value);

}  // namespace glider::runtime
