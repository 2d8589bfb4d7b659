// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/imc_mission.h"

#include "codegen/llvm/program/seat_constant.h"

namespace glider::codegen {

void addImcMission(llvm::Module& module, const GliderImcMission& imc) {
  static_assert(sizeof(GliderImcMission) == 7 * sizeof(double) + 2 * sizeof(uint32_t) +
                                                2 * GLIDER_MOST_IMC_READINGS * sizeof(uint16_t));
  addSeatConstant(module, "gliderImc",
                  {imc.greatest_depth_m, imc.slowest_m_s, imc.fastest_m_s, imc.usual_m_s,
                   imc.timeout_s, imc.loiter_m, imc.start_depth_m},
                  {imc.vehicle, imc.count}, imc.sensors, imc.sources);
}

}  // namespace glider::codegen
