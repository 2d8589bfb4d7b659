// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/flight_judge.h"

#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/messages.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::slocum::oracles {

using hooks::HookState;

namespace {

constexpr double kFlightAtSurface = 1;  // m
constexpr double kSettledSecs = 60;     // s at the surface after which nothing more is expected
constexpr double kRelease = static_cast<double>(hooks::HookControl::Release);
constexpr double kTake = static_cast<double>(hooks::HookControl::Take);

std::string words(std::pair<double, double> number) {
  return fmt::format("instruction {} of session {}", number.second, number.first);
}

/// The instruction that was written, with any check value.
hooks::Instruction instructionIn(const hooks::InstructionWords& words) {
  hooks::Instruction instruction;
#define WORD(role, sensor, word, field, ...) \
  instruction.field = static_cast<decltype(instruction.field)>(words.word);
#include "hooks/protocol/instruction.def"
  return hooks::inSteps(instruction);
}

bool same(const hooks::InstructionWords& one, const hooks::InstructionWords& other) {
  return std::ranges::all_of(hooks::kInstructionWords, [&](const hooks::InstructionWord& word) {
    return one.*word.word == other.*word.word;
  });
}

}  // namespace

FlightJudge::FlightJudge(JudgeSetup setup)
    : setup_(std::move(setup)),
      depth_(setup_),
      commands_(setup_),
      guards_(setup_),
      needless_(setup_),
      bottom_(setup_),
      ascent_(setup_),
      battery_(setup_),
      pump_(setup_),
      position_(setup_),
      surface_(setup_),
      handshake_(setup_),
      last_end_s_(setup_.faults.lastEnd()),
      stated_(statedTimes(setup_.faults, setup_.controlTimes())) {
  for_ever_ = std::ranges::any_of(
      stated_.releases, [](const Release& release) { return release.when.to_s == kForever; });
}

void FlightJudge::violate(JudgeId judge, double now_s, std::string what) {
  if (std::ranges::find(verdict_.violations, judge, &Violation::judge) ==
      verdict_.violations.end()) {
    verdict_.violations.push_back({judge, now_s, std::move(what)});
  }
}

void FlightJudge::said(std::span<const uint8_t> bytes, double now_s) {
  for (const uint8_t byte : bytes) {
    if (!decoder_.push(byte)) {
      continue;
    }
    hooks::SensorList list;
    if (decoder_.frame().type == hooks::MessageType::Write &&
        hooks::decodeList(setup_.dictionary->get(), decoder_.frame(), list)) {
      hear(list, now_s);
    }
    hearDone(decoder_.frame(), now_s);
  }
}

void FlightJudge::hear(const hooks::SensorList& write, double now_s) {
  Words instruction;
  for (const hooks::InstructionWord& one : hooks::kInstructionWords) {
    const uint16_t id = hooks::sensorOf(setup_.dictionary->get(), one.role);
    for (uint32_t k = 0; k < write.count; ++k) {
      instruction.*one.word =
          write.values[k].id == id ? write.values[k].value : instruction.*one.word;
    }
  }
  const Number number{instruction.session, instruction.sequence};
  const auto [known, is_new] = said_.try_emplace(number, instruction);
  if (!is_new && !same(known->second, instruction) && !obeyed_.contains(number)) {
    known->second = instruction;  // of a program that was restarted
  } else if (!is_new && !same(known->second, instruction)) {
    violate(JudgeId::Instructions, now_s, words(number) + " is repeated with other content");
  }
  if (instruction.control == kTake) {
    handshake_.asked(number.first, number.second, now_s);
  }
  if (number != newest_) {
    newest_ = number;
    newest_said_s_ = now_s;
    newest_answered_ = false;
  }
}

void FlightJudge::hearDone(const hooks::Frame& frame, double now_s) {
  hooks::Done done;
  if (!hooks::decode(frame, done)) {
    return;
  }
  if (done.session != session_ || done.status.mission_time_s > mission_time_s_) {
    progress_s_ = now_s;
  }
  session_ = done.session;
  mission_time_s_ = done.status.mission_time_s;
}

void FlightJudge::judgeObeyed(const CycleView& view) {
  // After an abort hookbeh no longer runs, and when silent it obeys nothing: its last answer stays
  // in the array. When complete, it reports no session.
  const bool completes = view.hook == HookState::Complete && !exited_;
  if (view.aborted || !(view.hook == HookState::Active || completes)) {
    return;
  }
  const Sensor session = completes ? Sensor::sci_hook_session : Sensor::x_hook_session;
  const Number number{view.array.get(session), view.array.get(Sensor::x_hook_sequence)};
  const bool accepted =
      view.array.get(Sensor::x_hook_answer) == static_cast<double>(hooks::HookAnswer::Accepted);
  if (!accepted || number == decided_) {
    return;
  }
  decided_ = number;
  Words words_obeyed;
#define WORD(role, sensor, word, ...) words_obeyed.word = view.array.get(Sensor::sensor);
#define CHECK_WORD(role, sensor, word, line) words_obeyed.word = view.array.get(Sensor::sensor);
// Of a mission without the feature the sensor holds nothing, which counts as 0.
#define LATER_WORD(role, sensor, word, ...) \
  words_obeyed.word = std::max(0.0, view.array.get(Sensor::sensor));
#include "hooks/protocol/instruction.def"
  ++verdict_.instructions;
  const auto found = said_.find(number);
  if (found == said_.end() || !same(found->second, words_obeyed)) {
    violate(JudgeId::Instructions, view.time_s,
            words(number) + " is obeyed, but was sent differently");
  }
  if (!obeyed_.insert(number).second) {
    violate(JudgeId::Instructions, view.time_s, words(number) + " is obeyed twice");
  }
  judgeSession(view, number, words_obeyed);
}

