// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/mission_story.h"

#include "hooks/protocol/notices.h"
#include "support/units/position_text.h"
#include "support/utc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

namespace glider::simulator {

using Kind = hooks::SeatEvent::Kind;

namespace {

/// Whether the number in an event stands for `value`.
template <typename Value>
bool is(uint32_t number, Value value) {
  return number == static_cast<uint32_t>(value);
}

/// Degrees of half of a position in ddmm.mmmm.
double degreesOf(double ddmm) {
  constexpr double kHundred = 100;
  constexpr double kMinutes = 60;
  const double whole = std::trunc(ddmm / kHundred);
  return std::copysign(std::fabs(whole) + std::fabs(ddmm - whole * kHundred) / kMinutes, ddmm);
}

/// `dated`: a time is of the calendar, not of the day.
std::string valueText(double value, const std::string& unit, bool dated) {
  if (!std::isfinite(value)) {
    return "unknown";
  }
  if (unit == "timestamp") {
    const std::string utc = support::utcText(value);
    const size_t time = dated || utc.find(' ') == utc.npos ? 0 : utc.find(' ') + 1;
    return utc.substr(time) + " UTC";
  }
  return unit == "lat"   ? support::latitudeText(degreesOf(value))
         : unit == "lon" ? support::longitudeText(degreesOf(value))
         : unit == "1"   ? fmt::format("{:.6g}", value)
                         : fmt::format("{:.6g} {}", value, unit);
}

/// Why hookprog gives the SBC no link.
std::string whyRefused(const hooks::SeatEvent& event) {
  if (event.a != hooks::kProtocolVersion) {
    return fmt::format("it uses version {} of the protocol, the vehicle version {}", event.a,
                       hooks::kProtocolVersion);
  }
  if (event.c == 0) {
    return "its list of sensors is not the vehicle's";
  }
  const uint8_t bit = hooks::lowestFeature(static_cast<uint16_t>(event.c));
  const char* name = hooks::featureName(bit);
  return fmt::format("the protocol feature {} is missing",
                     name != nullptr ? name : fmt::format("{}", bit));
}

/// Why hookprog wakes the SBC.
std::string whyWoken(const hooks::SeatEvent& event) {
  const char* why = hooks::napEndText(event.a);
  return why != nullptr ? why : "";
}

/// "goto, always case 3"
std::string howText(const hooks::SeatEvent& event) {
  const char* word = hooks::transitionWord(event.a);
  const char* kind = word != nullptr ? word : "?";
  return is(event.e, hooks::CaseList::Always) ? fmt::format("{}, always case {}", kind, event.d + 1)
                                              : kind;
}

}  // namespace

std::string MissionStory::stateName(uint32_t state) const {
  return state < state_names_.size() ? state_names_[state] : fmt::format("state {}", state);
}

void MissionStory::learnOrigin(double cycle_s, const hooks::SbcView& view, bool in_control) {
  flying_ = in_control && view.known && view.phase == hooks::MissionPhase::Flying;
  if (!flying_) {
    origin_s_ = in_control ? origin_s_ : std::numeric_limits<double>::infinity();
    return;
  }
  state_ = view.state;
  // What the SBC reports may lag behind the cycle that it answers, but is never ahead of it: the
  // least difference is the true one.
  origin_s_ = std::min(origin_s_, cycle_s - view.mission_time_s);
}

std::string MissionStory::why(const hooks::SeatEvent& event, const SimulatedSeat& seat) const {
  if (!explain_) {
    return "";
  }
  const GuardText text = explain_(event.e, event.b, event.d);
  const bool dated = text.guard.find("utc") != std::string::npos;
  std::string values;
  for (const uint16_t id : text.sensors) {
    if (id >= platform_.sensors.size()) {
      continue;
    }
    const auto& sensor = platform_.sensors[id];
    values += fmt::format("{}{} {}", values.empty() ? "" : ", ",
                          sensor.alias.empty() ? sensor.name : sensor.alias,
                          valueText(seat.reading(id), sensor.unit, dated));
  }
  return values.empty() ? text.guard : fmt::format("{} ({})", text.guard, values);
}

void MissionStory::transition(double now_s, const hooks::SeatEvent& event,
                              const SimulatedSeat& seat, Journal& journal) const {
  const double time =
      std::isfinite(origin_s_) ? std::min(now_s, origin_s_ + event.mission_time_s) : now_s;
  if (is(event.a, hooks::Transition::Exit)) {
    journal.add(time, EventId::MissionEnds, {stateName(event.b), howText(event)}, why(event, seat));
  } else {
    journal.add(time, EventId::Transition, {stateName(event.b), stateName(event.c), howText(event)},
                why(event, seat));
  }
  journal.events().back().mission_time_s = event.mission_time_s;
}

void MissionStory::note(double now_s, const hooks::SeatEvent& event, Journal& journal) const {
  const double time =
      std::isfinite(origin_s_) ? std::min(now_s, origin_s_ + event.mission_time_s) : now_s;
  if (is(event.a, hooks::NoteKind::UnknownSet)) {
    // The program has no room for the names of what the library keeps for itself.
    const bool inner = std::string_view(event.text).starts_with("the flight");
    journal.add(time, inner ? EventId::InnerValueKept : EventId::ValueKept, {event.text},
                inner ? "the new one is unknown, as a reading that it is computed from"
                      : "the new value is unknown");
  } else if (std::string_view(event.text) == hooks::kNoteDeclinationUnknown) {
    journal.add(time, EventId::DeclinationUnknown, {event.text});
  } else {
    journal.add(time, EventId::Note, {event.text});
  }
  journal.events().back().mission_time_s = event.mission_time_s;
}

bool MissionStory::follow(double now_s, double cycle_s, SimulatedSeat& seat, Journal& journal) {
  bool in_another_state = false;
  learnOrigin(cycle_s, seat.sbc(), seat.inControl());
  for (auto event = seat.nextEvent(); event.kind != Kind::None; event = seat.nextEvent()) {
    const double number = event.a;
    switch (event.kind) {
      case Kind::None:
        break;
      case Kind::SbcHello:
        journal.add(now_s, EventId::SbcAnswers, {event.text});
        break;
      case Kind::SbcLost:
        journal.add(now_s, EventId::SbcLost, {}, "none for 12 s");
        break;
      case Kind::SbcStuck:
        journal.add(now_s, EventId::SbcStuck, {}, "its time has not advanced for 12 s");
        break;
      case Kind::SbcUnanswered:
        journal.add(now_s, EventId::InstructionUnanswered, {number}, "none for 24 s");
        break;
      case Kind::SbcTransition:
        transition(now_s, event, seat, journal);
        in_another_state = true;
        break;
      case Kind::SbcNote:
        note(now_s, event, journal);
        break;
      case Kind::BadFrame:
        journal.add(now_s, EventId::FramesDamaged, {number});
        break;
      case Kind::SbcRefused:
        journal.add(now_s, EventId::SbcRefused, {}, whyRefused(event));
        break;
      case Kind::RefusedWrite:
        journal.add(now_s, EventId::WriteRefused, {number});
        break;
      case Kind::OldInstruction:
        journal.add(now_s, EventId::InstructionRepeated, {number},
                    "hookbeh refuses it: its number is old");
        break;
      case Kind::StaleFrame:
        journal.add(now_s, EventId::FramesRepeated, {number}, "they have an earlier time");
        break;
      case Kind::SbcNap:
        journal.add(now_s, EventId::SbcSleeps, {number});
        break;
      case Kind::SbcWoken:
        journal.add(now_s, EventId::SbcWoken, {static_cast<double>(event.b)}, whyWoken(event));
        break;
    }
  }
  return in_another_state;
}

}  // namespace glider::simulator
