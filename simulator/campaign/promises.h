// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glider::simulator {

/// The kinds of faults that a campaign draws, in the order of its table.
enum class FaultKind : uint8_t {
#define FAULT_KIND(name, ...) name,
#include "simulator/campaign/fault_kinds.def"
};

// The kinds of a line and those of a sensor, so that the compiler reports a missing kind in a
// switch.
enum class LineFaultKind : uint8_t {
#define LINE_FAULT(name, ...) name = static_cast<uint8_t>(FaultKind::name),
#include "simulator/campaign/fault_kinds.def"
};
enum class SensorFaultKind : uint8_t {
#define SENSOR_FAULT(name, ...) name = static_cast<uint8_t>(FaultKind::name),
#include "simulator/campaign/fault_kinds.def"
};

/// How many kinds there are.
inline constexpr uint32_t kFaultKinds = 0
#define FAULT_KIND(...) +1
#include "simulator/campaign/fault_kinds.def"
    ;

std::vector<FaultKind> allFaultKinds();
/// "byte loss".
const char* nameOf(FaultKind kind);

/// What becomes of the SBC's control, from the strictest to the most lenient.
enum class Control : uint8_t {
  Kept,        ///< until the mission exits, which it does
  Unanswered,  ///< it ends in time when an instruction gets no answer
  Silent,      ///< it ends in time when nothing arrives any more
  AtOnce,      ///< it ends in the next cycle
  ForGood,     ///< and does not come back
  Any,         ///< the mission itself may release it or lose it
};

/// The greatest true depth of the vehicle.
enum class Deepest : uint8_t {
  Overshoot,   ///< as far past the limit in force as a dive overshoots
  Sinks,       ///< the same, and what it sinks while the flight controller is down (DepthJudge)
  TenMetres,   ///< ten metres past the limit
  OneAndAHalf  ///< one and a half times the limit
};

/// What must hold under a fault, in addition to what holds in every flight (scenarios/README.md).
struct Promise {
  Control control = Control::Kept;
  Deepest deepest = Deepest::Overshoot;
  bool clearance = true;
  bool follows = true;
};
Promise promiseOf(FaultKind kind);
/// For faults that occur together: in each respect the weakest promise. Two sensors that are wrong
/// at once only keep the depth of Deepest::OneAndAHalf. Several counts only if its parts are not
/// among `kinds`.
Promise promiseOf(std::span<const FaultKind> kinds);
/// True if a sensor of the vehicle reports what is not true.
bool isOfSensors(FaultKind kind);
/// True if line, computers and clock are as they should be.
bool leavesTheSbc(FaultKind kind);

/// The greatest true depth allowed while `limit_m` is in force, m.
double deepestAllowed(Deepest deepest, double limit_m);
/// The times that what becomes of control depends on, s.
struct ControlTimes {
  double silence_s = 0;  ///< hookbeh's `silence_secs`, with its `nap_secs`
  double cycle_s = 0;    ///< of the flight controller
  double lag_s = 0;      ///< `line_lag_s` of the vehicle
};
/// The time after which control has ended, s: for Unanswered and Silent, without a line's delay by
/// a fault.
double releaseSecs(Control control, const ControlTimes& times);

/// The rows of the table in scenarios/README.md, as Markdown.
std::string promiseTable(const ControlTimes& times);

}  // namespace glider::simulator
