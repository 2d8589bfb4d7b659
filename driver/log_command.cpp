// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/output/log_in_units.h"
#include "driver/output/log_json.h"
#include "driver/output/overwritten.h"
#include "driver/shared_options.h"
#include "driver/slocum/data_log.h"
#include "driver/terminal.h"
#include "logs/render.h"
#include "report/text.h"
#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/vehicle.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace glider::driver {
namespace {

using support::Result;

using LogOptions = DataLogOptions;

/// "3 incomplete or damaged and skipped, 2 missing (or more, by a multiple of 256)".
std::string damageText(const logs::LogDamage& damage) {
  std::string text;
  const auto add = [&](uint32_t count, const char* what) {
    if (count > 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, what);
    }
  };
  add(damage.bad, "incomplete or damaged and skipped");
  add(damage.missing, "missing (or more, by a multiple of 256)");
  add(damage.unreadable, "of another version or invalid");
  return text;
}

Result<void> write(const LogOptions& options, const std::string& text) {
  return options.csv.empty() || options.csv == "-"
             ? printOut(text)
             : support::writeFileAtomically(options.csv, text);
}

std::string entriesText(size_t count) {
  return count == 1 ? "1 entry" : fmt::format("{} entries", count);
}

/// What is shown of a mission's log: as text or CSV, and for a document.
class LogView {
 public:
  /// `mission`: null, then values have no units.
  LogView(const LogOptions& options, const compiler::Optimised* mission, bool for_document)
      : csv_(!options.csv.empty()), document_(for_document), mission_(mission) {
    if (mission != nullptr) {
      units_.emplace(*mission);
      write_ = [this](const logs::LogEntry& entry) { return units_->values(entry); };
    }
    text = csv_ ? logs::csvHead(units_.has_value()) : "";
  }
  LogView(const LogView&) = delete;
  LogView& operator=(const LogView&) = delete;

  void take(const logs::LogEntry& entry) {
    if (mission_ != nullptr && entry.kind == runtime::LogRecord::Start &&
        entry.name != mission_->mission.name) {
      other_mission = entry.name;
    }
    if (!csv_ && !document_) {
      text += logs::textLine(entry, write_);
      return;
    }
    const logs::LogEntry told = units_ ? units_->converted(entry) : entry;
    if (document_) {
      entries.push_back(entryOf(told));
    }
    if (csv_) {
      text += logs::csvLines(told, units_.has_value());
    }
  }
  /// Entries that another version of the mission must have written.
  [[nodiscard]] size_t strangers() const { return units_ ? units_->strangers() : 0; }

  std::string text;
  Json entries = Json::array();
  std::string other_mission;  ///< the log is of this one; empty: it is of the one given

 private:
  bool csv_, document_;
  const compiler::Optimised* mission_;
  std::optional<LogInUnits> units_;
  logs::WriteValues write_ = logs::valuesAsLogged;
};

Result<void> noLog(const std::string& file, bool empty) {
  std::error_code ignored;
  std::string why = empty ? "it is empty" : "it contains no complete header of a log";
  if (const std::string older = file + ".old"; std::filesystem::exists(older, ignored)) {
    why += "; earlier records are in `" + older + "`";
  }
  return support::fail(support::diagnostics::noLog, file, why);
}

void tellNotes(const std::string& file, const LogOptions& options, const LogView& view,
               const logs::LogDamage& damage) {
  if (const size_t strangers = view.strangers(); strangers > 0) {
    tell(
        fmt::format("glidercc: note: {}: {} with names or texts that {} does not have: another "
                    "version of the mission wrote it\n",
                    file, entriesText(strangers), options.mission));
  }
  if (const std::string harm = damageText(damage); !harm.empty()) {
    tell(fmt::format("glidercc: note: {}: records: {}\n", file, harm));
  }
}

/// Shows the log of a mission.
int showMissionLog(const std::string& file, const LogOptions& options, Json* document) {
  int status = kFine;
  std::shared_ptr<const compiler::Optimised> mission;
  if (!options.mission.empty() &&
      (mission = compileForFlight(options.mission, status)) == nullptr) {
    return status;
  }
  const auto bytes = support::readFile(file);
  if (!bytes) {
    return reportFailure(bytes.error());
  }
  LogView view(options, mission.get(), document != nullptr);
  const logs::LogDamage damage =
      logs::readLog(*bytes, [&](const logs::LogEntry& entry) { view.take(entry); });
  if (damage.starts == 0) {
    return reportFailure(noLog(file, bytes->empty()).error());
  }
  if (!view.other_mission.empty()) {
    return reportFailure(support::fail(support::diagnostics::otherMissionsLog, file,
                                       report::plain(view.other_mission), mission->mission.name)
                             .error());
  }
  if (document != nullptr) {
    (*document)["entries"] = std::move(view.entries);
    (*document)["damage"] = damageOf(damage);
  }
  const bool to_file = !options.csv.empty() && options.csv != "-";
  if (document == nullptr || to_file) {
    if (const auto written = write(options, view.text); !written) {
      return reportFailure(written.error());
    }
  }
  tellNotes(file, options, view, damage);
  return kFine;
}

