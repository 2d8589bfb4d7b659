// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/flight/behaviours/hookbeh_adapter.h"

#include "simulator/slocum/flight/behaviours/refusal_text.h"
#include "simulator/slocum/flight/behaviours/source.h"
#include "support/listed.h"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace glider::simulator {

using hooks::HookAnswer;
using hooks::HookState;

namespace {

hooks::HookbehInputs inputs(const Situation& s) {
  const SensorArray& a = *s.array;
  hooks::HookbehInputs in;
  in.time_s = a.get(Sensor::m_present_secs_into_mission);
  in.wall_time_s = a.get(Sensor::m_present_time);
  in.cycle_number = a.get(Sensor::m_cycle_number);
  const bool ctd_is_new = a.fresh(Sensor::sci_water_pressure);
  in.ctd_bar =
      ctd_is_new ? a.get(Sensor::sci_water_pressure) : std::numeric_limits<double>::quiet_NaN();
  in.commanded_pump_cc = a.get(Sensor::c_ballast_pumped);
  in.depth_m = s.depth_m;
  in.depth_rate_mps = s.depth_rate_mps;
  in.altitude_m = s.altitude_m;
  in.latitude_ddmm = s.latitude_ddmm;
  in.longitude_ddmm = s.longitude_ddmm;
  in.heartbeat = a.get(Sensor::sci_hook_heartbeat);
#define WORD(role, sensor, word, ...) in.words.word = a.get(Sensor::sensor);
#define CHECK_WORD(role, sensor, word, line) in.words.word = a.get(Sensor::sensor);
#define LATER_WORD(role, sensor, word, field, line) in.words.word = a.get(Sensor::sensor);
#include "hooks/protocol/instruction.def"
  return in;
}

HeadingCommand heading(const hooks::HookbehOutputs& out) {
  switch (out.heading_mode) {
    case hooks::HeadingMode::Heading:
      return {HeadingCommand::Mode::Heading, out.heading_rad, 0, 0};
    case hooks::HeadingMode::Waypoint:
      return {HeadingCommand::Mode::Waypoint, 0, out.latitude_ddmm, out.longitude_ddmm};
    case hooks::HeadingMode::Fin:
      return {HeadingCommand::Mode::Fin, out.fin_rad, 0, 0};
    case hooks::HeadingMode::CentreFin:
      break;
  }
  return {HeadingCommand::Mode::Fin, 0, 0, 0};
}

EventId changeTo(HookState state) {
  switch (state) {
    case HookState::Absent:
      return EventId::HookbehAbsent;
    case HookState::Waiting:
      return EventId::HookbehWaits;
    case HookState::Ready:
      return EventId::HookbehReady;
    case HookState::Active:
      return EventId::SbcTakesControl;
    case HookState::Silent:
      return EventId::SbcSilent;
    case HookState::Complete:
      break;
  }
  return EventId::SbcReleasesControl;
}

/// "heading, pitch and pump" for kHookMaskedHeading….
std::string channels(uint8_t masked) {
  std::vector<std::string> names;
  for (const auto& [bit, name] : {std::pair(kHookMaskedHeading, "heading"),
                                  {kHookMaskedPitch, "pitch"},
                                  {kHookMaskedPump, "pump"}}) {
    if ((masked & bit) != 0) {
      names.emplace_back(name);
    }
  }
  return support::listed(names);
}

/// Answers that do not concern the command itself: the instruction was damaged, early, old or of
/// another session, and is sent again if it still counts.
bool isOfTheLink(HookAnswer answer) {
  return answer == HookAnswer::BadCheck || answer == HookAnswer::WrongSession ||
         answer == HookAnswer::NotReady || answer == HookAnswer::OldSequence;
}

}  // namespace

hooks::HookbehArgs hookbehArgs(const slocum::BehaviourBlock& block) {
  hooks::HookbehArgs args;
  args.start_secs = block.value("start_secs");
  args.greatest_depth_m = block.value("max_depth");
  args.least_altitude_m = block.value("min_altitude");
  args.steepest_pitch_rad = block.value("max_pitch");
  args.shallowest_pitch_rad = block.value("min_pitch");
  args.greatest_fin_rad = block.value("max_fin");
  args.greatest_pump_cc = block.value("max_pump");
  args.greatest_battery_in = block.value("max_battery");
  args.silence_secs = block.value("silence_secs");
  args.nap_secs = block.value("nap_secs");
  args.dive_pump_mode = static_cast<hooks::PumpMode>(block.value("d_use_bpump"));
  args.climb_pump_mode = static_cast<hooks::PumpMode>(block.value("c_use_bpump"));
  args.dive_pump_cc = block.value("d_bpump_value");
  args.climb_pump_cc = block.value("c_bpump_value");
  args.hold_secs = block.value("hold_secs");
  return args;
}

