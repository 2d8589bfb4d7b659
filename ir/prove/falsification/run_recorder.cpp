// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/falsification/run_recorder.h"

#include "ir/prove/context/vehicle_clock.h"
#include "ir/verify/value_text.h"
#include "support/units/duration_text.h"
#include "support/units/position_text.h"
#include "support/utc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace glider::ir::prove {
namespace {

/// The raw value that a sensor reports so that its reading is `value`; NaN for NaN.
double rawOf(const Sensor& sensor, double value) {
  if (sensor.encoding == Encoding::DegreesMinutes) {
    const double whole = std::floor(std::fabs(value));
    return std::copysign(100 * whole + 60 * (std::fabs(value) - whole), value);
  }
  return value / sensor.to_si;
}

/// Whether it is the reading of the vehicle's clock.
bool isClock(const ProofContext& proof_context, const Expr& e) {
  return e.op == Op::Sensor && isCalendarClock(proof_context.platformSensor(e.sensor));
}

/// Whether it is `timeofday`, or as much of that clock.
bool isTimeOfDay(const ProofContext& proof_context, const Expr& e) {
  constexpr double kDay_s = 86400;
  const Mission& mission = proof_context.mission;
  return e.op == Op::Remainder && isClock(proof_context, mission[e.operands[0]]) &&
         mission[e.operands[1]].op == Op::Constant && mission[e.operands[1]].number == kDay_s;
}

/// "the time is 2026-08-11T14:00:00Z"
std::string timeText(const char* what, double seconds, std::string (*text)(double)) {
  return seconds == seconds ? fmt::format("{} is {}", what, text(std::round(seconds)))
                            : fmt::format("{} unknown", what);
}

/// The nearest float to a raw value. If that is just outside of the sensor's range, the next one
/// inside: outside, or beyond an assumed limit, the reading would be another one.
double asFloat(double raw, const Sensor& sensor) {
  const auto nearest = static_cast<float>(raw);
  if (raw <= sensor.highest && nearest > sensor.highest) {
    return std::nextafter(nearest, -std::numeric_limits<float>::infinity());
  }
  if (raw >= sensor.lowest && nearest < sensor.lowest) {
    return std::nextafter(nearest, std::numeric_limits<float>::infinity());
  }
  return nearest;
}

/// "2.9987 km": it may differ from a limit by less than a metre.
std::string distanceText(double metres) {
  constexpr double kKilometre = 1000;
  return metres < kKilometre ? fmt::format("{:.5g} m", metres)
                             : fmt::format("{:.8g} km", std::round(metres * 10) / 10 / kKilometre);
}

/// Whether a tick leaves control unchanged.
bool quiet(const TickResult& before, const TickResult& after) {
  return !after.finished && after.state == before.state && after.stack == before.stack &&
         !after.moved;
}

}  // namespace

RunRecorder::RunRecorder(const ProofContext& proof_context, uint32_t stack_depth,
                         std::span<const Requirement> requirements)
    : proof_context_(proof_context),
      m_(proof_context.mission),
      requirements_(requirements),
      depth_sensor_(proof_context.depth),
      clocks_(proof_context) {
  for (const Requirement& requirement : requirements_) {
    for (auto* monitors : {&monitors_, &later_}) {
      monitors->emplace_back(m_, requirement, proof_context.platform.world.surface_depth_m,
                             depth_sensor_);
    }
  }
  for (const Assumption& assumption : m_.assumptions) {
    if (assumption.isWatched()) {
      assumed_.emplace_back(m_, assumption.watch, proof_context.platform.world.surface_depth_m,
                            depth_sensor_);
    }
  }
  reads_variation_ = m_.compass && std::ranges::any_of(m_.exprs, [&](const Expr& e) {
                       return e.sensor.valid() && e.sensor == m_.compass->variation;
                     });
  constexpr uint32_t kWide = 8;
  for (uint32_t i = 0; i < m_.sensors.size(); ++i) {
    const platforms::PlatformSensor* sensor = proof_context.platformSensor({i});
    wide_.push_back(sensor == nullptr || sensor->bytes == kWide);
  }
  interpreter_.emplace(m_, stack_depth);
}

