// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/plan/plan_mission.h"
#include "compiler/compilation.h"
#include "compiler/vehicles_own.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/output/check_on_terminal.h"
#include "driver/output/overwritten.h"
#include "driver/output/rewrite.h"
#include "driver/plan/plan_json.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"
#include "vehicles/vehicle.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace glider::driver {
namespace {

struct PlanCommandOptions {
  bool json = false;
  bool write = false;
  std::string mission;
  std::string picture;  ///< empty: none
  std::optional<double> timeout_s;
  analysis::CheckOptions check;
};

/// Writes what was chosen into the mission, unless it is another text by now.
support::Result<void> rewrite(const PlanCommandOptions& options, std::string_view before,
                              const std::string& text) {
  const auto now = support::readFile(options.mission);
  if (!now) {
    return std::unexpected(now.error());
  }
  return *now == before ? rewriteFile(options.mission, text)
                        : support::fail(support::diagnostics::changedMeanwhile, options.mission);
}

/// What is asked for beside the text: the mission rewritten, the picture.
support::Result<void> writeFiles(const PlanCommandOptions& options, std::string_view before,
                                 const analysis::PlannedMission& planned) {
  if (options.write) {
    if (auto written = rewrite(options, before, planned.text); !written) {
      return written;
    }
  }
  if (options.picture.empty()) {
    return {};
  }
  return planned.plan.objectives.size() < 2
             ? support::fail(support::diagnostics::frontOfOne, options.picture)
             : support::writeFileAtomically(options.picture, planPicture(planned.plan));
}

int plan(PlanCommandOptions& options, Json* document) {
  options.check.timeout_s = options.timeout_s.value_or(0);
  if (options.write && options.mission == compiler::kStandardInput) {
    tell("glidercc: error: `--write` needs a file: standard input cannot be written\n");
    return kWorldFailed;
  }
  if (const auto input = overwrittenInput({options.mission}, {options.picture})) {
    return reportFailure(support::fail(support::diagnostics::outputIsInput, *input).error());
  }
  if (auto kind = compiler::requireKind(options.mission, compiler::MissionKind::Language); !kind) {
    return reportFailure(kind.error());
  }
  if (!options.check.own_mission.empty()) {
    if (auto read = vehicles::tryOwnMission(options.check.own_mission, reportDiagnostics); !read) {
      return reportFailure(read.error());
    }
  }
  const auto compiled = compiler::compileMission(options.mission);
  if (!compiled) {
    return reportFailure(compiled.error());
  }
  if (!analysis::isPlannable(*compiled)) {
    reportDiagnostics(compiled->diagnostics, *compiled->sources);
    return kMissionHasErrors;
  }
  ShownOnTerminal observer(options.mission, options.check);
  const auto found = analysis::planMission(options.mission, *compiled, options.check, observer);
  if (!found) {
    return reportFailure(found.error());
  }
  if (found->plan.possible == 0) {
    const auto lowest = compiler::withChosen(*compiled, {});
    reportDiagnostics(lowest.diagnostics, *lowest.sources);
  }
  if (document != nullptr) {
    putPlan(*document, found->plan);
  } else if (const auto printed = printOut(planText(found->plan)); !printed) {
    return reportFailure(printed.error());
  }
  if (!found->plan.chosen) {
    tell(
        fmt::format("{}: no way to choose keeps all that is required; with its values written, "
                    "`glidercc check` says why one does not\n",
                    options.mission));
    return kMissionHasErrors;
  }
  if (const auto written = writeFiles(options, compiled->sources->text(0), *found); !written) {
    return reportFailure(written.error());
  }
  tell(options.write ? fmt::format("{}: what was chosen is written into it\n", options.mission)
                     : "");
  return kFine;
}

}  // namespace

void addPlanCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<PlanCommandOptions>();
  CLI::App* command = app.add_subcommand(
      "plan", "Choose what a mission leaves open: the values of its lines `choose`");
  command->add_option("MISSION", options->mission, "The mission file")->required();
  command->add_flag("--write", options->write,
                    "Write what is chosen into the mission file, where other commands read it");
  command
      ->add_option("--picture", options->picture,
                   "Draw the best ways to choose as an SVG: the first of what is preferred to the "
                   "right, the second upwards")
      ->option_text("FILE");
  command
      ->add_option("--mi,--skeleton", options->check.own_mission,
                   "The vehicle's mission file (.mi) with hookbeh, as for `check`")
      ->option_text("FILE.mi");
  command
      ->add_option("--scenario", options->check.scenario,
                   "The same for the mission file of a scenario, and for its start: the name of a "
                   "scenario that comes with glidercc, or a .toml file")
      ->option_text("SCENARIO");
  addProofOptions(*command, options->check.effort, options->timeout_s);
  addFormatOption(*command, options->json);
  command->callback([options, &status] {
    status =
        inFormat(options->json, "plan", [&](Json* document) { return plan(*options, document); });
  });
}

}  // namespace glider::driver
