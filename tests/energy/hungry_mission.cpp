// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/energy/hungry_mission.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

namespace glider::tests {
namespace {

using ir::prove::Rng;
using Kind = DepthCommand::Kind;

constexpr int kShallowest_m = 2, kDeepest_m = 190;  // as deep.mi allows
constexpr int kFlattest_deg = 11, kSteepest_deg = 45;
constexpr int kCycle_s = 4;
constexpr size_t kMostTurns = 4, kMostLeads = 3, kMostStates = 4;

template <size_t n>
int oneOf(const std::array<int, n>& values, Rng& dice) {
  return values.at(dice.below(n));
}

int from(int least, int most, Rng& dice) {
  return least + static_cast<int>(dice.below(static_cast<uint64_t>(most - least + 1)));
}

// Few values: two that are close to each other, or the same, are likely.
int drawDepth(Rng& dice) {
  static constexpr std::array kDepths_m = {2,   3,   4,   5,   6,   8,   10,  12,  15,
                                           20,  25,  30,  40,  60,  80,  100, 120, 130,
                                           135, 140, 145, 150, 160, 170, 180, 190};
  return oneOf(kDepths_m, dice);
}

int drawPitch(Rng& dice) {
  static constexpr std::array kPitches_deg = {11, 15, 20, 26, 35, 45};
  return oneOf(kPitches_deg, dice);
}

int drawTime(Rng& dice) {
  return kCycle_s * from(2, 40, dice);
}

DepthCommand drawCommand(Rng& dice) {
  static constexpr std::array kKinds = {Kind::Descend, Kind::Descend, Kind::Ascend,
                                        Kind::Ascend,  Kind::Hover,   Kind::Surface};
  return {kKinds.at(dice.below(kKinds.size())), drawDepth(dice), drawPitch(dice)};
}

Comparison drawComparison(Asked asked, Rng& dice) {
  static constexpr std::array kAngles_deg = {-20, -10, 0, 10, 20};
  switch (asked) {
    case Asked::Deeper:
    case Asked::Shallower:
      return {asked, drawDepth(dice)};
    case Asked::PitchAbove:
    case Asked::PitchBelow:
      return {asked, oneOf(kAngles_deg, dice)};
    case Asked::Since:
    case Asked::StateTime:
      break;
  }
  return {asked, drawTime(dice)};
}

/// Of `usual`, now and then two together.
template <size_t n>
Guard drawGuard(const std::array<Asked, n>& usual, Rng& dice) {
  Guard guard;
  do {
    guard.push_back(drawComparison(usual.at(dice.below(n)), dice));
  } while (guard.size() < 2 && dice.chance(0.15));
  return guard;
}

Guard drawTurnGuard(Rng& dice) {
  static constexpr std::array kUsual = {
      Asked::Deeper,    Asked::Deeper,     Asked::Deeper,     Asked::Shallower, Asked::Shallower,
      Asked::Shallower, Asked::PitchAbove, Asked::PitchBelow, Asked::Since,     Asked::Since};
  return drawGuard(kUsual, dice);
}

Guard drawLeadGuard(Rng& dice) {
  static constexpr std::array kUsual = {Asked::StateTime, Asked::StateTime, Asked::Deeper,
                                        Asked::Shallower};
  return drawGuard(kUsual, dice);
}

ProfileTurn drawTurn(Rng& dice) {
  Guard guard = drawTurnGuard(dice);
  return {std::move(guard), drawCommand(dice)};
}

StateLead drawLead(size_t states, Rng& dice) {
  Guard guard = drawLeadGuard(dice);
  return {std::move(guard), dice.below(states)};
}

LibraryYo drawYo(Rng& dice) {
  const auto [top, bottom] = std::minmax({drawDepth(dice), drawDepth(dice)});
  return {top, std::max(bottom, top + 1), drawPitch(dice)};
}

HungryState drawState(size_t states, Rng& dice) {
  HungryState state;
  if (dice.chance(0.1)) {
    state.yo = drawYo(dice);
  }
  state.entry = drawCommand(dice);
  for (int i = from(1, 3, dice); i > 0; --i) {
    state.turns.push_back(drawTurn(dice));
  }
  for (int i = from(0, 2, dice); i > 0; --i) {
    state.leads.push_back(drawLead(states, dice));
  }
  return state;
}

// ---- Those that are known to take much ----------------------------------------------------------

/// Near the bottom of its dive it begins to rise, and is sent down again at once.
HungryMission nod(Rng& dice) {
  const int bottom = from(40, 150, dice);
  const int rise = bottom - from(1, 3, dice), again = rise - from(1, 3, dice);
  HungryState state;
  state.entry = {Kind::Descend, bottom, oneOf<4>({20, 26, 35, 45}, dice)};
  state.turns = {{{{Asked::Shallower, rise}}, {Kind::Surface, 0, 0}}};
  state.leads = {{{{Asked::Shallower, again}}, 0}};
  return {state};
}

/// Two states with the same deep yo, exchanged before it turns by itself: each begins with a dive.
HungryMission flop(Rng& dice) {
  HungryState dive;
  dive.yo = {20, 140, drawPitch(dice)};
  dive.leads = {{{{Asked::Deeper, from(130, 138, dice)}}, 1}};
  const int time = drawTime(dice);
  HungryState one = dive, other = dive;
  one.leads = {{{{Asked::StateTime, time}}, 2}};
  other.leads = {{{{Asked::StateTime, time}}, 1}};
  return {dive, one, other};
}

/// It turns as often as a yo can, at the surface too.
HungryMission shallowYo(Rng& dice) {
  HungryState state;
  const int top = from(kShallowest_m, 6, dice);
  state.yo = {top, top + from(1, 4, dice), oneOf<3>({26, 35, 45}, dice)};
  return {state};
}

/// Most of what it takes is the pump's, which turns it below.
HungryMission deepYo(Rng& dice) {
  HungryState state;
  const int top = from(60, 150, dice);
  state.yo = {top, top + from(5, 40, dice), drawPitch(dice)};
  return {state};
}

HungryMission hover(Rng& dice) {
  HungryState state;
  state.entry = {Kind::Hover, from(3, 10, dice), 0};
  return {state};
}

/// Its command changes with each sign that it has been obeyed.
HungryMission chatter(Rng& dice) {
  HungryState state;
  const int depth = drawDepth(dice), pitch = drawPitch(dice);
  state.entry = {Kind::Descend, std::min(depth + 3, kDeepest_m), pitch};
  const DepthCommand up{Kind::Ascend, std::max(depth - 3, kShallowest_m), pitch};
  if (dice.chance(0.5)) {
    state.turns = {{{{Asked::Deeper, depth}}, up}, {{{Asked::Shallower, depth}}, state.entry}};
  } else {
    const int time = kCycle_s * from(2, 12, dice);
    state.turns = {{{{Asked::Since, time}, {Asked::PitchBelow, 0}}, up},
                   {{{Asked::Since, time}, {Asked::PitchAbove, 0}}, state.entry}};
  }
  return {state};
}

// ---- Changes
// --------------------------------------------------------------------------------------

void nudgeDepth(int& depth_m, Rng& dice) {
  depth_m = std::clamp(depth_m + oneOf<6>({-3, -2, -1, 1, 2, 3}, dice), kShallowest_m, kDeepest_m);
}

void nudgePitch(int& pitch_deg, Rng& dice) {
  pitch_deg = std::clamp(pitch_deg + oneOf<4>({-5, -2, 2, 5}, dice), kFlattest_deg, kSteepest_deg);
}

void nudge(Comparison& one, Rng& dice) {
  switch (one.asked) {
    case Asked::Deeper:
    case Asked::Shallower:
      return nudgeDepth(one.value, dice);
    case Asked::PitchAbove:
    case Asked::PitchBelow:
      one.value += oneOf<2>({-3, 3}, dice);
      return;
    case Asked::Since:
    case Asked::StateTime:
      one.value = std::max(kCycle_s, one.value + kCycle_s * oneOf<4>({-2, -1, 1, 2}, dice));
      return;
  }
}

void changeCommand(DepthCommand& command, Rng& dice) {
  switch (dice.below(4)) {
    case 0:
      command = drawCommand(dice);
      return;
    case 1:
      return nudgePitch(command.pitch_deg, dice);
    default:
      return nudgeDepth(command.depth_m, dice);
  }
}

void changeTurn(ProfileTurn& turn, Rng& dice) {
  switch (dice.below(4)) {
    case 0:
      turn = drawTurn(dice);
      return;
    case 1:
      turn.guard = drawTurnGuard(dice);
      return;
    case 2:
      return nudge(turn.guard[dice.below(turn.guard.size())], dice);
    default:
      return changeCommand(turn.command, dice);
  }
}

void changeTurns(std::vector<ProfileTurn>& turns, Rng& dice) {
  const size_t one = turns.empty() ? 0 : dice.below(turns.size());
  if (turns.empty() || (turns.size() < kMostTurns && dice.chance(0.1))) {
    turns.insert(turns.begin() + static_cast<ptrdiff_t>(one), drawTurn(dice));
  } else if (turns.size() > 1 && dice.chance(0.1)) {
    turns.erase(turns.begin() + static_cast<ptrdiff_t>(one));
  } else {
    changeTurn(turns[one], dice);
  }
}

void changeLeads(std::vector<StateLead>& leads, size_t states, Rng& dice) {
  const size_t one = leads.empty() ? 0 : dice.below(leads.size());
  if (leads.empty() || (leads.size() < kMostLeads && dice.chance(0.3))) {
    leads.push_back(drawLead(states, dice));
  } else if (dice.chance(0.15)) {
    leads.erase(leads.begin() + static_cast<ptrdiff_t>(one));
  } else if (dice.chance(0.5)) {
    nudge(leads[one].guard.front(), dice);
  } else {
    leads[one] = drawLead(states, dice);
  }
}

void changeYo(LibraryYo& yo, Rng& dice) {
  nudgeDepth(dice.chance(0.5) ? yo.top_m : yo.bottom_m, dice);
  nudgePitch(yo.pitch_deg, dice);
  yo.bottom_m = std::max(yo.bottom_m, yo.top_m + 1);
}

void change(HungryMission& mission, Rng& dice) {
  HungryState& state = mission[dice.below(mission.size())];
  const double what = dice.unit();
  if (what < 0.05 && mission.size() < kMostStates) {
    const size_t before = dice.below(mission.size()), copy = mission.size();
    mission[before].leads.push_back({drawLeadGuard(dice), copy});
    mission.push_back(HungryState(state));
  } else if (what < 0.1) {
    state.yo = state.yo ? std::nullopt : std::optional(drawYo(dice));
  } else if (what < 0.35) {
    changeLeads(state.leads, mission.size(), dice);
  } else if (state.yo) {
    changeYo(*state.yo, dice);
  } else if (what < 0.5) {
    changeCommand(state.entry, dice);
  } else {
    changeTurns(state.turns, dice);
  }
}

// ---- Text
// -----------------------------------------------------------------------------------------

std::string text(const Comparison& one) {
  switch (one.asked) {
    case Asked::Deeper:
      return fmt::format("depth >= {} m", one.value);
    case Asked::Shallower:
      return fmt::format("depth <= {} m", one.value);
    case Asked::PitchAbove:
      return fmt::format("pitch > {} deg", one.value);
    case Asked::PitchBelow:
      return fmt::format("pitch < {} deg", one.value);
    case Asked::Since:
      return fmt::format("missiontime - since >= {} s", one.value);
    case Asked::StateTime:
      return fmt::format("statetime >= {} s", one.value);
  }
  std::abort();
}

std::string text(const Guard& guard) {
  std::string all;
  for (const Comparison& one : guard) {
    all += (all.empty() ? "" : " && ") + text(one);
  }
  return all;
}

std::string text(const DepthCommand& command) {
  switch (command.kind) {
    case Kind::Descend:
      return fmt::format("descend({} m, {} deg)", command.depth_m, command.pitch_deg);
    case Kind::Ascend:
      return fmt::format("ascend({} m, {} deg)", command.depth_m, command.pitch_deg);
    case Kind::Hover:
      return fmt::format("hover({} m)", command.depth_m);
    case Kind::Surface:
      return "surface()";
  }
  std::abort();
}

bool asksSince(const Guard& guard) {
  return std::ranges::find(guard, Asked::Since, &Comparison::asked) != guard.end();
}

std::string profileText(const HungryState& state, size_t number) {
  const bool timed = std::ranges::any_of(
      state.turns, [](const ProfileTurn& turn) { return asksSince(turn.guard); });
  std::string all =
      fmt::format("flightprofile p{}()\nbegin\n{}  entry do {} end\n", number,
                  timed ? "  var since: time = missiontime\n" : "", text(state.entry));
  all += state.turns.empty() ? "" : "  events\n";
  for (const ProfileTurn& turn : state.turns) {
    all += fmt::format("    case {} do {}{} end stay\n", text(turn.guard),
                       asksSince(turn.guard) ? "set since = missiontime " : "", text(turn.command));
  }
  return all + "end\n\n";
}

}  // namespace

std::string textOf(const HungryMission& mission) {
  std::string profiles, states;
  for (size_t i = 0; i < mission.size(); ++i) {
    const HungryState& state = mission[i];
    std::string profile = fmt::format("p{}()", i);
    if (state.yo) {
      profile = fmt::format("yo({} m, {} m, {} deg, {} deg)", state.yo->top_m, state.yo->bottom_m,
                            state.yo->pitch_deg, state.yo->pitch_deg);
    } else {
      profiles += profileText(state, i);
    }
    states += fmt::format(
        "state s{}\nbegin\n  flightroute heading(90 deg)\n  flightprofile {}\n"
        "  sensors missiontime, depth, pitch, statetime\n  events\n"
        "    case missiontime > 90 min exit\n",
        i, profile);
    for (const StateLead& lead : state.leads) {
      states += fmt::format("    case {} goto s{}\n", text(lead.guard), lead.to);
    }
    states += "end\n\n";
  }
  return "mission hungry\n\nassume no outage\n\n" + profiles + states;
}

HungryMission dangerousMission(size_t number, Rng& dice) {
  static constexpr std::array kKinds = {nod, flop, shallowYo, deepYo, hover, chatter};
  return kKinds.at(number % kKinds.size())(dice);
}

HungryMission drawHungryMission(Rng& dice) {
  HungryMission mission;
  const size_t states = 1 + dice.below(3);
  while (mission.size() < states) {
    mission.push_back(drawState(states, dice));
  }
  return mission;
}

HungryMission mutated(HungryMission mission, Rng& dice) {
  for (int i = from(1, 3, dice); i > 0; --i) {
    change(mission, dice);
  }
  return mission;
}

}  // namespace glider::tests
