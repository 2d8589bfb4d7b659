// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/guard_judge.h"

#include "hooks/hookbeh/hookbeh.h"
#include "hooks/protocol/messages.h"
#include "vehicles/slocum/oracles/commanded.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace glider::slocum::oracles {

using hooks::HookGuard;
using hooks::HookState;

namespace {

// A definite jump: from a depth that was right for a minute, by more than vehicle and noise can
// move it in hookbeh's longest cycle.
constexpr double kRight = 2;            // m
constexpr double kGuardRightSecs = 64;  // s
constexpr double kJump = 12;            // m
constexpr double kLongestCycle = 20;    // s
// hookbeh counts 240 s from the last metre gained, which itself may have taken as long.
constexpr double kStalledSecs = 504;  // s
constexpr double kStandsStill = 0.5;  // m
constexpr double kBelowSurface = 3;   // m
constexpr double kAwayCc = 30;    // a larger difference means two different commands to the pump
constexpr double kAwaySecs = 12;  // s

/// How many of the clocks that hookbeh uses are damaged in a flight.
int wrongClocks(const Faults& faults) {
  constexpr std::array<const char*, 3> kClocks = {"m_present_secs_into_mission", "m_present_time",
                                                  "m_cycle_number"};
  return static_cast<int>(std::ranges::count_if(kClocks, [&](const char* clock) {
    return std::ranges::any_of(faults.sensors,
                               [&](const SensorFault& fault) { return fault.name == clock; });
  }));
}

}  // namespace

GuardJudge::GuardJudge(const JudgeSetup& setup)
    : s_(setup), wrong_clocks_(wrongClocks(setup.faults)) {}

void GuardJudge::restart() {
  right_s_ = climbs_s_ = away_s_ = 0;
  stalled_ = false;
  hook_ = HookState::Absent;
}

/// Checks that hookbeh's own climbs use the full pump range, regardless of c_bpump_value for
/// ordinary climbs.
std::string GuardJudge::judgePump(const CycleView& view) const {
  const bool weak =
      climbsByItself(*view.hookbeh) && view.hookbeh->pump_cc < s_.pump_cc - kPumpError;
  return weak ? fmt::format("{} with {:.0f} cc, and the pump has {:.0f}",
                            hookWordsForDoing(view.hookbeh->doing), view.hookbeh->pump_cc,
                            s_.pump_cc)
              : "";
}

std::string GuardJudge::judgeJump(const CycleView& view) {
  const double reading = view.array.get(Sensor::m_depth);
  const double by = reading - reading_m_;
  const bool jumped = right_s_ >= kGuardRightSecs && view.time_s - last_s_ <= kLongestCycle &&
                      std::fabs(by) > kJump;
  const bool right = std::fabs(reading - view.true_depth_m) < kRight;
  right_s_ = right ? right_s_ + view.time_s - last_s_ : 0;
  reading_m_ = reading;
  return jumped && view.hook == HookState::Active && !climbs(*view.hookbeh)
             ? fmt::format("m_depth jumps by {:.1f} m, and hookbeh does not climb", by)
             : "";
}

/// Checks that a climb that gains no height gets the full pump range.
std::string GuardJudge::judgeClimb(const CycleView& view) {
  const double reading = view.array.get(Sensor::m_depth);
  const bool counts = view.hook == HookState::Active && climbs(*view.hookbeh) &&
                      !climbsByItself(*view.hookbeh) && !view.overridden() &&
                      reading > kBelowSurface;
  const bool moves = !(climbs_s_ > 0) || std::fabs(reading - stood_m_) >= kStandsStill;
  stood_m_ = moves ? reading : stood_m_;
  climbs_s_ = !counts ? 0 : moves ? s_.cycle_s : climbs_s_ + view.time_s - last_s_;
  return climbs_s_ > kStalledSecs
             ? fmt::format("climbs for {:.0f} s and gains no height, but no guard intervenes",
                           climbs_s_)
             : "";
}

