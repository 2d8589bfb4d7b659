// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/recon_mission.h"

#include "codegen/llvm/program/seat_constant.h"

namespace glider::codegen {

void addReconMission(llvm::Module& module, const GliderReconMission& recon) {
  static_assert(sizeof(GliderReconMission) ==
                4 * sizeof(double) + 2 * sizeof(uint32_t) +
                    2 * GLIDER_MOST_RECON_READINGS * sizeof(uint16_t));
  addSeatConstant(module, "gliderRecon",
                  {recon.greatest_depth_m, recon.slowest_m_s, recon.fastest_m_s, recon.usual_m_s},
                  {recon.count, recon.unused}, recon.sensors, recon.sources);
}

}  // namespace glider::codegen