/// True if there is an option that only data files have.
bool isForDataFiles(const LogOptions& options) {
  return !options.sensors.empty() || !options.netcdf.empty() || !options.caches.empty() ||
         !options.report.empty() || !options.picture.empty();
}

int log(const LogOptions& options, Json* document) {
  std::vector<std::string> inputs = options.files;
  inputs.push_back(options.beside);
  if (const auto input = overwrittenInput(
          inputs, {options.csv, options.netcdf, options.report, options.picture})) {
    return reportFailure(support::fail(support::diagnostics::outputIsInput, *input).error());
  }
  if (areDataFiles(options.files)) {
    if (!options.mission.empty()) {
      return reportFailure(support::fail(support::diagnostics::noLog, options.files[0],
                                         "--mission can be used only with the log of a mission")
                               .error());
    }
    return showDataFiles(options, document);
  }
  const std::string& file = options.files[0];
  if (isForDataFiles(options)) {
    return reportFailure(support::fail(support::diagnostics::notDataFile, file,
                                       "only `--csv`, `--mission` and `--format` can be used with "
                                       "the log of a mission; all other options are for data "
                                       "files")
                             .error());
  }
  return showMissionLog(file, options, document);
}

constexpr const char* kLogFooter =
    "The log of a mission on the SBC is given alone; its values have units only with "
    "--mission.\nAny number of the vehicle's data files (.dbd "
    ".mbd .sbd\n"
    ".ebd .nbd .tbd, compressed .dcd .mcd .scd .ecd .ncd .tcd) and folders of them are shown "
    "together:\n"
    "each file, and for each sensor its updates, minimum, maximum and last value.\n"
    "The first record of a data file holds the values from before the file was opened and is not "
    "shown.\n"
    "The CSV of data files has one row per record of either computer, by time; a field is empty "
    "where the\n"
    "record does not update the sensor. If both computers have a sensor, the copy that does not "
    "come from\n"
    "its owner is named gld_dup_NAME (flight's copy) or sci_dup_NAME (science's copy).\n"
    "--report and --picture draw the flight in UTC. --beside adds the simulated flight of the same "
    "mission,\n"
    "aligned so that both flights leave the surface at the same time.\n"
    "Exit codes: 0 success, 1 a data file is damaged (what can be read is shown), 2 usage error, "
    "or a file\n"
    "failed or is missing.";

void addDrawingOptions(CLI::App& command, LogOptions& options) {
  auto* report = command.add_option("--report", options.report,
                                    "Draw the flight in data files as a web page, like the "
                                    "report of `sim`");
  report->option_text("PAGE.html");
  auto* picture = addPictureOptions(command, options.picture, options.picture_style);
  command
      .add_option("--beside", options.beside,
                  "Also draw this simulated flight in the report and the picture: the trace.csv "
                  "that `glidercc sim -o FOLDER` writes")
      ->option_text("FLIGHT.csv")
      ->check([report, picture](const std::string&) {
        return report->count() + picture->count() > 0 ? std::string()
                                                      : std::string("needs --report or --picture");
      });
}

}  // namespace

void addLogCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<LogOptions>();
  CLI::App* command = app.add_subcommand(
      "log", "Show the log written by a mission on the SBC, or the vehicle's data files");
  command
      ->add_option("FILES", options->files,
                   "Log file written by the mission's program with --log, or data files of the "
                   "vehicle, or folders of them")
      ->required();
  command
      ->add_option("--mission", options->mission,
                   "The mission that wrote the log: show its values with their units")
      ->option_text("MISSION");
  command
      ->add_option("--csv", options->csv,
                   "Write comma-separated values instead: of a mission's log one row per value, "
                   "of data files one row per record; `-` is standard output")
      ->option_text("OUT");
  command
      ->add_option("--netcdf", options->netcdf,
                   "Write the records of data files to a netCDF-4 file")
      ->option_text("OUT");
  command
      ->add_option(
          "--sensors", options->sensors,
          "Show or write only these sensors of data files, separated by commas; `*` stands "
          "for any characters")
      ->option_text("NAMES")
      ->delimiter(',')
      ->allow_extra_args(false);
  command
      ->add_option("--cache", options->caches,
                   "Folder with the vehicle's sensor lists (.cac); may be repeated [the folder of "
                   "each file and its folders cac and cache]")
      ->option_text("FOLDER")
      ->allow_extra_args(false);
  addDrawingOptions(*command, *options);
  command->footer(kLogFooter);
  auto json = std::make_shared<bool>(false);
  addFormatOption(*command, *json);
  command->callback([options, json, &status] {
    if (*json && options->csv == "-") {
      throw CLI::ValidationError("--format",
                                 "json goes to standard output: name a file with --csv");
    }
    status = inFormat(*json, "log", [&](Json* document) { return log(*options, document); });
  });
}

}  // namespace glider::driver
