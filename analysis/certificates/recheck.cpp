// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/certificates/recheck.h"

#include "analysis/certificates/possible_run.h"
#include "analysis/replay.h"
#include "flights/launch_choice.h"
#include "flights/sbc_choice.h"
#include "ir/certify/obligations.h"
#include "support/diagnostics/ids/command.h"
#include "support/program.h"

#include <fmt/format.h>

#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace glider::analysis {
namespace {

using support::Result;

/// The resource limit of one question, in cvc5's own count, so that the answer does not depend on
/// the machine.
constexpr const char* kLimit = "--rlimit-per=5000000";

/// What cvc5 answers to each question of a script.
Result<std::vector<std::string>> answersTo(const std::string& script) {
  const auto output =
      support::runProgram({kSolver, "--lang=smt2", "--incremental", "--quiet", kLimit}, script);
  if (!output) {
    return std::unexpected(output.error());
  }
  std::istringstream in(output->text);
  std::vector<std::string> answers;
  for (std::string line; std::getline(in, line);) {
    if (line != "sat" && line != "unsat" && line != "unknown") {
      return support::fail(support::diagnostics::solverFailed, kSolver, line);
    }
    answers.push_back(line);
  }
  if (output->exit_code != 0) {
    return support::fail(support::diagnostics::solverFailed, kSolver,
                         fmt::format("exit code {}", output->exit_code));
  }
  return answers;
}

Rechecked refused(std::string reason) {
  return {false, 0, std::move(reason), {}};
}

/// Empty if every obligation of the script is met.
Result<std::string> check(const ir::certify::Script& script) {
  const auto answers = answersTo(script.text);
  if (!answers) {
    return std::unexpected(answers.error());
  }
  if (answers->size() != script.obligations.size()) {
    return support::fail(
        support::diagnostics::solverFailed, kSolver,
        fmt::format("{} answers to {} questions", answers->size(), script.obligations.size()));
  }
  for (size_t i = 0; i < answers->size(); ++i) {
    if ((*answers)[i] != "unsat") {
      return fmt::format("{}: {}", (*answers)[i] == "sat" ? "not so" : "not decided by cvc5",
                         script.obligations[i]);
    }
  }
  return std::string();
}

Result<Rechecked> recheckInvariants(const compiler::Certificate& certificate,
                                    const compiler::Checked& checked, uint32_t requirement) {
  Rechecked result;
  for (const ir::certify::Script& script : ir::certify::obligationsUnder(
           checked.worlds.widest, requirement, certificate.assumptions, certificate.invariants)) {
    const auto wrong = check(script);
    if (!wrong) {
      return std::unexpected(wrong.error());
    }
    if (!wrong->empty()) {
      result.reason = *wrong;
      return result;
    }
    result.obligations += script.obligations.size();
  }
  result.accepted = true;
  result.assumptions = certificate.assumptions;
  return result;
}

/// A run is a flight under any assumptions, unless it begins deeper than vehicles usually do.
std::vector<uint32_t> assumedOf(const support::Trace& run, const compiler::Checked& checked) {
  std::vector<uint32_t> numbers;
  const auto& assumptions = checked.mission().assumptions;
  const bool deep = run.at(0, run.column("true_depth")) > checked.platform().world.start_depth_m;
  for (uint32_t i = 0; i < assumptions.size(); ++i) {
    if (deep && assumptions[i].kind == ir::AssumptionKind::StartDepth) {
      numbers.push_back(i);
    }
  }
  return numbers;
}

Result<Rechecked> recheckRun(const support::Trace& run, const compiler::Optimised& mission,
                             uint32_t requirement) {
  if (auto fits = checkTrace(run, "the certificate's run", *mission.checked); !fits) {
    return refused(fits.error().message);
  }
  if (run.requirement != requirement) {
    return refused("its run is for another requirement");
  }
  auto loaded = flights::loadHere(mission, {});
  if (!loaded) {
    return std::unexpected(loaded.error());
  }
  flights::LaunchChoice launch;
  launch.settings = run.settings;
  const auto parameters = flights::chooseParameters(mission.mission, launch);
  if (!parameters) {
    return std::unexpected(parameters.error());
  }
  if (std::string why = whyImpossible(run, *mission.checked, *parameters); !why.empty()) {
    return refused(fmt::format("no vehicle flies its run: {}", why));
  }
  const auto start = flights::startInProcess(
      std::make_shared<const codegen::LoadedMission>(std::move(*loaded)), *parameters, false);
  const auto sbc = start();
  if (!sbc) {
    return std::unexpected(sbc.error());
  }
  const auto replayed =
      replayRun(run, *mission.checked, compiler::stateNames(mission.mission), *parameters, **sbc);
  if (!replayed) {
    return refused(replayed.error().message);
  }
  if (!replayed->broken) {
    return refused("its run does not do what is required");
  }
  return Rechecked{true, replayed->ticks, {}, assumedOf(run, *mission.checked)};
}

}  // namespace

Result<Rechecked> recheck(const compiler::Certificate& certificate,
                          const compiler::Optimised& mission, uint32_t requirement) {
  const ir::Requirement& required = mission.checked->mission().requirements[requirement];
  const auto subject = compiler::subjectOf(*mission.checked);
  if (!subject) {
    return std::unexpected(subject.error());
  }
  if (certificate.subject != *subject) {
    return refused("it is about another mission or another vehicle");
  }
  const bool reach = required.kind == ir::RequirementKind::Reach;
  if (reach != certificate.run.has_value()) {
    return refused("its method does not fit the requirement");
  }
  if (certificate.run) {
    return recheckRun(*certificate.run, mission, requirement);
  }
  if (certificate.method == ir::prove::Method::Energy) {
    return refused("proofs by the vehicle's power table are not checked a second time");
  }
  if (!required.geofences.empty()) {
    return refused("proofs by geometry are not checked a second time");
  }
  return recheckInvariants(certificate, *mission.checked, requirement);
}

}  // namespace glider::analysis
