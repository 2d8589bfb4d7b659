// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/steep_pitch.h"

#include "ir/verify/intervals.h"

#include <algorithm>
#include <cmath>

namespace glider::compiler {
namespace {

/// Whether a command may dive or climb at more than `pitch` rad. Code in C may, and so may a
/// position of the pitch battery.
class SteepPitch {
 public:
  SteepPitch(const ir::Mission& mission, double pitch)
      : m_(mission), pitch_(pitch), intervals_(mission) {}

  [[nodiscard]] bool commanded() {
    const auto in_c = [](const ir::Behaviour& b) { return !b.symbol.empty(); };
    return std::ranges::any_of(m_.behaviours, in_c) ||
           std::ranges::any_of(m_.blocks, [&](const ir::Block& block) {
             return std::ranges::any_of(block.statements,
                                        [&](const ir::Statement& s) { return isSteep(s); });
           });
  }

 private:
  [[nodiscard]] bool isSteep(const ir::Statement& statement) {
    if (statement.kind != ir::StatementKind::Command) {
      return false;
    }
    const bool slopes =
        statement.command == ir::Command::Descend || statement.command == ir::Command::Ascend;
    return statement.command == ir::Command::Battery ||
           (slopes && mayExceed(statement.values.at(1)));
  }

  /// Most pitches are constants, of which no interval is needed.
  [[nodiscard]] bool mayExceed(ir::ExprId pitch) {
    const ir::Expr& e = m_[pitch];
    return e.op == ir::Op::Constant
               ? std::fabs(e.number) > pitch_
               : !intervals_.of(pitch, [](uint32_t, const ir::Interval& i) { return i; })
                      .within(-pitch_, pitch_);
  }

  const ir::Mission& m_;
  double pitch_;
  ir::SubtreeIntervals intervals_;
};

}  // namespace

void allowForSteepPitch(const ir::Mission& mission, platforms::Envelope& envelope) {
  if (envelope.steep_overshoot_m > envelope.inflection_overshoot_m &&
      SteepPitch(mission, envelope.overshoot_pitch_rad).commanded()) {
    envelope.inflection_overshoot_m = envelope.steep_overshoot_m;
  }
}

}  // namespace glider::compiler
