// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Each line of the mission file that `build --dialect extctl` writes, changed: either the check of
// the folder reports it, or the proof by the port does not rest on it, for the reason that the
// table here gives.

#include "platforms/load/load_platform.h"
#include "support/source_manager.h"
#include "vehicles/slocum/mission_files/read.h"
#include "vehicles/slocum/port_files/port_plan.h"
#include "vehicles/slocum/rules/port/port_doubts.h"
#include "vehicles/slocum/rules/port/port_masks.h"
#include "vehicles/slocum/rules/port/port_whole.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace glider::slocum::rules {
namespace {

const platforms::Platform& vehicle() {
  static const auto loaded = platforms::loadPlatform(GLIDER_SOURCE_DIR "/platforms/slocum.toml");
  return *loaded;
}

std::vector<std::string> linesFor(Release release) {
  const auto plan = planPort("survey", "text", vehicle(), {},
                             {.release = release, .greatest_depth_m = 40, .surface_after_s = 3600});
  EXPECT_TRUE(plan.has_value());
  std::istringstream text(printPortMission(*plan));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    lines.push_back(line);
  }
  return lines;
}

/// What the check says of the file, the first of it; "" for nothing.
std::string finding(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) {
    text += line + "\n";
  }
  support::SourceManager sources;
  support::DiagnosticEngine diagnostics;
  const auto file = readMission(sources, sources.add("survey.mi", text), diagnostics);
  if (!file || !diagnostics.sorted().empty()) {
    return "it cannot be read";
  }
  if (!isPortFile(*file)) {
    return "it is not of the port";  // the folder is refused: GL4016 or GL3133
  }
  const PortFile port = portFileOf(*file, vehicle());
  for (const auto& found : {portDoubts(*file, port, vehicle()), portMasks(*file, port)}) {
    if (!found.empty()) {
      return found.front().what;
    }
  }
  for (const Ending& ending : portWhole(*file, port, vehicle()).endings) {
    if (!ending.proved()) {
      return ending.why_not;
    }
  }
  return "";
}

/// "2 surface when_secs" of a b_arg, "sensor u_mission_param_a" of a sensor; "" for another line.
std::string nameOf(const std::string& line, int& number, std::string& behaviour) {
  std::istringstream words(line);
  std::string first, second;
  words >> first >> second;
  if (first == "behavior:") {
    behaviour = std::to_string(++number) + " " + second;
  }
  const std::string name = second.substr(0, second.find('('));
  return first == "b_arg:" ? behaviour + " " + name : first == "sensor:" ? "sensor " + name : "";
}

constexpr const char* kValues[] = {"removed", "0", "-7", "1e9"};

/// The changes about which nothing is said: "surface.gps_wait_time 0".
std::set<std::string> silentChanges(Release release) {
  const std::vector<std::string> lines = linesFor(release);
  EXPECT_EQ(finding(lines), "");
  std::set<std::string> silent;
  std::string behaviour;
  int number = 0;
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::string name = nameOf(lines[i], number, behaviour);
    for (const char* value : kValues) {
      std::vector<std::string> twin = lines;
      if (std::string(value) == "removed") {
        twin[i].clear();
      } else {
        twin[i] = lines[i].substr(0, lines[i].rfind(' ') + 1) + value;
      }
      if (!name.empty() && twin[i] != lines[i] && finding(twin).empty()) {
        silent.insert(name + " " + value);
      }
    }
  }
  return silent;
}

/// Changes about which nothing is said, and why they change nothing on which a proof rests.
struct Harmless {
  const char* line;
  std::vector<const char*> values;
  const char* why;
};

