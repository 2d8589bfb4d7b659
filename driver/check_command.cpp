// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/compilation.h"
#include "driver/certificates/recheck.h"
#include "driver/certificates/write.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/fleet/check_fleet.h"
#include "driver/json_document.h"
#include "driver/output/check_on_terminal.h"
#include "driver/output/explain_page.h"
#include "driver/output/overwritten.h"
#include "driver/output/run_trace.h"
#include "driver/shared_options.h"
#include "driver/slocum/against_logs.h"
#include "driver/slocum/port_folder.h"
#include "driver/terminal.h"
#include "driver/usage/quantity.h"
#include "driver/usage/values.h"
#include "support/counted.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"
#include "vehicles/vehicle.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {
namespace {

enum class Format : uint8_t { Text, Json, Sarif };

/// The values of `--format`.
const std::map<std::string, Format> kCheckFormats = {
    {"text", Format::Text}, {"json", Format::Json}, {"sarif", Format::Sarif}};

struct CommandOptions {
  std::vector<std::string> missions;
  Format format = Format::Text;
  std::string output = "-";
  CheckOptions check;
  std::string traces;        ///< folder; empty: none
  std::string certificates;  ///< folder; empty: none
  std::string recheck;       ///< folder of certificates; empty: none
  std::string mi;            ///< the vehicle's mission file; empty: none
  AgainstOptions against;
  bool strict = false;                ///< warnings and undecided requirements are failures
  std::optional<double> timeout_s;    ///< of the proofs
  std::shared_ptr<FleetCheck> fleet;  ///< whose missions these are; null: of no fleet
};

/// "1 error, 2 warnings" of the diagnostics shown; empty if there are none of either.
std::string counted(const support::DiagnosticEngine& diagnostics) {
  const auto shown = diagnostics.sorted();
  const auto count = [&](support::Severity severity) {
    return std::ranges::count(shown, severity, &support::Diagnostic::severity);
  };
  const auto errors = count(support::Severity::Error);
  const auto warnings = count(support::Severity::Warning);
  auto part = [](ptrdiff_t n, const char* word) {
    return fmt::format("{} {}{}", n, word, n == 1 ? "" : "s");
  };
  std::string text = errors > 0 ? part(errors, "error") : "";
  if (warnings > 0) {
    text += (text.empty() ? "" : ", ") + part(warnings, "warning");
  }
  return text;
}

std::string stackLine(const report::CheckedMission& found) {
  if (found.deepest_path.empty()) {
    return "no calls";
  }
  return fmt::format("greatest call depth {} ({})", found.deepest_path.size() - 1,
                     fmt::join(found.deepest_path, " calls "));
}

/// ", 3 requirements proved with skeleton.mi, in water of 35 m or more"; empty if the mission
/// requires nothing.
std::string provedLine(const CheckedFile& checked) {
  const report::CheckedMission& found = checked.found;
  const size_t all = found.requirements.size();
  const auto proved = static_cast<size_t>(
      std::ranges::count(found.requirements, "proved", &report::JudgedRequirement::verdict));
  const std::string premise =
      proved == 0 || checked.vehicle_premise.empty() ? "" : " " + checked.vehicle_premise;
  return all == 0 ? ""
         : proved < all
             ? fmt::format(", {} of {} requirements proved{}", proved, all, premise)
             : fmt::format(", {} requirement{} proved{}", all, all == 1 ? "" : "s", premise);
}

/// The line at the end of a mission that was checked.
std::string verdict(const CheckedFile& checked) {
  const report::CheckedMission& found = checked.found;
  const std::string count = counted(checked.compilation->diagnostics);
  if (!found.ok()) {
    return fmt::format("{}: {}\n", found.path, count);
  }
  return fmt::format("{}: {}; mission {}, {} state{}, {}{}\n", found.path,
                     count.empty() ? "fine" : count, found.mission, found.states.size(),
                     found.states.size() == 1 ? "" : "s", stackLine(found), provedLine(checked));
}

/// Whether it has a warning, or a requirement that is not proved: with --strict these are failures
/// too.
bool leavesDoubt(const report::CheckedMission& found) {
  const auto warnings = std::ranges::count(found.diagnostics, support::Severity::Warning,
                                           &support::Diagnostic::severity);
  return warnings > 0 || std::ranges::any_of(found.requirements, [](const auto& requirement) {
           return requirement.verdict != "proved";
         });
}

int exitCode(const report::CheckedMission& found, bool strict) {
  return found.failure                                   ? kWorldFailed
         : !found.ok() || (strict && leavesDoubt(found)) ? kMissionHasErrors
                                                         : kFine;
}

/// The verdict of each requirement.
std::string requirementLines(const report::CheckedMission& found) {
  std::string text;
  for (const report::JudgedRequirement& one : found.requirements) {
    text += fmt::format("{}: {}\n", one.verdict, one.text);
    text += one.premise.empty() ? "" : fmt::format("  {}\n", one.premise);
    text += one.closed_loop ? fmt::format("  {}\n", report::searchInWords(*one.closed_loop)) : "";
  }
  return text;
}

/// Writes the output for people: errors to standard error, the rest to `text`.
void tellPeople(const CheckedFile& checked, const CheckOptions& options, std::string& text) {
  const report::CheckedMission& found = checked.found;
  if (checked.compilation) {
    reportDiagnostics(checked.compilation->diagnostics, *checked.compilation->sources);
  }
  if (found.failure) {
    reportFailure(*found.failure);
    return;
  }
  text += report::budgetTable(found);
  // What is known of a mission with a requirement that does not hold is true, and may say why.
  if (found.ok() || options.report) {
    for (const report::Remark& remark : found.remarks) {
      text += remark.text + "\n";
    }
  }
  if (options.report) {
    text += requirementLines(found);
  }
  if (!found.ok()) {
    tell(verdict(checked));
    return;
  }
  for (const report::AgainstLogs& against : found.against) {
    text +=
        fmt::format("{} against {}\n", found.path, report::againstText(against, *found.sources));
  }
  text += verdict(checked);
}

/// Writes `text` where the options say.
support::Result<void> put(const CommandOptions& options, const std::string& text) {
  return options.output == "-" ? printOut(text)
                               : support::writeFileAtomically(options.output, text);
}

/// Where the files of a mission are: in a folder of its own if there are several missions.
std::filesystem::path folderOf(const CommandOptions& options, const std::filesystem::path& folder,
                               const std::string& mission) {
  return options.missions.size() == 1 ? folder
                                      : folder / std::filesystem::path(mission).stem().string();
}

/// What follows for the fleet, once its missions were checked; `status` becomes that of the
/// command.
std::string tellFleet(const CommandOptions& options, int& status) {
  if (options.fleet == nullptr) {
    return "";
  }
  if (const auto settled = options.fleet->settle(); !settled) {
    status = std::max(status, reportFailure(settled.error()));
  }
  const auto pairs = options.fleet->pairs();
  if (options.strict && !std::ranges::all_of(pairs, &PairVerdict::proved)) {
    status = std::max<int>(status, kMissionHasErrors);
  }
  return options.fleet->text();
}

/// Whether two missions would have their files in one folder; then it prints an error.
bool sharesAFolder(const CommandOptions& options) {
  if (options.traces.empty() && options.certificates.empty() && options.recheck.empty()) {
    return false;
  }
  std::map<std::string, std::string> missions;
  for (const std::string& mission : options.missions) {
    const auto [other, first] =
        missions.try_emplace(std::filesystem::path(mission).stem().string(), mission);
    if (!first) {
      tell(
          fmt::format("glidercc: error: `{}` and `{}` would have their files in the same folder "
                      "`{}`; give one at a time\n",
                      other->second, mission, other->first));
      return true;
    }
  }
  return false;
}

/// Writes the traces if the options ask for them.
int writeTraces(const CommandOptions& options, const CheckedFile& checked) {
  if (options.traces.empty() || checked.found.requirements.empty()) {
    return kFine;
  }
  const auto folder = folderOf(options, options.traces, checked.found.path);
  const auto written = writeRuns(checked, folder);
  if (!written) {
    return reportFailure(written.error());
  }
  if (!written->empty()) {
    tell(fmt::format("{}: {} written to {}; `glidercc sim {} --replay {}` flies {}\n",
                     checked.found.path, support::counted(written->size(), "counterexample"),
                     folder.string(), checked.found.path, written->front().string(),
                     written->size() == 1 ? "it" : "the first"));
  }
  return kFine;
}

/// Writes the certificates if the options ask for them.
int writeProofs(const CommandOptions& options, const CheckedFile& checked) {
  if (options.certificates.empty() || checked.found.requirements.empty()) {
    return kFine;
  }
  const auto folder = folderOf(options, options.certificates, checked.found.path);
  const auto written = writeCertificates(checked, folder);
  if (!written) {
    return reportFailure(written.error());
  }
  tell(fmt::format("{}: {} certificate{} written to {}\n", checked.found.path, *written,
                   *written == 1 ? "" : "s", folder.string()));
  return kFine;
}

/// Writes what the options ask for in addition to the findings; returns the exit code.
int writeFiles(const CommandOptions& options, const VehicleLogs& logs, const CheckedFile& checked) {
  const auto drawn = drawAgainst(logs, options.against, checked);
  return std::max({writeTraces(options, checked), writeProofs(options, checked),
                   drawn ? kFine : reportFailure(drawn.error())});
}

int recheck(const CommandOptions& options) {
  int status = kFine;
  for (const std::string& mission : options.missions) {
    status = std::max(
        status,
        recheckCertificates(mission, folderOf(options, options.recheck, mission), options.mi));
  }
  return status;
}

int checkForPeople(const CommandOptions& options) {
  const VehicleLogs logs = readVehicleLogs(options.against);
  int status = logs.status;
  std::string all;
  for (const std::string& path : options.missions) {
    CheckedFile checked = checkOnTerminal(path, options.check);
    runAgainst(logs, options.against, checked);
    if (options.fleet != nullptr) {
      options.fleet->take(checked);
    }
    std::string text;
    tellPeople(checked, options.check, text);
    status = std::max(
        {status, exitCode(checked.found, options.strict), writeFiles(options, logs, checked)});
    // Immediately, so that it appears beside the errors of the same mission.
    if (options.output == "-") {
      if (const auto printed = printSuccess(text); !printed) {
        return reportFailure(printed.error());
      }
    }
    all += text;
  }
  const std::string fleet = tellFleet(options, status);
  if (options.output == "-") {
    if (const auto printed = printSuccess(fleet); !printed) {
      return reportFailure(printed.error());
    }
  } else {
    all += fleet;
    if (const auto written = put(options, all); !written) {
      return reportFailure(written.error());
    }
  }
  return status;
}

/// Empty for a page that cannot be read: the findings matter more.
std::string pageOrNothing(support::DiagnosticId id) {
  return explainPage(id).value_or("");
}

/// The document with what follows for the fleet.
std::string withFleet(const CommandOptions& options, const std::string& findings) {
  if (options.fleet == nullptr) {
    return findings;
  }
  Json document = Json::parse(findings);
  document["fleet"] = options.fleet->json();
  return document.dump(2) + "\n";
}

int checkForMachines(const CommandOptions& options) {
  const VehicleLogs logs = readVehicleLogs(options.against);
  int status = logs.status;
  std::vector<CheckedFile> all;
  std::vector<report::CheckedMission> found;
  for (const std::string& path : options.missions) {
    all.push_back(checkOnTerminal(path, options.check));
    runAgainst(logs, options.against, all.back());
    if (options.fleet != nullptr) {
      options.fleet->take(all.back());
    }
    found.push_back(all.back().found);
    status = std::max(
        {status, exitCode(found.back(), options.strict), writeFiles(options, logs, all.back())});
    if (found.back().failure) {
      reportFailure(*found.back().failure);
    }
  }
  tellFleet(options, status);
  const std::string text =
      options.format == Format::Json
          ? withFleet(options, report::findingsToJson(found, GLIDER_VERSION))
          : report::findingsToSarif(found, GLIDER_VERSION, pageOrNothing, status);
  const auto done = put(options, text);
  return done ? status : reportFailure(done.error());
}

/// If the only MISSION is a folder for a vehicle's port, what is in it is checked together.
support::Result<void> lookIntoFolder(CommandOptions& options) {
  const std::filesystem::path path = options.missions.front();
  const auto found = portFolderAt(path);
  if (!found) {
    return std::unexpected(found.error());
  }
  if (options.missions.size() != 1 || !*found) {
    return {};
  }
  const PortFolder& folder = **found;
  options.missions = {folder.mission.string()};
  if (options.mi.empty()) {
    options.mi = folder.vehicle_mission.string();
  }
  const auto compiled = compiler::compileMission(folder.mission);
  if (!compiled || !compiled->checked) {
    return {};  // the check says why
  }
  const auto end = portEndOf(path, compiler::optimise(compiled->checked));
  return end ? support::Result<void>() : std::unexpected(end.error());
}

/// If the only MISSION is a fleet file, its missions are checked.
support::Result<void> lookIntoFleet(CommandOptions& options) {
  if (options.missions.size() != 1 || !flights::isFleetFile(options.missions.front())) {
    return {};
  }
  auto fleet = flights::loadFleet(options.missions.front());
  if (!fleet) {
    return std::unexpected(fleet.error());
  }
  options.fleet = std::make_shared<FleetCheck>(std::move(*fleet));
  options.missions = options.fleet->missions();
  return {};
}

int check(CommandOptions& options) {
  if (const auto looked = lookIntoFleet(options); !looked) {
    return reportFailure(looked.error());
  }
  if (const auto looked = lookIntoFolder(options); !looked) {
    return reportFailure(looked.error());
  }
  if (sharesAFolder(options)) {
    return kWorldFailed;
  }
  if (!options.recheck.empty()) {
    return recheck(options);
  }
  options.check.evidence = !options.certificates.empty();
  options.check.timeout_s = options.timeout_s.value_or(0);
  if (!options.mi.empty()) {
    if (auto read = vehicles::tryOwnMission(options.mi, reportDiagnostics); !read) {
      return reportFailure(read.error());
    }
    options.check.own_mission = options.mi;
  }
  const bool draws = !options.against.picture.empty() || !options.against.page.empty();
  if (draws && options.missions.size() > 1) {
    tell("glidercc: error: `--picture` and `--page` draw one mission; name only one\n");
    return kWorldFailed;
  }
  std::vector<std::string> inputs = options.missions;
  inputs.insert(inputs.end(), options.against.logs.begin(), options.against.logs.end());
  if (const auto input = overwrittenInput(
          inputs, {options.output, options.against.picture, options.against.page})) {
    return reportFailure(support::fail(support::diagnostics::outputIsInput, *input).error());
  }
  return options.format == Format::Text ? checkForPeople(options) : checkForMachines(options);
}

void addAgainstOptions(CLI::App& command, AgainstOptions& options) {
  auto* against =
      command
          .add_option("--against", options.logs,
                      "Also evaluate the mission's guards on the readings in the vehicle's data "
                      "files, or folders of them: when each would have become true, with which "
                      "values, and what the mission would have done")
          ->option_text("LOG ...");
  command
      .add_option("--cache", options.caches,
                  "With --against: folder with the vehicle's sensor lists (.cac); may be repeated "
                  "[the folder of each file and its folders cac and cache]")
      ->option_text("FOLDER")
      ->allow_extra_args(false)
      ->needs(against);
  addLaunchOptions(command, options.launch);
  command.get_option("--set")->needs(against);
  command.get_option("--parameters")->needs(against);
  command
      .add_option("--page", options.page,
                  "With --against: write the web page of the logs, with marks where one mission "
                  "would have changed state and where its guards flicker")
      ->option_text("FILE")
      ->needs(against);
  auto* picture =
      command
          .add_option("--picture", options.picture,
                      "With --against: draw depth and guards over time as an SVG, for one mission")
          ->option_text("FILE")
          ->needs(against);
  addColourOption(command, options.picture_style, picture,
                  "Quantity that colours the track [one that the mission reads]");
}

void addVehicleOptions(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--mi,--skeleton", options.mi,
                  "The vehicle's mission file (.mi) with hookbeh: what its hookbeh refuses, what "
                  "its abend aborts, and a vehicle that may stay under water when control ends are "
                  "errors; with --report also in what time it comes to the surface [silence_secs "
                  "24 s, and no limits but the platform's]")
      ->option_text("FILE.mi");
  command
      .add_option("--scenario", options.check.scenario,
                  "The same for the mission file of a scenario, and for its start; the mission is "
                  "also flown there once: the name of a scenario that comes with glidercc, or a "
                  ".toml file")
      ->option_text("SCENARIO");
  addFlightDuration(command, options.check.duration_s)->needs("--scenario");
}

