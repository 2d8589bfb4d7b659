// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/parameter_table.h"

namespace glider::flights {

ParameterTable::ParameterTable(const ir::Mission& mission) : infos_(ir::parameterInfos(mission)) {
  for (const ir::ParameterInfo& info : infos_) {
    rows_.push_back({.name = info.name.c_str(),
                     .initial = info.initial,
                     .lowest = info.lowest,
                     .highest = info.highest,
                     .units = info.units.c_str()});
  }
  mission_.parameter_count = static_cast<uint32_t>(rows_.size());
  mission_.parameters = rows_.data();
}

}  // namespace glider::flights