/// As the vehicle stores its sensors, most of which are floats of 4 bytes.
std::vector<SensorUpdate> RunRecorder::frameOf(const std::vector<double>& readings) const {
  std::vector<SensorUpdate> frame;
  frame.reserve(readings.size());
  for (uint32_t i = 0; i < readings.size(); ++i) {
    // The headings of a trace are true: with a variation of 0 a vehicle reports the same ones.
    const bool variation = m_.compass && m_.compass->variation == SensorId{i} && !reads_variation_;
    const double raw = variation ? 0 : rawOf(m_.sensors[i], readings[i]);
    frame.push_back({{i}, wide_[i] ? raw : asFloat(raw, m_.sensors[i])});
  }
  return frame;
}

void RunRecorder::start(std::vector<double> parameters, const std::vector<double>& readings,
                        double depth) {
  auto frame = frameOf(readings);
  assumptions_hold_ &= clocks_.goOn(readings, 0);
  result_.parameters = std::move(parameters);
  TickResult result = interpreter_->start(frame, result_.parameters);
  keep(std::move(result), 0, std::move(frame), depth);
}

void RunRecorder::tick(double time, const std::vector<double>& readings, double depth) {
  auto frame = frameOf(readings);
  assumptions_hold_ &= clocks_.goOn(readings, time);
  TickResult result = interpreter_->tick(time, frame);
  keep(std::move(result), time, std::move(frame), depth);
}

/// Profiles and routes go on as they do.
bool RunRecorder::keepsValues(const Interpreter& after) const {
  for (uint32_t i = 0; i < m_.variables.size(); ++i) {
    const VariableKind kind = m_.variables[i].kind;
    const double was = interpreter_->value({i}), is = after.value({i});
    if ((kind == VariableKind::Mission || kind == VariableKind::State) && was != is &&
        (was == was || is == is)) {
      return false;
    }
  }
  return true;
}

bool RunRecorder::tickIfQuiet(double time, const std::vector<double>& readings, double depth,
                              Keeps keeps) {
  Interpreter tried = *interpreter_;
  auto frame = frameOf(readings);
  TickResult result = tried.tick(time, frame);
  if (!quiet(last_, result) || (keeps == Keeps::Values && !keepsValues(tried))) {
    return false;
  }
  assumptions_hold_ &= clocks_.goOn(readings, time);
  interpreter_.emplace(std::move(tried));
  keep(std::move(result), time, std::move(frame), depth);
  return true;
}

void RunRecorder::keep(TickResult result, double time, std::vector<SensorUpdate> frame,
                       double depth) {
  tell(result, time);
  for (RequirementMonitor& assumption : assumed_) {
    assumption.tick(*interpreter_, time, result, depth);
    assumptions_hold_ &= !assumption.when();
  }
  for (size_t i = 0; i < monitors_.size(); ++i) {
    monitors_[i].tick(*interpreter_, time, result, depth);
    if (assumptions_hold_ && !hit_ && monitors_[i].when()) {
      hit_ = i;
    }
  }
  for (size_t i = 0; i < later_.size() && !result_.ticks.empty(); ++i) {
    if (requirements_[i].monitor.step.valid()) {
      later_[i].tick(*interpreter_, time, result, depth);
    }
  }
  last_ = std::move(result);
  result_.ticks.push_back({time, std::move(frame), depth, last_.state,
                           static_cast<uint32_t>(last_.stack.size()), last_.finished});
}

void RunRecorder::tell(const TickResult& result, double time) {
  if (!result.moved) {
    return;
  }
  const bool always = result.moved->list == ListKind::Always;
  const Case& c = (always ? m_.always : m_[last_.state].cases).at(result.moved->number);
  const char* verb = c.transition == Transition::Goto     ? "goes to"
                     : c.transition == Transition::Call   ? "calls"
                     : c.transition == Transition::Return ? "returns to"
                                                          : "ends the mission";
  const std::string from = always ? fmt::format("`always`, in `{}`,", m_[last_.state].name)
                                  : fmt::format("`{}`", m_[last_.state].name);
  // It may follow the start so closely that its time reads as that of the start.
  const std::string seconds = fmt::format("{:.6g}", time);
  const std::string when = seconds == "0" && result_.ticks.size() == 1
                               ? "on the first tick after the start"
                               : fmt::format("at {} s", seconds);
  const std::string text =
      c.transition == Transition::Exit
          ? fmt::format("{} {} {}", when, from, verb)
          : fmt::format("{} {} {} `{}`", when, from, verb, m_[result.state].name);
  result_.story.push_back({c.range, time, text});
}

