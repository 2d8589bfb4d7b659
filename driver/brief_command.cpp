// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/brief_of.h"
#include "analysis/check/check.h"
#include "analysis/mission_budget.h"
#include "analysis/parameter_rows.h"
#include "compiler/boards.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/output/check_on_terminal.h"
#include "driver/output/executable.h"
#include "driver/output/overwritten.h"
#include "driver/output/print_pdf.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/verification.h"
#include "support/files.h"
#include "vehicles/vehicle.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

namespace glider::driver {
namespace {

struct BriefOptions {
  bool json = false;
  std::string mission;
  std::string output;  ///< empty: named after the mission
  std::string target = kUsualTarget;
  std::string mi;  ///< the vehicle's mission file; empty: none
  flights::LaunchChoice launch;
  CheckOptions check;
};

/// A violated requirement is an error, but the crew should see it on the page.
bool hasOtherErrors(const report::CheckedMission& found) {
  return std::ranges::any_of(found.diagnostics, [](const support::Diagnostic& one) {
    return one.severity == support::Severity::Error &&
           one.id != support::diagnostics::requirementBroken;
  });
}

support::Result<report::Brief> gather(const BriefOptions& options, const CheckedFile& file) {
  const compiler::Optimised mission = compiler::optimise(file.compilation->checked);
  auto parameters = analysis::parameterRows(mission, options.launch);
  if (!parameters) {
    return std::unexpected(parameters.error());
  }
  auto binary = executableHash(options.mission, mission, options.target, options.check.user_code);
  if (!binary) {
    return std::unexpected(binary.error());
  }
  return analysis::briefOf({*file.compilation, file.proved, file.found, file.own_mission.get(),
                            std::move(*parameters), std::move(*binary),
                            std::string("glidercc ") + GLIDER_VERSION});
}

/// What the crew's page is about and where it is, and what is decided about the mission.
void put(Json& document, const BriefOptions& options, const report::Brief& brief) {
  document["mission"] = brief.mission;
  document["platform"] = brief.platform;
  document["page"] = options.output;
  document["summary"] = brief.summary;
  document["states"] = Json::array();
  for (const report::BriefState& state : brief.states) {
    document["states"].push_back({{"name", state.name}, {"deepest", state.deepest}});
  }
  document["requirements"] = Json::array();
  for (const report::BriefRequirement& one : brief.requirements) {
    document["requirements"].push_back(
        {{"text", one.text}, {"verdict", one.verdict}, {"because", one.because}});
  }
  document["hashes"] = Json::array();
  for (const report::BriefHash& hash : brief.hashes) {
    document["hashes"].push_back({{"of", hash.of}, {"sha256", hash.sha256}});
  }
}

support::Result<void> write(const BriefOptions& options, const report::Brief& brief,
                            Json* document) {
  const std::string html = report::briefToHtml(brief);
  if (options.output == "-") {
    return printOut(html);
  }
  const bool as_pdf = std::filesystem::path(options.output).extension() == ".pdf";
  if (auto written = as_pdf ? printPdf(html, options.output)
                            : support::writeFileAtomically(options.output, html);
      !written) {
    return written;
  }
  if (document != nullptr) {
    put(*document, options, brief);
    return {};
  }
  return printSuccess(fmt::format("{}: mission {}, {} state{}\n", options.output, brief.mission,
                                  brief.states.size(), brief.states.size() == 1 ? "" : "s"));
}

/// The vehicle's mission file says how soon hookbeh takes over, and what it refuses.
support::Result<void> readSkeleton(BriefOptions& options) {
  if (options.mi.empty()) {
    return {};
  }
  options.check.own_mission = options.mi;
  return vehicles::tryOwnMission(options.mi, reportDiagnostics);
}

int brief(BriefOptions options, Json* document) {
  if (const auto board = compiler::loadTarget(options.target); !board) {
    return reportFailure(board.error());
  }
  if (auto read = readSkeleton(options); !read) {
    return reportFailure(read.error());
  }
  if (options.output.empty()) {
    options.output = builtName(options.mission, "brief", ".html");
  }
  if (const auto input =
          overwrittenInput({options.mission, options.mi, options.launch.file}, {options.output})) {
    return reportFailure(support::fail(support::diagnostics::outputIsInput, *input).error());
  }
  options.check.report = true;
  options.check.targets = options.target == kUsualTarget ? analysis::boardsInTheVehicle()
                                                         : std::vector<std::string>{options.target};
  const CheckedFile file = checkOnTerminal(options.mission, options.check);
  if (file.compilation) {
    reportDiagnostics(file.compilation->diagnostics, *file.compilation->sources);
  }
  if (file.found.failure) {
    return reportFailure(*file.found.failure);
  }
  if (hasOtherErrors(file.found)) {
    return kMissionHasErrors;
  }
  const auto brief = gather(options, file);
  if (!brief) {
    return reportFailure(brief.error());
  }
  if (const auto written = write(options, *brief, document); !written) {
    return reportFailure(written.error());
  }
  return file.found.ok() ? kFine : kMissionHasErrors;
}

}  // namespace

void addBriefCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<BriefOptions>();
  CLI::App* command = app.add_subcommand(
      "brief", "Write a page about a mission for the crew, to print before it is deployed");
  command
      ->add_option("MISSION", options->mission, "The mission file (or the IR's text form, FILE.ir)")
      ->required();
  command
      ->add_option("-o", options->output,
                   "Output file, a web page; printed as a PDF by Chromium if the name ends in "
                   ".pdf; `-` is standard output [MISSION-brief.html]")
      ->option_text("FILE");
  command
      ->add_option("--target", options->target,
                   "Target of the executable whose digest is given, as listed by `glidercc "
                   "targets`")
      ->type_name("TARGET")
      ->capture_default_str();
  command
      ->add_option("--mi,--skeleton", options->mi,
                   "The vehicle's mission file (.mi) with hookbeh; its silence_secs bounds the "
                   "time to the surface [24 s]")
      ->option_text("FILE.mi");
  addLaunchOptions(*command, options->launch);
  addLinkOption(*command, options->check.user_code);
  addFormatOption(*command, options->json);
  command->callback([options, &status] {
    if (options->json && options->output == "-") {
      throw CLI::ValidationError("--format", "json goes to standard output: name a file with -o");
    }
    status =
        inFormat(options->json, "brief", [&](Json* document) { return brief(*options, document); });
  });
}

}  // namespace glider::driver
