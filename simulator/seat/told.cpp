// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/seat/told.h"

#include "hooks/protocol/decimal.h"

#include <algorithm>
#include <charconv>

namespace glider::simulator {

using hooks::SeatEvent;

std::string_view takePart(std::string_view& text, char separator) {
  const size_t end = std::min(text.find(separator), text.size());
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return part;
}

bool readWhole(std::string_view text, uint32_t& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

bool readReal(std::string_view text, double& value) {
  return hooks::readDecimal(text.data(), static_cast<uint32_t>(text.size()), &value);
}

SeatEvent toldIn(std::string_view text, double mission_time_s) {
  SeatEvent event;
  std::string_view rest = text;
  const std::string_view word = takePart(rest, ',');
  bool whole = true;
  if (word == "mission") {
    event.kind = SeatEvent::Kind::SbcHello;
    text = rest;
  } else if (word == "transition") {
    event.kind = SeatEvent::Kind::SbcTransition;
    whole = readReal(takePart(rest, ','), event.mission_time_s);
    for (uint32_t* number : {&event.a, &event.b, &event.c, &event.d, &event.e}) {
      whole = whole && readWhole(takePart(rest, ','), *number);
    }
  } else if (word == "note") {
    event.kind = SeatEvent::Kind::SbcNote;
    whole = readReal(takePart(rest, ','), event.mission_time_s) &&
            readWhole(takePart(rest, ','), event.a);
    text = whole ? rest : text;
  }
  if (!whole || event.kind == SeatEvent::Kind::None) {
    event = {};
    event.kind = SeatEvent::Kind::SbcNote;
    event.mission_time_s = mission_time_s;
  }
  text.copy(event.text, event.kind == SeatEvent::Kind::SbcHello ? hooks::kMostNameBytes
                                                                : hooks::kMostNoteBytes);
  return event;
}

}  // namespace glider::simulator
