// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/source_manager.h"
#include "support/trace/trace.h"

#include <cstdint>
#include <string>
#include <vector>

/// What a mission would have done with the readings in a vehicle's data files, as data.
namespace glider::report {

/// A tick of the mission along the data files.
struct LoggedMoment {
  double time_s = 0;    ///< since 1970
  std::string utc;      ///< "2019-08-09 15:24:50"
  double hours = 0;     ///< since the first tick
  double depth_m = 0;   ///< NaN: unknown
  uint32_t number = 0;  ///< of the tick
};

/// A value that a guard depends on; NaN: unknown.
struct LoggedValue {
  std::string name;  ///< as in the mission: "temp", "spread(temp, 10 m of depth)"
  double value = 0;
  std::string unit;  ///< that in which the guard is written; "" for a plain number
};
inline constexpr const char* kTruthUnit = "bool";  ///< of a truth value, which is 0 or 1

/// A tick on which a guard became true.
struct LoggedFiring {
  LoggedMoment at;
  std::vector<LoggedValue> values;
};

/// Firings that follow one another too fast: of any kFlickerFirings in a row, the last is within
/// kFlickerSeconds of the first.
struct Flicker {
  uint32_t first = 0;  ///< number of its first firing
  uint32_t count = 0;
  double seconds = 0;  ///< from the first to the last
};
inline constexpr uint32_t kFlickerFirings = 3;
inline constexpr double kFlickerSeconds = 60;

/// A case, with its guard evaluated on every tick as if the mission were in its state throughout.
struct LoggedCase {
  std::string list;   ///< "always", "state", "profile" or "route"
  std::string state;  ///< empty for `always`
  support::SourceRange range;
  std::string guard;       ///< as written, on one line
  std::string transition;  ///< "goto track", "exit"
  uint32_t known_ticks = 0;
  uint32_t true_ticks = 0;
  uint32_t followed_true_ticks = 0;  ///< while it is tried, when the mission follows the files
  std::vector<LoggedFiring> firings;
  std::vector<Flicker> flickers;
  std::vector<std::string> unknown_because;  ///< if it was never known, one for each reason
};

/// A sensor that the mission reads.
struct LoggedSensor {
  std::string name;          ///< in the mission
  std::string vehicle_name;  ///< may be the same
  uint32_t updates = 0;
  uint32_t known_ticks = 0;
  double least = 0;  ///< of the known readings; NaN if there is none
  double greatest = 0;
  std::string unit;
  std::string problem;  ///< why it is never known; empty if it is
};

/// The rows of followed_steps.def.
enum class FollowedKind : uint8_t {
#define FOLLOWED_STEP(name, word) name,
#include "report/findings/followed_steps.def"
#undef FOLLOWED_STEP
};
/// "goto"
const char* wordOf(FollowedKind kind);

/// What the mission does when it follows the data files.
struct FollowedStep {
  LoggedMoment at;
  FollowedKind kind = FollowedKind::Stay;
  std::string from;  ///< state; empty for Start
  std::string to;    ///< state; empty for Exit and Gap
  bool always = false;
  support::SourceRange range;  ///< of the case; none for Start and Gap
  std::string guard;           ///< or the requirement, the assumption
  std::vector<LoggedValue> values;
  std::string words = {};  ///< of a violation or an assumption: how; may be empty
};

/// A mission and the data files of one vehicle.
struct AgainstLogs {
  std::string vehicle;
  std::vector<std::string> files;
  LoggedMoment begin;  ///< of the first tick
  LoggedMoment end;
  uint32_t ticks = 0;    ///< on which guards are tried: all but the first
  bool science = false;  ///< ticks are the records of the science computer: there are no others
  uint32_t gaps = 0;     ///< between ticks, longer than kLongGapSeconds
  double longest_gap_s = 0;
  std::vector<LoggedValue> parameters;
  std::vector<LoggedSensor> sensors;
  std::vector<std::string> without_code;  ///< C functions, which are unknown
  std::vector<LoggedCase> cases;          ///< in the order of the mission
  std::vector<FollowedStep> followed;
  support::Trace trace;  ///< depth, water and the followed state at every tick, for pictures
};
inline constexpr double kLongGapSeconds = 300;

/// "depth 21.3 m, temp 14.2 degC"; the depth only once.
std::string loggedValues(const LoggedMoment& at, const std::vector<LoggedValue>& values);
/// The same for people.
std::string againstText(const AgainstLogs& against, const support::SourceManager& sources);

}  // namespace glider::report