/// The motion under another behaviour says nothing about hookbeh's dives and climbs.
std::string GuardJudge::judgeOverridden(const CycleView& view) {
  const HookGuard guard = view.hookbeh->guard;
  const bool stalled = guard == HookGuard::NoDepthGained || guard == HookGuard::NoHeightGained;
  const bool wrong = stalled && !stalled_ && away_s_ > kAwaySecs;
  const double off_cc = view.array.get(Sensor::c_ballast_pumped) - view.hookbeh->pump_cc;
  const bool away = view.overridden() && std::fabs(off_cc) > kAwayCc;
  away_s_ = away ? away_s_ + view.time_s - last_s_ : 0;
  // A guard lasts over sessions.
  stalled_ = view.hookbeh->commanding ? stalled : stalled_;
  return wrong ? fmt::format("the guard intervenes ({}) while another behaviour has the pump",
                             hookWordsForDoing(view.hookbeh->doing))
               : "";
}

/// hookbeh reports which of its commands of the previous cycle were not those flown. A wrong
/// reading of the commanded pump may add the pump.
std::string GuardJudge::judgeMasked(const CycleView& view) {
  const bool commands = view.hookbeh->commanding;
  const auto reported = static_cast<uint8_t>(view.array.get(Sensor::x_hook_masked));
  const uint8_t expected = commands ? masked_ : 0;
  const bool extra = (reported & ~expected & ~hooks::kMaskedPump) != 0;
  const bool wrong = extra || (expected & ~reported) != 0 || (!commands && reported != 0);
  masked_ = commands ? view.masked : 0;
  return wrong ? fmt::format("x_hook_masked is {}, but other behaviours replaced {}", reported,
                             expected)
               : "";
}

/// With one wrong clock a cycle may count twice, but no more.
bool GuardJudge::isTooSoon(const CycleView& view, double silent_s) const {
  const bool garbled =
      view.array.get(Sensor::x_hook_answer) == static_cast<double>(hooks::HookAnswer::BadCheck);
  return wrong_clocks_ == 1 && !garbled && silent_s < s_.args.silence_secs / 2;
}

/// A heartbeat counts if it is newer than all previous ones; one in the place of an SBC that sleeps
/// (negative) only for nap_secs after the last of the SBC itself.
std::string GuardJudge::judgeHeartbeat(const CycleView& view) {
  const double number = view.array.get(Sensor::sci_hook_heartbeat);
  const double beat = std::fabs(number);
  const bool whole = beat >= 0 && beat <= hooks::kMostSession && std::floor(beat) == beat;
  const bool newer =
      whole && hookIsNewerSession(static_cast<uint32_t>(beat), static_cast<uint32_t>(heartbeat_));
  const bool was_active = hook_ == HookState::Active;
  if (!was_active || newer) {
    // The numbers of one nap are all even or all odd, and those of the next the other way: then
    // the SBC itself has beaten after the last of the nap before.
    const bool another = number < 0 && last_number_ < 0 && std::fmod(beat - last_number_, 2) != 0;
    own_s_ = another ? heard_s_ : own_s_;
    last_number_ = whole ? number : last_number_;
    heartbeat_ = whole ? beat : heartbeat_;
    own_s_ = number >= 0 || !was_active ? view.time_s : own_s_;
    heard_s_ = number >= 0 || view.time_s - own_s_ < s_.args.nap_secs ? view.time_s : heard_s_;
  }
  // In the cycle in which hookbeh ends one session it may accept the next one's handshake.
  const double session = view.array.get(Sensor::x_hook_session);
  if (view.hook == HookState::Active && session > 0 && session != session_) {
    heard_s_ = own_s_ = view.time_s;
  }
  session_ = session;
  hook_ = view.hook;
  const double silent_s = view.time_s - heard_s_;
  if (was_active && view.hook == HookState::Silent && isTooSoon(view, silent_s)) {
    return fmt::format("control ends after {:.0f} s of silence", silent_s);
  }
  const double most = releaseSecs(Control::Silent, s_.hookbehTimes());
  return wrong_clocks_ == 0 && view.hook == HookState::Active && silent_s > most
             ? fmt::format("the SBC is in control without a newer heartbeat for {:.0f} s", silent_s)
             : "";
}

std::string GuardJudge::cycle(const CycleView& view) {
  if (view.hookbeh == nullptr) {
    return "";
  }
  const bool active = view.hook == HookState::Active;
  const std::array found = {active ? judgePump(view) : "", judgeJump(view),   judgeClimb(view),
                            judgeOverridden(view),         judgeMasked(view), judgeHeartbeat(view)};
  last_s_ = view.time_s;
  const auto* wrong =
      std::ranges::find_if(found, [](const std::string& words) { return !words.empty(); });
  return wrong != found.end() ? *wrong : "";
}

}  // namespace glider::slocum::oracles