void FlightJudge::judgeSession(const CycleView& view, Number number, const Words& words_obeyed) {
  if (exited_) {
    violate(JudgeId::Instructions, view.time_s,
            words(number) + " is obeyed after control was released");
  }
  if (!exited_ && words_obeyed.control == kRelease) {
    exited_ = true;
    verdict_.release_s = view.time_s;
  }
  const bool begins = hook_ != HookState::Active || number.first != session_in_control_;
  if (begins && view.hook == HookState::Active) {
    if (words_obeyed.control != kTake) {
      violate(JudgeId::Instructions, view.time_s, "control is taken without a handshake");
    } else if (lost_session_ != 0 && !hookIsNewerSession(static_cast<uint32_t>(number.first),
                                                         static_cast<uint32_t>(lost_session_))) {
      violate(JudgeId::Instructions, view.time_s,
              fmt::format("session {} takes control though session {} has lost it", number.first,
                          lost_session_));
    }
    verdict_.take_s = verdict_.take_s == 0 ? view.time_s : verdict_.take_s;
  }
  session_in_control_ = number.first;
}

/// The flight controller's mission has restarted: a new hookbeh, which does not know any session.
void FlightJudge::followRestart(const CycleView& view) {
  if (view.mission_s < mission_s_) {
    exited_ = false;
    hook_ = HookState::Absent;
    session_in_control_ = lost_session_ = 0;
    answered_ = {0, 0};
    commands_.restart();
    guards_.restart();
    needless_.restart();
    bottom_.restart();
    surface_.restart();
  }
  mission_s_ = view.mission_s;
}

/// Checks hookbeh's answer to an instruction, once for each that it has decided on.
void FlightJudge::judgeAnswer(const CycleView& view) {
  const auto answer = static_cast<hooks::HookAnswer>(view.array.get(Sensor::x_hook_answer));
  const Number number{view.array.get(Sensor::sci_hook_session),
                      view.array.get(Sensor::x_hook_sequence)};
  const bool decided = view.hookbeh != nullptr && answer != hooks::HookAnswer::None &&
                       answer != hooks::HookAnswer::BadCheck &&
                       number.second == view.array.get(Sensor::sci_hook_sequence);
  const auto said = said_.find(number);
  if (!decided || number == answered_ || said == said_.end()) {
    return;
  }
  answered_ = number;
  if (std::string wrong = commands_.answered(instructionIn(said->second), answer); !wrong.empty()) {
    violate(JudgeId::Commands, view.time_s, std::move(wrong));
  }
}

/// Checks that control also ends in time if the SBC is alive but its instruction does not arrive
/// intact.
void FlightJudge::judgeGarbled(const CycleView& view) {
  const bool garbled =
      view.hook == HookState::Active &&
      view.array.get(Sensor::x_hook_answer) == static_cast<double>(hooks::HookAnswer::BadCheck);
  garbled_since_s_ = !garbled ? -1 : garbled_since_s_ < 0 ? view.time_s : garbled_since_s_;
  const double most = releaseSecs(Control::Silent, setup_.hookbehTimes());
  if (garbled && view.time_s - garbled_since_s_ > most) {
    violate(JudgeId::Times, view.time_s,
            fmt::format("the SBC is in control though its instruction is garbled "
                        "for {:.0f} s",
                        view.time_s - garbled_since_s_));
  }
}

void FlightJudge::judgeTimes(const CycleView& view) {
  // hookbeh answers every instruction, and repeats its last answer until the next.
  const bool answered =
      view.array.get(Sensor::x_hook_sequence) == newest_.second &&
      view.array.get(Sensor::x_hook_answer) != static_cast<double>(hooks::HookAnswer::BadCheck);
  newest_answered_ = newest_answered_ || answered;
  if (view.hook != HookState::Active) {
    newest_said_s_ = view.time_s;
    return;
  }
  if (!newest_answered_ && view.time_s - newest_said_s_ > stated_.most_unanswered_s) {
    violate(JudgeId::Times, view.time_s,
            fmt::format("{} is lost: no answer for {:.0f} s", words(newest_),
                        view.time_s - newest_said_s_));
  }
  if (view.time_s - progress_s_ > stated_.most_standstill_s) {
    violate(JudgeId::Times, view.time_s,
            fmt::format("the SBC is in control though its mission made no progress for {:.0f} s",
                        view.time_s - progress_s_));
  }
  for (const Release& release : stated_.releases) {
    // A cycle at exactly that time may still be the last one.
    if (view.time_s > release.when.from_s && release.when.has(view.time_s)) {
      violate(JudgeId::Times, view.time_s, "the SBC is in control though " + release.why);
    }
  }
}

