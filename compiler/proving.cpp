// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/proving.h"

#include "compiler/share.h"
#include "ir/prove/chc.h"
#include "ir/text/print.h"
#include "support/files.h"
#include "support/one_line.h"

#include <fmt/format.h>

namespace glider::compiler {

ir::prove::Findings prove(const Checked& checked, ir::prove::Options options,
                          support::DiagnosticEngine& diagnostics) {
  options.library = checked.lowered->standard_library;
  return ir::prove::prove(checked.worlds, checked.facts, options, diagnostics);
}

std::map<ir::CasePlace, bool> casesThatNeverFire(const Checked& checked) {
  ir::prove::Options options;
  options.library = checked.lowered->standard_library;
  return ir::prove::casesThatNeverFire(checked.worlds, checked.facts, options);
}

support::Result<std::string> proofSubject(const Checked& checked) {
  const auto vehicle =
      support::readFile(shareDirectory() / "platforms" / (checked.mission().platform + ".toml"));
  if (!vehicle) {
    return std::unexpected(vehicle.error());
  }
  return fmt::format("{}\n{}\n{}", vehicle->size(), *vehicle, ir::print(checked.mission()));
}

std::string chcText(const Checked& checked) {
  const ir::Mission& mission = checked.mission();
  return ir::prove::chcText(checked.worlds.assumed, [&](uint32_t number) {
    return support::onOneLine(checked.sources().text(mission.requirements[number].range));
  });
}

}  // namespace glider::compiler
