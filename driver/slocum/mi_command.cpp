// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/vehicles_own.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/json_document.h"
#include "driver/output/line_diff.h"
#include "driver/output/rewrite.h"
#include "driver/terminal.h"
#include "frontend/spelling.h"
#include "vehicles/slocum/mission_files/behaviour_catalogue.h"
#include "vehicles/slocum/mission_files/edit.h"
#include "vehicles/slocum/mission_files/load.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace glider::driver {
namespace {

struct MiOptions {
  std::string file;
  std::vector<std::string> edits;
  bool diff = false;
  bool json = false;
};

/// Files by their number, with their new texts.
using NewTexts = std::map<uint32_t, std::string>;

std::string numberText(double value) {
  const auto parameter = slocum::missionParameter(value);
  return parameter ? fmt::format("u_mission_param_{}", static_cast<char>('a' + *parameter))
                   : fmt::format("{}", value);
}

std::string fileName(const support::SourceManager& sources, const slocum::Setting& setting) {
  return std::filesystem::path(sources.name(setting.value_range.file)).filename().string();
}

/// Values in columns as wide as the longest of each needs.
class Listing {
 public:
  Listing(const slocum::MissionFile& mission, const support::SourceManager& sources)
      : mission_(mission), sources_(sources) {
    for (const slocum::Setting& sensor : mission.sensors) {
      measure(sensor, kSensor.size());
    }
    for (const slocum::BehaviourBlock& block : mission.behaviours) {
      for (const slocum::Setting& argument : block.arguments) {
        measure(argument, kIndent.size());
      }
    }
  }

  /// The settings, then the behaviours, the highest priority first, with the values in force and
  /// the file that gives each.
  std::string write() {
    for (const slocum::Setting& sensor : mission_.sensors) {
      line(kSensor, sensor);
    }
    if (const size_t count = mission_.vehicle_sensors.size(); count > 0) {
      out_ += fmt::format("below these the {} setting{} of {}\n", count, count == 1 ? "" : "s",
                          fileName(sources_, mission_.vehicle_sensors.front()));
    }
    for (const slocum::BehaviourBlock& block : mission_.behaviours) {
      behaviour(block);
    }
    return std::move(out_);
  }

 private:
  static constexpr std::string_view kSensor = "sensor ", kIndent = "  ";

  void measure(const slocum::Setting& setting, size_t indent) {
    name_ = std::max(name_, indent + setting.name.size());
    value_ = std::max(value_, numberText(setting.value).size());
    unit_ = std::max(unit_, setting.unit.size());
  }

  void line(std::string_view indent, const slocum::Setting& setting) {
    out_ += fmt::format("{:{}}  {:>{}} {:{}}  {}\n", std::string(indent) + setting.name, name_,
                        numberText(setting.value), value_, setting.unit, unit_,
                        fileName(sources_, setting));
  }

  void behaviour(const slocum::BehaviourBlock& block) {
    out_ += fmt::format("{}{}\n", out_.empty() ? "" : "\n", block.name);
    for (const slocum::Setting& argument : block.arguments) {
      line(kIndent, argument);
    }
    for (const slocum::Waypoint& waypoint : block.waypoints) {
      out_ += fmt::format("  waypoint {:>12.4f} {:>11.4f}\n", waypoint.longitude_ddmm,
                          waypoint.latitude_ddmm);
    }
  }