HookbehAdapter::HookbehAdapter(const BehaviourSource& source)
    : Behaviour(source.block.name),
      limits_(hooks::within(hookbehArgs(source.block), source.hull)),
      hookbeh_(hookbehArgs(source.block), source.hull) {}

void HookbehAdapter::note(const hooks::HookbehInputs& in, const hooks::HookbehOutputs& out) {
  if (out.state != state_) {
    news_.push_back({changeTo(out.state)});
  }
  if (out.masked != masked_now_) {
    news_.push_back(out.masked == 0 ? News{EventId::CommandsFly}
                                    : News{EventId::CommandsMasked, {channels(out.masked)}});
  }
  noteAnswer(in, out);
  if (out.commanding && doing_ != out.doing) {
    const bool guards = out.guard != hooks::HookGuard::None;
    news_.push_back({guards ? EventId::GuardClimbs : EventId::Steers,
                     {hookWordsForDoing(out.doing), in.depth_m}});
  }
  state_ = out.state;
  masked_now_ = out.masked;
  doing_ = out.commanding ? out.doing : hooks::Doing::Nothing;
}

/// The words of an instruction arrive one by one: it is news only if they stay incomplete for
/// longer than the line takes.
void HookbehAdapter::noteAnswer(const hooks::HookbehInputs& in, const hooks::HookbehOutputs& out) {
  constexpr double kMostSpread = 12;  // s: the lag of the line, and a cycle
  const bool garbled = out.answer == HookAnswer::BadCheck;
  if (!garbled || out.answered_sequence != garbled_sequence_) {
    garbled_since_s_ = in.time_s;
    garbled_sequence_ = garbled ? out.answered_sequence : uint16_t{0};
  }
  if (garbled && in.time_s - garbled_since_s_ <= kMostSpread) {
    return;
  }
  const bool news = out.answered_sequence != answered_ || out.answer != answer_;
  if (news && out.answer != HookAnswer::Accepted && out.answer != HookAnswer::None) {
    const double number = out.answered_sequence;
    news_.push_back(
        {isOfTheLink(out.answer) ? EventId::InstructionIgnored : EventId::InstructionRefused,
         {number, refusalText(out.answer, in, limits_)}});
  }
  answered_ = out.answered_sequence;
  answer_ = out.answer;
}

Behaviour::Outcome HookbehAdapter::fly(const Situation& situation, Commands& commands) {
  hooks::HookbehInputs in = inputs(situation);
  in.masked = masked();
  const hooks::HookbehOutputs out = hookbeh_.cycle(in);
  SensorArray& array = *situation.array;
  array.set(Sensor::x_hook_state, static_cast<double>(out.state));
  array.set(Sensor::x_hook_answer, static_cast<double>(out.answer));
  array.set(Sensor::x_hook_sequence, out.answered_sequence);
  array.set(Sensor::x_hook_session, out.session);
  array.set(Sensor::x_hook_guard, static_cast<double>(out.guard));
  array.set(Sensor::x_hook_masked, out.masked);
  array.set(Sensor::x_hook_nap_secs, out.nap_secs);
  if (out.commanding) {
    commands.steer(heading(out));
    const bool servo = out.pitch_mode == hooks::PitchMode::Servo;
    commands.point(servo ? PitchCommand{PitchCommand::Mode::Servo, out.pitch_rad}
                         : PitchCommand{PitchCommand::Mode::BatteryPosition, out.battery_in});
    commands.pump(out.pump_cc);
    commands.altimeter = commands.altimeter || out.altimeter;
    commands.sampling = out.sampling;
  }
  outputs_ = out;
  note(in, out);
  // When complete, it still reports its state in every cycle, so it is never Done for the stack.
  return Outcome::Continue;
}

void HookbehAdapter::tell(double time_s, Journal& journal) {
  journal.add(time_s, news_);
}

}  // namespace glider::simulator
