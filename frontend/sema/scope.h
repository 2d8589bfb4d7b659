// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/frontend.h"
#include "frontend/sema/types.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

/// A `const`, worked out.
struct Constant {
  const ast::Name* name = nullptr;
  ir::Type type;
  bool position = false;  ///< `number` is the latitude, `second` the longitude
  double number = 0;      ///< SI units or degrees; 1 and 0 for true and false
  double second = 0;
  bool worked_out = false;  ///< its definition was reached
  bool valid = false;       ///< worked out, and right; what was wrong was said
};

/// A flightprofile or flightroute that a mission may use.
struct BehaviourDeclaration {
  const ast::Name* name = nullptr;
  ir::BehaviourKind kind = ir::BehaviourKind::Profile;
  std::vector<ir::Parameter> parameters;
  std::vector<const platforms::PlatformSensor*> reads;
  std::string signature;  ///< "yo(top: length, …)"
  bool usable = true;     ///< false: its declaration was refused, and said to be so
  ir::BehaviourId id;     ///< once the mission uses it
};

/// The three clocks of the language: names that every mission has.
enum class Clock : uint8_t { MissionTime, StateTime, ResumeTime };
std::optional<Clock> findClock(std::string_view name);

/// What analysis knows: the names of a mission, and the mission as far as it is lowered.
class Scope {
 public:
  Scope(const AnalysisInputs& inputs, support::DiagnosticEngine& diagnostics)
      : inputs_(inputs), diagnostics_(diagnostics) {}

  template <typename... Args>
  support::DiagnosticBuilder report(support::DiagnosticId id, const support::SourceRange& range,
                                    Args&&... args) {
    return diagnostics_.report(id, range, std::forward<Args>(args)...);
  }
  /// `what` belongs to the language but is not compiled yet.
  void notYet(const support::SourceRange& range, std::string_view what, std::string_view hint = "");
  /// The source text of `range` on one line, shortened.
  [[nodiscard]] std::string text(const support::SourceRange& range) const;
  [[nodiscard]] const platforms::Platform& platform() const { return inputs_.platform; }
  [[nodiscard]] support::DiagnosticEngine& diagnostics() { return diagnostics_; }

  /// The mission's subscription of a sensor, made on first use; `written` is how the mission calls
  /// it.
  ir::SensorId subscribe(const platforms::PlatformSensor& sensor, std::string_view written);
  /// The mission's use of a behaviour, made on first use.
  ir::BehaviourId use(BehaviourDeclaration& declaration);
  /// "did you mean `temp`?" over sensors, clocks and constants.
  [[nodiscard]] std::string suggestName(std::string_view wrong) const;
  [[nodiscard]] std::string suggestSensor(std::string_view wrong) const;
  /// True, and reported, if no value may be called `name` because a unit, sensor or clock is.
  bool refuseName(const ast::Name& name, std::string_view owner);

  ir::Mission mission;
  std::map<std::string, Constant, std::less<>> constants;
  std::map<std::string, const ast::Name*, std::less<>> later_values;  ///< var, param, extern sensor
  std::map<std::string, const ast::Name*, std::less<>> later_functions;
  std::map<std::string, ir::StateId, std::less<>> states;
  std::map<std::string, BehaviourDeclaration, std::less<>> behaviours;

 private:
  const AnalysisInputs& inputs_;
  support::DiagnosticEngine& diagnostics_;
  std::map<uint16_t, ir::SensorId> subscribed_;
};

}  // namespace glider::frontend