void addCertificateOptions(CLI::App& command, CommandOptions& options) {
  command
      .add_option("--certificates", options.certificates,
                  "Write a certificate for each requirement that is proved, for --recheck")
      ->option_text("FOLDER");
  command
      .add_option("--recheck", options.recheck,
                  "Only check the certificates in FOLDER: with the solver cvc5 and rules that are "
                  "independent of the prover")
      ->option_text("FOLDER")
      ->excludes("--format", "-o", "--report", "--traces", "--certificates");
}

}  // namespace

void addCheckCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<CommandOptions>();
  CLI::App* command = app.add_subcommand("check", "Check missions without building them");
  command
      ->add_option("MISSION", options->missions,
                   "Mission files (or the IR's text form, FILE.ir), a folder of `build --dialect "
                   "extctl`, or a fleet (FLEET.toml); `-` is standard input")
      ->required();
  command
      ->add_option_function<std::string>(
          "--format",
          [options](const std::string& format) { options->format = kCheckFormats.at(format); },
          "Output format: text, json, or sarif (SARIF 2.1.0, for editors and CI); json and sarif "
          "write one document with all findings [text]")
      ->check(oneOf({"text", "json", "sarif"}))
      ->option_text("FORMAT");
  command->add_option("-o", options->output, "Output file [`-`, standard output]")
      ->option_text("FILE");
  command->add_flag("--report", options->check.report,
                    "Also print remarks and upper bounds on board and link usage");
  command
      ->add_option("--target", options->check.targets,
                   "With --report: the boards to report on, as listed by `glidercc targets` [all "
                   "boards of the vehicle]")
      ->option_text("TARGET ...");
  addProofOptions(*command, options->check.effort, options->timeout_s);
  command->add_flag("--strict", options->strict,
                    "Exit with 1 also for warnings and for requirements that are not proved");
  addVehicleOptions(*command, *options);
  acceptNoCache(*command);
  addLinkOption(*command, options->check.user_code);
  command
      ->add_option(
          "--traces", options->traces,
          "Write a counterexample for each violated requirement, for `glidercc sim --replay`")
      ->option_text("FOLDER");
  addCertificateOptions(*command, *options);
  addAgainstOptions(*command, options->against);
  command->callback([options, &status] { status = check(*options); });
}

}  // namespace glider::driver