  const slocum::MissionFile& mission_;
  const support::SourceManager& sources_;
  size_t name_ = 0, value_ = 0, unit_ = 0;  ///< widths of the columns
  std::string out_;
};

Json settingOf(const slocum::Setting& setting, const support::SourceManager& sources) {
  return {{"name", setting.name},
          {"value", slocum::missionParameter(setting.value) ? Json(numberText(setting.value))
                                                            : Json(setting.value)},
          {"unit", setting.unit},
          {"file", fileName(sources, setting)}};
}

/// The members of the document; a value that is a mission parameter is its name.
void put(Json& document, const slocum::MissionFile& mission,
         const support::SourceManager& sources) {
  document["sensors"] = Json::array();
  for (const slocum::Setting& sensor : mission.sensors) {
    document["sensors"].push_back(settingOf(sensor, sources));
  }
  document["behaviours"] = Json::array();
  for (const slocum::BehaviourBlock& block : mission.behaviours) {
    Json one = {{"name", block.name}, {"arguments", Json::array()}, {"waypoints", Json::array()}};
    for (const slocum::Setting& argument : block.arguments) {
      one["arguments"].push_back(settingOf(argument, sources));
    }
    for (const slocum::Waypoint& waypoint : block.waypoints) {
      one["waypoints"].push_back(
          {{"longitude_ddmm", waypoint.longitude_ddmm}, {"latitude_ddmm", waypoint.latitude_ddmm}});
    }
    document["behaviours"].push_back(std::move(one));
  }
}

/// "did you mean `yo.d_target_depth`?", or else to add a line.
std::string adviceFor(const slocum::MissionFile& mission, const slocum::Edit& edit) {
  std::vector<std::string> behaviours = {"sensor"};
  std::vector<std::string> settings;
  for (const slocum::BehaviourBlock& block : mission.behaviours) {
    behaviours.push_back(block.name);
    if (block.name == edit.behaviour) {
      for (const slocum::Setting& argument : block.arguments) {
        settings.push_back(argument.name);
      }
    }
  }
  if (edit.behaviour == "sensor") {
    for (const slocum::Setting& sensor : mission.sensors) {
      settings.push_back(sensor.name);
    }
  }
  const auto near = [](const std::string& word, const std::vector<std::string>& all) {
    return std::string(
        frontend::closest(word, std::vector<std::string_view>(all.begin(), all.end())));
  };
  const bool known = std::ranges::find(behaviours, edit.behaviour) != behaviours.end();
  const std::string behaviour = known ? edit.behaviour : near(edit.behaviour, behaviours);
  const std::string setting = known ? near(edit.setting, settings) : edit.setting;
  return behaviour.empty() || setting.empty()
             ? "; add a line for it first"
             : fmt::format("; did you mean `{}.{}`?", behaviour, setting);
}

/// Applies the edits from the last in a file to the first, so that places stay valid.
NewTexts edited(const slocum::MissionFile& mission, const std::vector<slocum::Edit>& edits,
                const support::SourceManager& sources) {
  std::vector<std::pair<support::SourceRange, std::string>> changes;
  for (const slocum::Edit& edit : edits) {
    const slocum::Setting* setting = slocum::findSetting(mission, edit);
    if (setting == nullptr) {
      throw CLI::ValidationError(
          "--set", fmt::format("no file gives `{}.{}` a value{}", edit.behaviour, edit.setting,
                               adviceFor(mission, edit)));
    }
    changes.emplace_back(setting->value_range, edit.value);
  }
  std::ranges::sort(changes, std::greater<>(),
                    [](const auto& change) { return change.first.begin; });
  NewTexts texts;
  for (const auto& [range, value] : changes) {
    std::string& text = texts.try_emplace(range.file, sources.text(range.file)).first->second;
    text = slocum::withValue(text, range, value);
  }
  return texts;
}

support::Result<void> put(const MiOptions& options, const support::SourceManager& sources,
                          const NewTexts& texts) {
  for (const auto& [file, text] : texts) {
    const std::string name(sources.name(file));
    auto done =
        options.diff ? printOut(lineDiff(name, sources.text(file), text)) : rewriteFile(name, text);
    if (!done) {
      return done;
    }
  }
  return {};
}

/// Reports b_args that their behaviours do not have. What a simulator lacks is of no concern here.
void checkNames(const slocum::MissionFile& mission, support::SourceRange /*place*/,
                support::DiagnosticEngine& diagnostics) {
  for (const slocum::BehaviourBlock& block : mission.behaviours) {
    slocum::checkArguments(block, diagnostics);
  }
}

int show(const MiOptions& options, Json* document) {
  std::vector<slocum::Edit> edits;
  for (const std::string& text : options.edits) {
    edits.push_back(*slocum::readEdit(text));
  }
  if (const auto kind = compiler::requireKind(options.file, compiler::MissionKind::Vehicles);
      !kind) {
    return reportFailure(kind.error());
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto mission = slocum::loadMission(options.file, sources, diagnostics, checkNames);
  reportDiagnostics(diagnostics, sources);
  if (!mission) {
    return diagnostics.hasErrors() ? kMissionHasErrors : reportFailure(mission.error());
  }
  if (document != nullptr) {
    put(*document, *mission, sources);
    return kFine;
  }
  const auto done = edits.empty() ? printOut(Listing(*mission, sources).write())
                                  : put(options, sources, edited(*mission, edits, sources));
  return done ? kFine : reportFailure(done.error());
}

}  // namespace

void addMiCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<MiOptions>();
  CLI::App* command = app.add_subcommand(
      "mi", "Read a mission of the vehicle's own (.mi) with its argument files, or change a value");
  command->add_option("FILE", options->file, "The mission file")->required();
  CLI::Option* set =
      command
          ->add_option("--set", options->edits,
                       "Change one number in the .mi or .ma file that gives it, and no other byte: "
                       "yo.d_target_depth=30, surface#2.when_secs=3600 (the second surface), "
                       "sensor.u_mission_param_a=1; may be repeated")
          ->option_text("BEHAVIOUR.ARGUMENT=NUMBER")
          ->check(CLI::Validator(
              [](const std::string& text) {
                return slocum::readEdit(text)
                           ? std::string()
                           : fmt::format("`{}` is not BEHAVIOUR.ARGUMENT=NUMBER", text);
              },
              "", "edit"));
  command->add_flag("--diff", options->diff, "Show what would change without writing files")
      ->needs(set);
  addFormatOption(*command, options->json);
  command->get_option("--format")->excludes(set);
  command->callback([options, &status] {
    status =
        inFormat(options->json, "mi", [&](Json* document) { return show(*options, document); });
  });
}

}  // namespace glider::driver
