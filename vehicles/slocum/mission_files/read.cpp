// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/mission_files/read.h"

#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/slocum/mission_files/line_reader.h"

#include <algorithm>
#include <cmath>

namespace glider::slocum {

using support::DiagnosticEngine;

namespace {

/// The part of `line` before the first ':' in lower case, or empty.
std::string keyword(Piece line) {
  const size_t colon = line.text.find(':');
  if (colon == std::string_view::npos) {
    return {};
  }
  std::string word = lowerCase(line.text.substr(0, colon));
  while (!word.empty() && (word.back() == ' ' || word.back() == '\t')) {
    word.pop_back();
  }
  return word;
}

Piece afterColon(const LineReader& reader, Piece line) {
  return reader.trimmed(line.range.begin + line.text.find(':') + 1, line.range.end);
}

bool isSetup(const std::vector<Piece>& words) {
  const std::string first = lowerCase(words.front().text);
  return words.size() >= 2 && (first == "name" || first == "installed" || first == "use");
}

SetupLine setupLine(const std::vector<Piece>& words, support::SourceRange range) {
  SetupLine line{{}, range};
  for (const Piece& word : words) {
    line.words.push_back(lowerCase(word.text));
  }
  return line;
}

/// Appends, or replaces what the list has already: on the vehicle the last one counts (GL5105).
void append(std::vector<Setting>& list, std::optional<Setting> setting,
            DiagnosticEngine& diagnostics) {
  if (!setting) {
    return;
  }
  const auto earlier = std::ranges::find(list, setting->name, &Setting::name);
  if (earlier != list.end()) {
    diagnostics.report(support::diagnostics::duplicateArgument, setting->name_range, setting->name)
        .note(earlier->name_range, "the first is here");
    *earlier = std::move(*setting);
    return;
  }
  list.push_back(std::move(*setting));
}

/// Reads a .mi line by line.
class MissionReader {
 public:
  MissionReader(LineReader& lines, DiagnosticEngine& diagnostics)
      : lines_(lines), diagnostics_(diagnostics) {}

  void line(Piece line) {
    const std::string word = keyword(line);
    if (word == "sensor") {
      append(mission.sensors, lines_.setting(afterColon(lines_, line)), diagnostics_);
    } else if (word == "behavior") {
      behaviour(afterColon(lines_, line));
    } else if (word == "b_arg") {
      argument(afterColon(lines_, line));
    } else if (const auto words = lines_.words(line); isSetup(words)) {
      mission.setup.push_back(setupLine(words, line.range));
    } else {
      diagnostics_.report(support::diagnostics::missionFileSyntax, line.range,
                          "`sensor:`, `behavior:` or `b_arg:`", quoted(line.text));
    }
  }

  MissionFile mission;

 private:
  void behaviour(Piece rest) {
    const auto words = lines_.words(rest);
    if (words.size() != 1) {
      const Piece found = words.empty() ? rest : words[1];
      diagnostics_.report(support::diagnostics::missionFileSyntax, found.range,
                          "one name after `behavior:`", quoted(found.text));
      // Its arguments must not be assigned to the previous behaviour.
      if (words.empty()) {
        mission.behaviours.push_back({"", rest.range, {}});
        return;
      }
    }
    mission.behaviours.push_back({lowerCase(words.front().text), words.front().range, {}});
  }

  void argument(Piece rest) {
    const auto setting = lines_.setting(rest);
    if (mission.behaviours.empty()) {
      if (setting) {
        diagnostics_.report(support::diagnostics::argumentOutsideBehaviour, setting->name_range,
                            setting->name);
      }
      return;
    }
    append(mission.behaviours.back().arguments, setting, diagnostics_);
  }

  LineReader& lines_;
  DiagnosticEngine& diagnostics_;
};

/// Degrees and minutes within `most` degrees.
bool isCoordinate(double ddmm, double most) {
  const double minutes = std::fmod(std::fabs(ddmm), 100);
  return minutes < 60 && std::fabs(ddmm) <= most * 100;
}

/// Reads a .ma line by line.
class ArgumentReader {
 public:
  ArgumentReader(LineReader& lines, DiagnosticEngine& diagnostics)
      : lines_(lines), diagnostics_(diagnostics) {}

