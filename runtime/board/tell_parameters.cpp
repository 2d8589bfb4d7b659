// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "runtime/board/files.h"
#include "runtime/board/parameters.h"

namespace glider::runtime {

void tellParameters(const GliderMission& mission) {
  for (uint32_t i = 0; i < mission.parameter_count; ++i) {
    const GliderParameterInfo& parameter = mission.parameters[i];
    char line[120];
    Text text(line, sizeof line - 1);
    text.put(i == 0 ? "parameters:\n  " : "  ").put(parameter.name).put(" = ");
    writeQuantity(parameter, parameter.initial, text);
    const uint32_t before = text.size();
    text.put(", ");
    const uint32_t after = text.size();
    writeRange(parameter, text);
    text.cut(text.size() == after ? before : text.size());
    line[text.size()] = '\0';
    tell(line);
  }
}

}  // namespace glider::runtime
