// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/eval/interpreter.h"
#include "ir/prove/context/control.h"
#include "ir/prove/context/proof_context.h"
#include "ir/prove/falsification/random_vehicle.h"

#include <map>
#include <optional>
#include <string>

namespace glider::containment {

/// A tick of a flight, and what the interpreter keeps but does not show.
struct Tick {
  ir::TickResult result;
  double time = 0;
  double entered = 0;  ///< of the current state
  double resumed = 0;
  double depth = 0;  ///< true, m
  std::vector<double> ages;
};

/// How a flight is random.
struct FlightStyle {
  bool power_cuts = true;
  /// Often ticks just before or at a time that the mission compares a clock with, then as late as
  /// may be; readings are often next to numbers that the mission names.
  bool pressing = false;
  bool late = false;    ///< the vehicle dives at once and climbs as late and as slowly as it may
  bool silent = false;  ///< no sensor ever reports anything
  /// A frame may be without the depth, so that the mission uses a reading that no longer fits the
  /// vehicle. Proofs assume that this does not happen.
  bool old_depths = false;
  /// Where the ranges of readings and the longest outage are taken from; null: from what is flown.
  const ir::Mission* environment = nullptr;
};

/// A random flight on the interpreter in the environment model of proofs, with outages as long as
/// the mission allows.
class Flight {
 public:
  /// All outlive this.
  Flight(const ir::prove::ProofContext& context, uint64_t seed, const FlightStyle& style);
  /// With frames that may be without the depth; `power_cuts`: whether there are any.
  Flight(const ir::prove::ProofContext& context, uint64_t seed, bool power_cuts)
      : Flight(context, seed, FlightStyle{.power_cuts = power_cuts, .old_depths = true}) {}

  /// The start, then each tick in two halves, as the interpreter has them.
  void start();
  void advance() { advance(step()); }
  /// The same for a tick that is so many seconds after the one before: after an outage of the SBC.
  void advance(double seconds);
  void decide();

  [[nodiscard]] bool over() const { return now_.result.finished; }
  [[nodiscard]] const ir::Interpreter& interpreter() const { return interpreter_; }
  [[nodiscard]] const Tick& before() const { return before_; }
  [[nodiscard]] const Tick& now() const { return now_; }
  [[nodiscard]] const ir::Mission& mission() const { return m_; }
  /// Whether the latest tick has made a state current by goto, call or return, or is the start.
  [[nodiscard]] bool arrived() const { return now_.result.moved && !over(); }
  [[nodiscard]] std::string words() const;

 private:
  struct Showing {
    double raw = 0;
    bool steady = true;
    double until = -1;
  };
  double step();
  [[nodiscard]] double longestStep() const;
  double pressingStep();
  std::vector<double> parameters();
  std::vector<double> anyParameters();
  std::optional<double> landmark(uint32_t sensor);
  std::vector<ir::SensorUpdate> frame();
  double raw(uint32_t sensor);
  void keepAges(const std::vector<ir::SensorUpdate>& frame);

  const ir::prove::ProofContext& context_;
  const ir::Mission& m_;
  const ir::Mission& environment_;
  uint64_t seed_;
  FlightStyle style_;
  ir::prove::Rng dice_;
  ir::prove::RandomVehicle vehicle_;
  ir::Interpreter interpreter_;
  std::vector<Showing> showing_;
  std::map<uint32_t, double> came_;
  Tick before_, now_;
};

/// The control that a tick left.
ir::prove::Control controlOf(const ir::TickResult& result);

}  // namespace glider::containment