  void line(Piece line) {
    const std::string word = lowerCase(line.text);
    if (file.behaviour.empty()) {
      name(line, word);
    } else if (word.starts_with('<')) {
      tag(line, word);
    } else if (within_ == "b_arg" && keyword(line) == "b_arg") {
      append(file.arguments, lines_.setting(afterColon(lines_, line)), diagnostics_);
    } else if (within_ == "waypoints") {
      waypoint(line);
    } else {
      expected(within_.empty() ? "<start:b_arg>" : "b_arg:", line);
    }
  }

  /// Checks what can only be checked at the end of the file.
  void finish(support::SourceRange end) {
    if (file.behaviour.empty()) {
      diagnostics_.report(support::diagnostics::argumentFileTag, end,
                          "behavior_name=", "the end of the file");
    } else if (!within_.empty()) {
      diagnostics_.report(support::diagnostics::argumentFileTag, end, "<end:" + within_ + ">",
                          "the end of the file");
    }
  }

  ArgumentFile file;

 private:
  void expected(std::string_view what, Piece found) {
    diagnostics_.report(support::diagnostics::argumentFileTag, found.range, what,
                        quoted(found.text));
  }

  void name(Piece line, const std::string& word) {
    const size_t equals = word.find('=');
    const Piece rest = lines_.trimmed(
        line.range.begin + (equals == std::string::npos ? line.text.size() : equals + 1),
        line.range.end);
    if (!word.starts_with("behavior_name") || lines_.words(rest).size() != 1) {
      expected("behavior_name=", line);
      file.behaviour.assign(1, '?');  // reported once; the rest is still checked for other errors
      return;
    }
    file.behaviour = lowerCase(rest.text);
    file.behaviour_range = rest.range;
  }

  void tag(Piece line, const std::string& word) {
    const bool opens = word == "<start:b_arg>" || word == "<start:waypoints>";
    if (within_.empty() && opens) {
      within_ = word.substr(7, word.size() - 8);
    } else if (!within_.empty() && word == "<end:" + within_ + ">") {
      within_.clear();
    } else {
      expected(within_.empty() ? "<start:b_arg>" : "<end:" + within_ + ">", line);
    }
  }

  void waypoint(Piece line) {
    const auto words = lines_.words(line);
    if (words.size() < 2) {
      diagnostics_.report(support::diagnostics::missionFileSyntax, line.range,
                          "longitude and latitude", quoted(line.text));
      return;
    }
    const auto longitude = lines_.number(words[0]);
    const auto latitude = lines_.number(words[1]);
    if (!longitude || !latitude) {
      return;
    }
    if (!isCoordinate(*longitude, 180) || !isCoordinate(*latitude, 90)) {
      diagnostics_.report(support::diagnostics::badWaypoint, line.range, words[0].text,
                          words[1].text);
      return;
    }
    if (words.size() > 2) {
      const Piece rest = lines_.trimmed(words[2].range.begin, line.range.end);
      diagnostics_.report(support::diagnostics::textAfterWaypoint, rest.range, quoted(rest.text));
    }
    file.waypoints.push_back({*longitude, *latitude});
  }

  LineReader& lines_;
  DiagnosticEngine& diagnostics_;
  std::string within_;  ///< the section that is open, "" for none
};

}  // namespace

std::optional<MissionFile> readMission(const support::SourceManager& sources, uint32_t file,
                                       DiagnosticEngine& diagnostics) {
  const size_t errors_before = diagnostics.errorCount();
  LineReader lines(sources, file, diagnostics);
  if (!lines.acceptable()) {
    return std::nullopt;
  }
  MissionReader reader(lines, diagnostics);
  while (const auto line = lines.next()) {
    reader.line(*line);
  }
  return diagnostics.errorCount() == errors_before ? std::optional(std::move(reader.mission))
                                                   : std::nullopt;
}

std::optional<ArgumentFile> readArguments(const support::SourceManager& sources, uint32_t file,
                                          DiagnosticEngine& diagnostics) {
  const size_t errors_before = diagnostics.errorCount();
  LineReader lines(sources, file, diagnostics);
  if (!lines.acceptable()) {
    return std::nullopt;
  }
  ArgumentReader reader(lines, diagnostics);
  while (const auto line = lines.next()) {
    reader.line(*line);
  }
  const auto end = static_cast<uint32_t>(sources.text(file).size());
  reader.finish({file, end, end});
  return diagnostics.errorCount() == errors_before ? std::optional(std::move(reader.file))
                                                   : std::nullopt;
}

}  // namespace glider::slocum
