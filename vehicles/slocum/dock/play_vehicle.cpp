// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/findings.h"
#include "vehicles/slocum/dock/parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>

namespace glider::slocum {
namespace {

using vehicles::DockPart;

/// So many reports without any answer: no one is there.
constexpr size_t kToAnswer = 3;

double secondsSince1970() {
  return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

const char* sceneText(DockScene scene) {
  switch (scene) {
    case DockScene::Prompt:
      return "at the prompt";
    case DockScene::OtherMission:
      return "flying another mission file";
    case DockScene::OwnMission:
      return "flying the mission file of the folder";
    case DockScene::PromptAgain:
      break;
  }
  return "at the prompt again";
}

/// Says the report of a cycle; records when all of it has been handed over.
void report(DockRun& run, const DockCycle& cycle, SbcRecord& record) {
  uint64_t bytes = 0;
  if (cycle.restarts_port) {
    run.line().say("BY");
    run.line().say("HI");
  }
  for (const std::string& body : reportOf(cycle, run.setup())) {
    run.line().say(body);
    bytes += body.size() + hooks::extctl::kSentenceEnd + 1;
  }
  record.begin(cycle, run.now(), bytes);
}

bool isSilent(const DockRun& run, const SbcRecord& record) {
  const DockLine::Counts& counts = run.line().counts();
  return record.cycles.size() >= kToAnswer && counts.sentences == counts.echoes;
}

void addNumbers(const DockRun& run, const SbcRecord& record, vehicles::DockResult& result) {
  const DockLine::Counts& counts = run.line().counts();
  const auto answered = std::ranges::count_if(
      record.cycles, [](const AnsweredCycle& cycle) { return cycle.answered_s.has_value(); });
  result.numbers = {{"reports", static_cast<double>(record.cycles.size())},
                    {"answers", static_cast<double>(answered)},
                    {"sentences", static_cast<double>(counts.sentences)},
                    {"damaged_sentences", counts.damaged},
                    {"stray_bytes", static_cast<double>(counts.stray)},
                    {"echoes", counts.echoes},
                    {"bytes_sent", static_cast<double>(counts.sent_bytes)},
                    {"bytes_received", static_cast<double>(counts.bytes)}};
}

/// Plays the cycles; false if no one answers, or a vehicle is there.
bool playAll(DockRun& run, SbcRecord& record) {
  const DockTimes& times = run.setup().times;
  const double begin_s = run.now();
  const auto count =
      static_cast<uint32_t>(std::max(1.0, std::round((times.whole_s - begin_s) / times.cycle_s)));
  const auto take = [&](const std::string& body) { record.take(body, run.now()); };
  run.line().say("HI");
  size_t said = 0;
  for (const DockCycle& cycle : playCycles(count, std::floor(secondsSince1970()))) {
    report(run, cycle, record);
    run.host().progress(
        fmt::format("{:.0f} of {:.0f} s, {}: {}", run.now(), times.whole_s, sceneText(cycle.scene),
                    counted(run.line().counts().sentences, "sentence") + " received"));
    ++said;
    if (!run.hearUntil(begin_s + static_cast<double>(said) * times.cycle_s, take)) {
      break;
    }
    if (isSilent(run, record) || record.vehicle_is_there) {
      return false;
    }
  }
  run.line().say("BY");
  return run.line().counts().sentences > run.line().counts().echoes;
}

}  // namespace

void playVehicle(DockRun& run, bool told, vehicles::DockResult& result) {
  SbcRecord record(static_cast<uint32_t>(run.setup().sensors.parameters.size() +
                                         run.setup().sensors.written.size()));
  const bool answered = playAll(run, record);
  addNumbers(run, record, result);
  if (record.vehicle_is_there) {
    result.checks.push_back(sameSideFinding(DockPart::Vehicle));
    return;
  }
  // A report without the time for its answer is not counted.
  if (run.end() != vehicles::DockEnd::Complete && !record.cycles.empty() &&
      !record.cycles.back().answered_s) {
    record.cycles.pop_back();
  }
  if (!answered) {
    if (run.end() != vehicles::DockEnd::LineGone) {
      result.checks.push_back(
          nobodyFinding(run, told ? DockPart::Vehicle : DockPart::Auto, run.now()));
    }
    return;
  }
  result.played = DockPart::Vehicle;
  result.checks.push_back(lineFinding(run.line()));
  result.has_begun = std::ranges::any_of(record.cycles, steers);
  std::ranges::copy(sbcFindings(run.setup(), run.line(), run.host().baud, record),
                    std::back_inserter(result.checks));
}

}  // namespace glider::slocum
