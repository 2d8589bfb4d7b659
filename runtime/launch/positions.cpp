// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// A position at launch. A mission keeps it as two parameters, its latitude and its longitude.

#include "runtime/launch/launch.h"
#include "runtime/launch/quote.h"

#include <string.h>

namespace glider::runtime {
namespace {

/// `name` without `ending`; empty if it does not end so.
Piece without(const char* ending, const char* name) {
  const size_t size = strlen(name);
  const size_t tail = strlen(ending);
  const bool ends = size > tail && strcmp(name + (size - tail), ending) == 0;
  return ends ? Piece{name, name + (size - tail)} : Piece{name, name};
}

bool isNorthOrSouth(char c) {
  return c == 'N' || c == 'S';
}

bool isEastOrWest(char c) {
  return c == 'E' || c == 'W';
}

/// Takes from `text` what ends with the first letter of a latitude or longitude; empty if there is
/// none.
Piece takeHalf(Piece& text) {
  for (const char* end = text.begin; end != text.end; ++end) {
    if (isNorthOrSouth(*end) || isEastOrWest(*end)) {
      const Piece half = Piece{text.begin, end + 1}.trimmed();
      text = Piece{end + 1, text.end}.trimmed();
      return half;
    }
  }
  return {text.begin, text.begin};
}

/// What is wrong with the order of `39.175 N 73.83 W`, of which `north` is the part up to the first
/// letter; nullptr: nothing.
const char* wrongOrder(const Piece& north, const Piece& east) {
  if (north.empty()) {
    return "write it with letters";
  }
  if (isEastOrWest(north.end[-1])) {
    return "the latitude comes first";
  }
  if (east.empty()) {
    return "the longitude is missing";
  }
  if (*east.begin == ',') {
    return "write no comma";
  }
  return isEastOrWest(east.end[-1]) ? nullptr : "the longitude needs its letter, E or W";
}

}  // namespace

Piece positionOf(const GliderMission& mission, uint32_t parameter) {
  const char* last = mission.parameters[parameter].name;
  const Piece none{last, last};
  if (parameter + 1 >= mission.parameter_count) {
    return none;
  }
  const Piece first = without(".latitude", last);
  const Piece second = without(".longitude", mission.parameters[parameter + 1].name);
  const bool same =
      first.size() == second.size() && memcmp(first.begin, second.begin, first.size()) == 0;
  return same ? first : none;
}

bool Launch::assignPosition(uint32_t latitude, const Piece& given) {
  Piece east = given;
  const Piece north = takeHalf(east);
  if (const char* why = wrongOrder(north, east)) {
    return refusePosition(latitude, given, why);
  }
  double values[2] = {};
  for (uint32_t i = 0; i < 2; ++i) {
    const GliderParameterInfo& half = mission_.parameters[latitude + i];
    const Reading reading = readQuantity(i == 0 ? north : east, half.units, values[i]);
    if (reading != Reading::Good) {
      return refusePosition(latitude, given, whyNot(reading));
    }
    if (!(values[i] >= half.lowest && values[i] <= half.highest)) {
      return refusePosition(
          latitude, given,
          i == 0 ? "latitudes are from 90 S to 90 N" : "longitudes are from 180 W to 180 E");
    }
  }
  values_[latitude] = values[0];
  values_[latitude + 1] = values[1];
  return true;
}

bool Launch::refusePosition(uint32_t latitude, const Piece& given, const char* why) {
  Text text(problem_, kProblemBytes);
  quote(text, positionOf(mission_, latitude)).put(" cannot be ");
  quote(text, given);
  if (why != nullptr) {
    text.put(": ").put(why);
  }
  text.put("; a position is written `39.175 N 73.83 W`, `39 10.5 N 73 49.8 W` or ");
  return refuse(text.put("`3910.5 N 7349.8 W`"));
}

}  // namespace glider::runtime