/// The values that the condition of `always` read at that time.
void RunRecorder::describeValues() {
  if (!requirements_[*hit_].monitor.violations.empty()) {
    return;  // its words say what happened
  }
  std::vector<ExprId> open{requirements_[*hit_].condition};
  std::set<std::string> told;
  std::optional<double> north, east;  // of the vehicle: told as one position
  const auto tell_value = [&](const std::string& text) {
    result_.values += (result_.values.empty() ? "" : ", ") + text;
  };
  while (!open.empty()) {
    const ExprId id = open.back();
    open.pop_back();
    if (!id.valid()) {
      continue;
    }
    const Expr& e = m_[id];
    if (isTimeOfDay(proof_context_, e)) {
      if (told.insert("the time of day").second) {
        tell_value(timeText("the time of day", interpreter_->number(id), support::durationText));
      }
      continue;
    }
    open.insert(open.end(), e.operands.rbegin(), e.operands.rend());
    if (e.op == Op::Distance) {
      const double metres = interpreter_->number(id);
      tell_value(metres == metres ? "the distance is " + distanceText(metres)
                                  : "the distance is unknown");
      continue;
    }
    const bool depth = e.op == Op::Sensor && depth_sensor_ == e.sensor;
    const std::string name = e.op == Op::Sensor     ? m_[e.sensor].name
                             : e.op == Op::Variable ? m_[e.variable].name
                                                    : "";
    if (name.empty() || e.type.kind == TypeKind::Bool || !told.insert(name).second) {
      continue;
    }
    const double now = result_.ticks.back().depth;
    const double value = depth && now == now ? now : interpreter_->number(id);
    if (isClock(proof_context_, e)) {
      tell_value(timeText("the time", value, support::instantText));
    } else if (e.op == Op::Sensor && e.type.kind == TypeKind::Latitude && value == value) {
      north = value;
    } else if (e.op == Op::Sensor && e.type.kind == TypeKind::Longitude && value == value) {
      east = value;
    } else {
      const std::string known = e.op == Op::Sensor ? proof_context_.readingText(e.sensor, value)
                                                   : withUnit(value, m_[e.variable]);
      tell_value(fmt::format("{} {}", name, value == value ? "is " + known : "unknown"));
    }
  }
  if (north && east) {
    tell_value("the position is " + support::positionText(*north, *east));
  } else if (north || east) {
    tell_value(north ? "the latitude is " + support::latitudeText(*north)
                     : "the longitude is " + support::longitudeText(*east));
  }
}

void RunRecorder::describeDue() {
  const auto& due = monitors_[*hit_].due();
  if (!due || due->since >= result_.when) {
    return;
  }
  // Several ticks may have one time: what the last of them left holds then.
  const auto after = std::ranges::find_if(
      result_.ticks, [&](const ConcreteTick& tick) { return tick.mission_time > due->since; });
  const auto at = after == result_.ticks.begin() ? after : std::prev(after);
  result_.due =
      fmt::format("{} at {:.6g} s, in state `{}`", due->cause, due->since, m_[at->state].name);
  const RequirementMonitor& later = later_[*hit_];
  const ConcreteTick& last = result_.ticks.back();
  result_.due_at_start = at == result_.ticks.begin() && !later.when() &&
                         !later.owes(*interpreter_, last.mission_time, last_, last.depth);
}

Counterexample RunRecorder::take() {
  result_.requirement = *hit_;
  result_.when = *monitors_[*hit_].when();
  result_.words = monitors_[*hit_].words();
  result_.state = m_[last_.state].name;
  describeDue();
  describeValues();
  for (uint32_t i = 0; i < m_.always.size() && !last_.finished; ++i) {
    if (interpreter_->isHeldBack(i)) {
      result_.held_back.push_back(i);
    }
  }
  return std::move(result_);
}

}  // namespace glider::ir::prove
