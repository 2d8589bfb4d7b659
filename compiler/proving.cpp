// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/proving.h"

#include "ir/prove/chc.h"

namespace glider::compiler {

ir::prove::Findings prove(const Checked& checked, ir::prove::Options options,
                          support::DiagnosticEngine& diagnostics) {
  options.library = checked.lowered->standard_library;
  return ir::prove::prove(checked.mission(), checked.facts, checked.platform(), options,
                          diagnostics);
}

std::map<ir::CasePlace, bool> casesThatNeverFire(const Checked& checked) {
  ir::prove::Options options;
  options.library = checked.lowered->standard_library;
  return ir::prove::casesThatNeverFire(checked.mission(), checked.facts, checked.platform(),
                                       options);
}

std::string chcText(const Checked& checked) {
  const ir::Mission& mission = checked.mission();
  return ir::prove::chcText(mission, checked.platform(), [&](uint32_t number) {
    return checked.sources().text(mission.requirements[number].range);
  });
}

}  // namespace glider::compiler
