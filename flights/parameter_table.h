// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/parameter_info.h"
#include "runtime/abi/glider_abi.h"

#include <vector>

namespace glider::flights {

/// The parameters of a mission as the runtime reads them at launch, made from the IR: nothing is
/// compiled.
class ParameterTable {
 public:
  explicit ParameterTable(const ir::Mission& mission);
  ParameterTable(const ParameterTable&) = delete;
  ParameterTable& operator=(const ParameterTable&) = delete;

  /// Holds the parameters and nothing else: no state, no `where`.
  [[nodiscard]] const GliderMission& mission() const { return mission_; }
  [[nodiscard]] const GliderParameterInfo& operator[](size_t i) const { return rows_[i]; }

 private:
  std::vector<ir::ParameterInfo> infos_;
  std::vector<GliderParameterInfo> rows_;  ///< with the texts of `infos_`
  GliderMission mission_{};
};

}  // namespace glider::flights
