// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/glider_abi.h"
#include "runtime/launch/quantity.h"
#include "runtime/log/format.h"

/// The parameters of a mission at its launch: the pilot's values, checked against what the mission
/// allows. Used on boards and by the command-line tool.
namespace glider::runtime {

class Launch {
 public:
  /// The compiler refuses a mission with more.
  static constexpr uint32_t kMostParameters = GLIDER_MOST_PARAMETERS;

  /// All parameters have their defaults. `mission` outlives this.
  explicit Launch(const GliderMission& mission);
  Launch(const Launch&) = delete;
  Launch& operator=(const Launch&) = delete;

  /// Takes "name=value", with optional spaces; of two settings of a parameter the later one counts.
  /// The latitude and the longitude of a position `w` are the parameters `w.latitude` and
  /// `w.longitude`, and may be set together: "w=39.175 N 73.83 W".
  /// False, with a problem(), if there is no such parameter, or it cannot have that value.
  bool set(const Piece& setting);
  /// Takes the lines of a file, `name = value`, with comments from # on.
  bool setAll(const char* file_name, const Piece& content);
  /// Checks whether the parameters together satisfy the mission's `where` conditions. Like those
  /// below, it differs in programs of missions without parameters.
  bool check();
  /// Always false, with a problem(): `where` number `failed`, from 0, is not satisfied.
  bool refuseWhere(uint32_t failed);

  /// One value for each parameter: gliderStart's.
  [[nodiscard]] const double* values() const { return values_; }
  /// Why the latest call failed: one line, no full stop.
  [[nodiscard]] const char* problem() const { return problem_; }

 private:
  bool refuse(Text& text);
  bool refuseUnknown(const Piece& name);
  void listNames(Text& text) const;
  /// `value`: what was read, if `reading` is Good.
  bool refuseValue(const GliderParameterInfo& parameter, const Piece& given, Reading reading,
                   double value);
  // What differs in programs of missions without parameters (board/no_parameters.cpp).
  /// The parameter of this name, or the latitude of the position; kMostParameters: there is none.
  [[nodiscard]] uint32_t find(const Piece& name) const;
  /// Sets what has this name: `parameter`, or the position of which it is the latitude.
  bool assign(uint32_t parameter, const Piece& name, const Piece& given);
  bool assignOne(uint32_t parameter, const Piece& given);
  /// Sets the parameter `latitude` and the next one, a longitude.
  bool assignPosition(uint32_t latitude, const Piece& given);
  bool refusePosition(uint32_t latitude, const Piece& given, const char* why);

  static constexpr uint32_t kProblemBytes = 400;
  const GliderMission& mission_;
  double values_[kMostParameters] = {};
  char problem_[kProblemBytes + 1] = {};
  const char* file_ = nullptr;  ///< whose line is being read
  uint32_t line_ = 0;
};

/// The name of the position of which `parameter` is the latitude and the next one the longitude;
/// empty if it is not a latitude of a position.
Piece positionOf(const GliderMission& mission, uint32_t parameter);
/// What is wrong with a number, for some of the reasons; nullptr for the others.
const char* whyNot(Reading reading);

/// Writes `value`, SI units or degrees, with the parameter's own unit: "25 m", "true".
void writeQuantity(const GliderParameterInfo& parameter, double value, Text& text);
/// Writes "10 m to 30 m"; nothing for a parameter without limits.
void writeRange(const GliderParameterInfo& parameter, Text& text);

}  // namespace glider::runtime