bool FlightJudge::isOverForGood(const CycleView& view) {
  const bool is_up = view.hook != HookState::Active && at_surface_;
  up_since_s_ = !is_up ? -1 : up_since_s_ < 0 ? view.time_s : up_since_s_;
  if (!is_up || view.time_s <= last_end_s_ || view.time_s - up_since_s_ <= kSettledSecs) {
    return false;
  }
  const bool complete = view.hook == HookState::Complete && setup_.only_hookbeh;
  return view.aborted || complete ||
         (for_ever_ && std::ranges::any_of(stated_.releases, [&](const Release& release) {
            return release.when.to_s == kForever && release.when.has(view.time_s);
          }));
}

void FlightJudge::noteHover(const CycleView& view) {
  const bool hovers = view.hookbeh != nullptr && view.hook == HookState::Active &&
                      view.hookbeh->doing == hooks::Doing::Hover;
  hovers_since_s_ = !hovers ? -1 : hovers_since_s_ < 0 ? view.time_s : hovers_since_s_;
  if (hovers && view.time_s - hovers_since_s_ > verdict_.hover.to_s - verdict_.hover.from_s) {
    verdict_.hover = {hovers_since_s_, view.time_s};
  }
}

void FlightJudge::judgeAll(const CycleView& view) {
  const auto take = [&](JudgeId judge, std::string wrong) {
    if (!wrong.empty()) {
      violate(judge, view.time_s, std::move(wrong));
    }
  };
  take(JudgeId::Commands, commands_.cycle(view));
  take(JudgeId::Guards, guards_.cycle(view));
  take(JudgeId::Needless, needless_.cycle(view));
  take(JudgeId::Depth, depth_.cycle(view));
  take(JudgeId::Bottom, bottom_.cycle(view));
  take(JudgeId::Ascent, ascent_.cycle(view));
  take(JudgeId::Battery, battery_.cycle(view));
  take(JudgeId::Pump, pump_.cycle(view, commands_.inForce()));
  take(JudgeId::Position, position_.cycle(view));
  take(JudgeId::Surface, surface_.cycle(view, commands_.inForce()));
  take(JudgeId::Handshake, handshake_.cycle(view));
}

bool FlightJudge::cycle(const CycleView& view) {
  followRestart(view);
  judgeAnswer(view);
  judgeObeyed(view);
  const bool was_active = hook_ == HookState::Active;
  if (was_active && view.hook == HookState::Silent) {
    lost_session_ = session_in_control_;
  }
  if (!was_active && view.hook == HookState::Active) {
    progress_s_ = std::max(progress_s_, view.time_s);  // from here on it must make progress
  }
  hook_ = view.hook;
  judgeTimes(view);
  judgeGarbled(view);
  judgeAll(view);
  noteHover(view);
  verdict_.deepest_m = depth_.deepest();
  verdict_.mean_W = view.time_s > 0 ? view.used_J / view.time_s : 0;
  const bool lost = was_active && hook_ != HookState::Active && !exited_;
  verdict_.releases += lost;
  lost_while_whole_ += lost && setup_.promiseAt(view.time_s).control == Control::Kept;
  ended_ = view.ended;
  at_surface_ = view.true_depth_m < kFlightAtSurface;
  verdict_.end_s = view.time_s;
  return !isOverForGood(view);
}

std::string FlightJudge::violationAtEnd() const {
  // The vehicle may have ended its own mission, at the surface, while the SBC had control.
  if (hook_ == HookState::Active && !ended_) {
    return "the flight does not end in time";
  }
  // The time for the flight may end shortly after a dive.
  if (!at_surface_ && (ended_ || !ascent_.isComingUp())) {
    return ended_ ? "the flight ends under water" : "not at the surface in time";
  }
  if (lost_while_whole_ > 0) {
    return "the SBC loses control without a reason";
  }
  if (setup_.promise.control == Control::Kept && setup_.has_hookbeh && !exited_) {
    return "the mission does not release control";
  }
  return "";
}

Verdict FlightJudge::verdict() const {
  Verdict verdict = verdict_;
  verdict.outcome = exited_ ? Verdict::Outcome::Exited : Verdict::Outcome::Released;
  if (std::string wrong = violationAtEnd(); !wrong.empty()) {
    verdict.violations.push_back({JudgeId::Ending, verdict.end_s, std::move(wrong)});
  }
  if (!verdict.violations.empty()) {
    verdict.outcome = Verdict::Outcome::Violation;
    verdict.violation = verdict.violations.front().what;
    verdict.violation_s = verdict.violations.front().at_s;
  }
  return verdict;
}

}  // namespace glider::slocum::oracles
