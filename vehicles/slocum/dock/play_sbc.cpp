// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/findings.h"
#include "vehicles/slocum/dock/parts.h"
#include "vehicles/slocum/dock/steering.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace glider::slocum {
namespace {

using vehicles::DockEnd;
using vehicles::DockPart;

/// A vehicle whose port is on reports its clock in each control cycle.
constexpr double kCyclesToSpeak = 3;

void addNumbers(const DockRun& run, double seconds, const VehicleRecord& record,
                vehicles::DockResult& result) {
  const DockLine::Counts& counts = run.line().counts();
  result.numbers = {
      {"cycles", static_cast<double>(record.cycles.size())},
      {"sentences", static_cast<double>(counts.sentences)},
      {"sentences_a_second", static_cast<double>(counts.sentences) / std::max(seconds, 1.0)},
      {"damaged_sentences", counts.damaged},
      {"stray_bytes", static_cast<double>(counts.stray)},
      {"unknown_indices", static_cast<double>(record.unknown.size())},
      {"bytes_received", static_cast<double>(counts.bytes)},
      {"bytes_sent", static_cast<double>(counts.sent_bytes)}};
}

/// Waits for a sentence; false if no one sends one.
bool waitsForSentence(DockRun& run, VehicleRecord& record) {
  const DockTimes& times = run.setup().times;
  const double patience_s = std::max(times.listen_s, kCyclesToSpeak * times.cycle_s);
  run.hearWhile(
      run.now() + patience_s, [&] { return run.line().counts().sentences == 0; },
      [&](const std::string& body) { record.take(body, run.now()); });
  return run.line().counts().sentences > 0;
}

void hear(DockRun& run, VehicleRecord& record) {
  const double whole_s = run.setup().times.whole_s;
  const double begin_s = run.now();
  for (double at_s = begin_s; at_s < whole_s && !record.sbc_is_there;) {
    at_s = std::min(at_s + 1, whole_s);
    run.host().progress(fmt::format("{:.0f} of {:.0f} s, listening to the vehicle: {}, {}",
                                    run.now(), whole_s,
                                    counted(record.cycles.size(), "control cycle"),
                                    counted(run.line().counts().sentences, "sentence")));
    if (!run.hearUntil(at_s, [&](const std::string& body) { record.take(body, run.now()); })) {
      return;
    }
  }
}

/// It flies a mission file that was not built with the program: its parameters are for something
/// else.
bool fliesAnotherMission(const DockSetup& setup, const VehicleRecord& record) {
  const double number = record.value("u_mission_param_l");
  return record.value("x_in_gliderdos") != 1 && !std::isnan(number) &&
         number != setup.plan.port.program;
}

/// What was written, or why nothing was.
std::vector<vehicles::DockCheck> steeringFindings(const DockRun& run, const VehicleRecord& record,
                                                  const Steering& steering, bool agreed,
                                                  bool steered) {
  if (steered) {
    return steering.findings();
  }
  const char* why = !agreed ? "nothing was written: you did not agree"
                    : fliesAnotherMission(run.setup(), record)
                        ? "nothing was written: the vehicle flies another mission file"
                        : "nothing was written: the check ended before";
  return {notChecked("steering", "follows what is written", why)};
}

}  // namespace

void playSbc(DockRun& run, const std::vector<std::string>& arrived, vehicles::DockResult& result) {
  VehicleRecord record(run.setup());
  for (const std::string& body : arrived) {
    record.take(body, run.now());
  }
  if (!waitsForSentence(run, record)) {
    if (run.end() != DockEnd::LineGone) {
      result.checks.push_back(nobodyFinding(run, DockPart::Sbc, run.now()));
    }
    return;
  }
  Steering steering(run, record);
  bool agreed = false;
  if (run.host().confirm && !record.sbc_is_there) {
    agreed = run.host().confirm(steering.question());
    run.line().restart();  // what came while the user read does not count: some of it may be lost
    record = VehicleRecord(run.setup());
  }
  const double begin_s = run.now();
  hear(run, record);
  if (record.sbc_is_there) {
    result.checks.push_back(sameSideFinding(DockPart::Sbc));
    return;
  }
  const double seconds = run.now() - begin_s;
  const bool steered =
      agreed && run.end() == DockEnd::Complete && !fliesAnotherMission(run.setup(), record);
  if (steered) {
    steering.steer();
  }
  result.played = DockPart::Sbc;
  addNumbers(run, seconds, record, result);
  result.checks.push_back(lineFinding(run.line()));
  std::ranges::copy(vehicleFindings(run.setup(), run.line(), run.host().baud, seconds, record),
                    std::back_inserter(result.checks));
  if (run.host().confirm) {
    std::ranges::copy(steeringFindings(run, record, steering, agreed, steered),
                      std::back_inserter(result.checks));
  }
}

}  // namespace glider::slocum
