// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/files.h"
#include "runtime/board/parameters.h"

namespace glider::runtime {
namespace {

/// "home = 39.175 N 73.83 W".
void writePosition(const GliderMission& mission, uint32_t latitude, Text& text) {
  const Piece name = positionOf(mission, latitude);
  text.put(name.begin, name.size()).put(" = ");
  writeQuantity(mission.parameters[latitude], mission.parameters[latitude].initial, text);
  text.put(' ');
  const GliderParameterInfo& longitude = mission.parameters[latitude + 1];
  writeQuantity(longitude, longitude.initial, text);
}

/// "top = 5 m, at least 1 m".
void writeParameter(const GliderParameterInfo& parameter, Text& text) {
  text.put(parameter.name).put(" = ");
  writeQuantity(parameter, parameter.initial, text);
  char bytes[100];
  Text range(bytes, sizeof bytes);
  writeRange(parameter, range);
  if (range.size() > 0) {
    text.put(", ").put(range.bytes(), range.size());
  }
}

}  // namespace

void tellParameters(const GliderMission& mission) {
  for (uint32_t i = 0; i < mission.parameter_count; ++i) {
    char line[120];
    Text text(line, sizeof line - 1);
    text.put(i == 0 ? "parameters:\n  " : "  ");
    if (positionOf(mission, i).empty()) {
      writeParameter(mission.parameters[i], text);
    } else {
      writePosition(mission, i, text);
      ++i;
    }
    line[text.size()] = '\0';
    tell(line);
  }
}

}  // namespace glider::runtime