const std::vector<Harmless> kBoth = {
    {"1 abend overdepth", {"0"}, "each commanded depth is beyond it: GL3125"},
    {"1 abend overdepth_sample_time", {"removed", "0"}, "15 s by itself, or in each cycle"},
    {"1 abend overtime", {"removed", "-7", "1e9"}, "off: the timer brings the vehicle up"},
    {"1 abend samedepth_for", {"removed", "0", "-7", "1e9"}, "an abort is one of the endings"},
    {"1 abend stalled_for", {"removed", "0", "-7", "1e9"}, "an abort is one of the endings"},
    {"2 surface start_when", {"removed"}, "12 by itself"},
    {"2 surface when_secs", {"removed"}, "1200 by itself, which the proof states"},
    {"2 surface end_action", {"removed"}, "1 by itself"},
    {"2 surface gps_wait_time", {"removed", "0", "-7", "1e9"}, "the vehicle is at the surface"},
    {"2 surface keystroke_wait_time",
     {"removed", "0", "-7", "1e9"},
     "the vehicle is at the surface"},
    {"2 surface c_use_bpump", {"removed"}, "2 by itself"},
    {"2 surface c_bpump_value", {"removed", "1e9"}, "as far as the pump goes"},
    {"2 surface c_use_pitch", {"removed"}, "3 by itself"},
    {"2 surface c_pitch_value", {"removed"}, "0.4538 by itself"},
    {"3 surface gps_wait_time", {"removed", "0", "-7", "1e9"}, "the vehicle is at the surface"},
    {"3 surface c_use_bpump", {"removed"}, "2 by itself"},
    {"3 surface c_bpump_value", {"removed", "1e9"}, "as far as the pump goes"},
    {"3 surface c_use_pitch", {"removed"}, "3 by itself"},
    {"3 surface c_pitch_value", {"removed"}, "0.4538 by itself"},
    {"N set_heading start_when", {"removed"}, "0 by itself"},
    {"N set_heading stop_when", {"removed"}, "5 by itself"},
    {"N yo start_when", {"removed"}, "2 by itself"},
    {"N yo num_half_cycles_to_do", {"removed"}, "-1 by itself"},
    {"N yo d_target_altitude", {"removed"}, "5 by itself"},
    {"N yo d_use_bpump", {"removed"}, "2 by itself"},
    {"N yo d_bpump_value", {"removed"}, "-1000 by itself"},
    {"N yo d_use_pitch", {"removed"}, "3 by itself"},
    {"N yo c_target_altitude", {"removed"}, "-1 by itself"},
    {"N yo c_use_bpump", {"removed"}, "2 by itself"},
    {"N yo c_bpump_value", {"removed", "1e9"}, "as far as the pump goes"},
    {"N yo c_use_pitch", {"removed"}, "3 by itself"},
    {"N yo end_action", {"removed", "0", "-7", "1e9"}, "it does not end"},
    {"N sample sensor_type", {"removed", "-7", "1e9"}, "what is off is an unknown reading"},
    {"N sample state_to_sample",
     {"removed", "0", "-7", "1e9"},
     "what is off is an unknown reading"},
    {"N sample intersample_time", {"removed", "-7", "1e9"}, "what is off is an unknown reading"},
    {"N sensors_in c_att_time", {"removed"}, "in each cycle by itself"},
    {"N sensors_in c_pressure_time", {"removed"}, "in each cycle by itself"},
    {"N sensors_in c_alt_time",
     {"removed", "-7", "1e9"},
     "a leg with a target altitude switches the altimeter on"},
    {"N sensors_in c_extctl_on", {"removed"}, "`sample` switches all science sensors on"},
    {"sensor c_science_all_on_enabled",
     {"removed", "0", "-7", "1e9"},
     "c_extctl_on switches the port on"},
    {"sensor u_mission_param_a",
     {"removed", "-7", "1e9"},
     "any heading, until the SBC has written one"},
    {"sensor u_mission_param_b",
     {"removed", "-7", "1e9"},
     "not read before the SBC has written it"},
    {"sensor u_mission_param_c",
     {"removed", "-7", "1e9"},
     "not read before the SBC has written it"},
    {"sensor u_mission_param_f",
     {"removed", "0", "-7", "1e9"},
     "written 20 s before the vehicle leaves the surface"},
    {"sensor u_mission_param_g",
     {"removed", "0", "-7", "1e9"},
     "written 20 s before the vehicle leaves the surface"},
    {"sensor u_mission_param_l", {"0", "-7", "1e9"}, "not that of the program: GL4016"},
};
const std::vector<Harmless> kModes = {
    {"sensor sci_wants_surface", {"removed", "0", "-7", "1e9"}, "u_mission_mode takes its place"},
};

/// With `modes`, a goto_wpt stands above, and the numbers are one more.
std::set<std::string> harmless(bool modes) {
  const std::vector<std::pair<std::string, int>> kNumbers = {
      {"set_heading", 4}, {"yo", 5}, {"sample", 6}, {"sensors_in", 7}};
  std::set<std::string> all;
  for (const auto* rows : {&kBoth, modes ? &kModes : nullptr}) {
    for (const Harmless& row : rows != nullptr ? *rows : std::vector<Harmless>{}) {
      std::string line = row.line;
      for (const auto& [name, number] : kNumbers) {
        if (line.starts_with("N " + name + " ")) {
          line = std::to_string(number + (modes ? 1 : 0)) + line.substr(1);
        }
      }
      for (const char* value : row.values) {
        all.insert(line + " " + value);
      }
    }
  }
  return all;
}

TEST(PortArguments, EachChangeIsReportedOrHarmless) {
  EXPECT_EQ(silentChanges(Release::Common), harmless(false));
  EXPECT_EQ(silentChanges(Release::MissionModes), harmless(true));
}

TEST(PortArguments, AnAltitudeAtWhichNoVehicleTurnsInTimeIsReported) {
  std::vector<std::string> lines = linesFor(Release::Common);
  const auto altitude = std::ranges::find_if(lines, [](const std::string& line) {
    return line.find("d_target_altitude") != std::string::npos;
  });
  ASSERT_NE(altitude, lines.end());
  for (const char* value : {"0.01", "4.9", "101"}) {
    *altitude = altitude->substr(0, altitude->rfind(' ') + 1) + value;
    EXPECT_NE(finding(lines), "") << value;
  }
  *altitude = altitude->substr(0, altitude->rfind(' ') + 1) + "20";
  EXPECT_EQ(finding(lines), "");
}

}  // namespace
}  // namespace glider::slocum::rules
