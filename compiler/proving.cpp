// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/proving.h"

#include "compiler/boards.h"
#include "compiler/share.h"
#include "ir/prove/chc.h"
#include "ir/text/print.h"
#include "support/diagnostics/ids/verification.h"
#include "support/files.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace glider::compiler {
namespace {

/// A command that the vehicle does not obey: what is said of its flights follows from that error.
bool refusesCommand(const support::Diagnostic& diagnostic) {
  return diagnostic.id == support::diagnostics::commandBeyondEnvelope ||
         diagnostic.id == support::diagnostics::profileTurnedRound;
}

bool isAboutFlights(const support::Diagnostic& diagnostic) {
  return diagnostic.id == support::diagnostics::requirementBroken ||
         diagnostic.id == support::diagnostics::requirementOpen;
}

}  // namespace

ir::prove::Findings prove(const Checked& checked, ir::prove::Options options,
                          support::DiagnosticEngine& diagnostics) {
  options.library = checked.lowered->standard_library;
  if (checked.mission().pack) {  // promises about its energy count the SBC
    options.board = usualBoardPower(checked.worlds.widest.platform).value_or(std::nullopt);
  }
  support::DiagnosticEngine found;
  ir::prove::Findings findings = ir::prove::prove(checked.worlds, checked.facts, options, found);
  const std::vector<support::Diagnostic> all = found.sorted();
  const bool refused = std::ranges::any_of(all, refusesCommand);
  for (const support::Diagnostic& diagnostic : all) {
    if (!refused || !isAboutFlights(diagnostic)) {
      diagnostics.add(diagnostic);
    }
  }
  return findings;
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
