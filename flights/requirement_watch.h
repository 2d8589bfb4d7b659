// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "flights/heard_missions.h"
#include "flights/in_process_sbc.h"
#include "flights/nap_watch.h"
#include "flights/outage_watch.h"
#include "support/trace/trace.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace glider::flights {

/// A requirement that a flight violates, or an assumption that it breaks.
struct FlownViolation {
  size_t number = 0;        ///< of the requirement; of an assumption: after all requirements
  double mission_time = 0;  ///< s
  double vehicle_time = 0;  ///< s
  std::string state;        ///< current then
  std::string words;        ///< how; empty: the requirement says it
  std::string after = {};   ///< which outages of the SBC came before; empty: none
};

/// A requirement that a flight neither keeps nor violates.
struct UndecidedRequirement {
  size_t number = 0;
  std::string why;  ///< "the flight ended before"
};

/// What a flight did with the requirements and assumptions of its mission; those that are in
/// neither list are kept.
struct FlownOutcome {
  std::vector<FlownViolation> violations;  ///< as RequirementWatch::violations()
  std::vector<UndecidedRequirement> undecided;
};

struct KnownFlight;
struct KnownOutcome;

/// The first violation of a requirement of `mission` in a flight: what the SBC received, the
/// mission's parameters, and the flight's trace. The interpreter repeats the flight tick by tick,
/// under the monitor that defines the requirement.
std::optional<FlownViolation> violationOf(const compiler::Optimised& mission, size_t requirement,
                                          std::span<const HeardTick> ticks,
                                          const std::vector<double>& parameters,
                                          const support::Trace& trace);

/// The mission time, s, at which the same flight first breaks an assumption of `mission`; none: it
/// breaks none.
std::optional<double> firstBrokenAssumption(const compiler::Optimised& mission,
                                            std::span<const HeardTick> ticks,
                                            const std::vector<double>& parameters,
                                            const support::Trace& trace);

/// Watches an SBC in this process, and checks the requirements and assumptions of its mission
/// afterwards.
class RequirementWatch {
 public:
  /// `mission` is what flies; it must outlive this.
  explicit RequirementWatch(const compiler::Optimised& mission);

  /// Whether the interpreter can repeat the mission (no C), and a flight can violate it, or its SBC
  /// may sleep.
  [[nodiscard]] static bool canWatch(const compiler::Optimised& mission);

  /// What the SBC calls after each poll; to be asked for each time that it starts. `kept`: the
  /// mission time of the newest checkpoint on its card then, s; none: there is none.
  InProcessSbc::Watcher watcher(const std::vector<double>& parameters,
                                std::optional<double> kept = std::nullopt);
  /// What flies no longer does the same as the SBC in this process that is watched: nothing after
  /// this vehicle time, s, is watched.
  void depart(double vehicle_time) { departed_ = departed_.value_or(vehicle_time); }
  [[nodiscard]] std::optional<double> departed() const { return departed_; }

  /// The first violation of each requirement, then the first break of each assumption, over all
  /// outages of the SBC and each mission that began; `trace` is that of the flight.
  [[nodiscard]] std::vector<FlownViolation> violations(const support::Trace& trace) const {
    return outcome(trace).violations;
  }
  /// The same, with the requirements for which the flight was too short.
  [[nodiscard]] FlownOutcome outcome(const support::Trace& trace) const;
  [[nodiscard]] const ir::Mission& mission() const { return m_; }
  [[nodiscard]] const NapWatch& naps() const { return naps_; }

 private:
  [[nodiscard]] std::optional<FlownViolation> tooLong(const ir::Assumption& assumption) const;
  /// The first in the missions of the flight, in the order in which they began, that `look` finds;
  /// `look` receives whether a mission is the last.
  [[nodiscard]] KnownOutcome firstOf(
      const support::Trace& trace,
      const std::function<KnownOutcome(const KnownFlight&, bool)>& look) const;

  const compiler::Optimised& flown_;
  const ir::Mission& m_;  ///< with its requirements
  HeardMissions heard_;
  OutageWatch outages_;
  NapWatch naps_;
  std::vector<double> parameters_;
  size_t starts_ = 0;
  std::optional<double> departed_;
};

/// The requirements of a mission and then its assumptions as they are written, each on one line: by
/// FlownViolation::number.
std::vector<std::string> watchedTexts(const compiler::Checked& mission);

/// Reports each requirement that a flight violates, and each assumption that it breaks; `found` are
/// its violations.
void reportViolations(const RequirementWatch& watch, const std::vector<FlownViolation>& found,
                      support::DiagnosticEngine& diagnostics);

}  // namespace glider::flights
