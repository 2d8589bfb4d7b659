// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/dock/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace glider::slocum {
namespace {

using vehicles::DockCheck;

/// How to make a vehicle report everything again.
/// Readings are too old after this time, s; three cycles must fit into it.
constexpr double kSlowestCycle = 6;
constexpr const char* kReportAgain =
    "at the vehicle type `put c_extctl_on -1`, then `put c_extctl_on 1`, while the check runs: it "
    "then reports all of them";
constexpr const char* kOtherList =
    "the vehicle has another extctl.ini: copy that of the folder to its \\config, and restart the "
    "science computer";

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values.empty() ? 0 : values[values.size() / 2];
}

DockCheck cyclesFinding(const VehicleRecord& record) {
  const std::string what = "control cycles";
  const ReportedSensor& clock = record.sensors.back();
  if (record.cycles.size() < 3) {
    return notGood(
        "cycles", what,
        fmt::format("`{}` with index {}, which ends each cycle, was reported {}", clock.sensor.name,
                    record.sensors.size() - 1, counted(record.cycles.size(), "time")),
        record.unknown.empty() ? std::string(kOtherList) + "; or run the check longer"
                               : kOtherList);
  }
  std::vector<double> steps;
  for (size_t i = 1; i < record.cycles.size(); ++i) {
    steps.push_back(record.cycles[i].clock_s - record.cycles[i - 1].clock_s);
  }
  const double usual = median(steps);
  const auto gaps =
      std::ranges::count_if(steps, [&](double step) { return step > 1.5 * usual || step <= 0; });
  const std::string text = fmt::format("{}, one each {:.3g} s", record.cycles.size(), usual);
  if (usual > kSlowestCycle) {
    return notGood(
        "cycles", what, text + ", and three must fit into the 20 s for which a reading is known",
        "the vehicle's cycles are too long (x_cycle_overrun_in_ms), or c_extctl_on is not 1");
  }
  return gaps == 0 ? good("cycles", what, text + ", none missing")
                   : notGood("cycles", what,
                             fmt::format("{}; {} before the next", text,
                                         counted(static_cast<uint64_t>(gaps), "gap")),
                             "see `what arrives` above; if that is good, the vehicle's cycles are "
                             "too long (x_cycle_overrun_in_ms)");
}

DockCheck sensorsFinding(const VehicleRecord& record) {
  const std::string what = "sensors of extctl.ini";
  std::string silent;
  size_t all = 0, heard = 0;
  for (const ReportedSensor& one : record.sensors) {
    all += one.is_reported ? 1 : 0;
    heard += one.reports > 0 ? 1 : 0;
    if (one.is_reported && one.reports == 0) {
      silent += fmt::format("{}`{}`", silent.empty() ? "" : ", ", one.sensor.name);
    }
  }
  const std::string text = fmt::format("{} of {} reported", heard, all);
  if (silent.empty()) {
    return good("sensors", what, text);
  }
  const bool must_have_come = !record.hellos_s.empty();
  const std::string missing = fmt::format("{}; silent: {}", text, silent);
  return must_have_come
             ? notGood("sensors", what, missing + ", also after $HI",
                       "the vehicle does not have these sensors, or they have no value yet: type "
                       "`report ? NAME` there")
             : notChecked("sensors", what,
                          missing + "; a value that does not change is reported once, after $HI",
                          kReportAgain);
}

DockCheck unknownFinding(const VehicleRecord& record) {
  const std::string what = "indices on the line";
  if (record.unknown.empty() && record.bad_pairs == 0) {
    return good("indices", what, "all are those of reported sensors in extctl.ini");
  }
  std::string text;
  for (const uint32_t index : record.unknown) {
    text += fmt::format("{}{}", text.empty() ? "" : ", ", index);
  }
  return notGood("indices", what,
                 text.empty() ? counted(record.bad_pairs, "pair") + " that is no `index:value`"
                              : fmt::format("not reported sensors of extctl.ini: {}", text),
                 kOtherList);
}

DockCheck valuesFinding(const VehicleRecord& record) {
  const std::string what = "values";
  std::string wrong, without;
  size_t heard = 0;
  for (size_t index = 0; index < record.sensors.size(); ++index) {
    const ReportedSensor& one = record.sensors[index];
    heard += one.reports > 0 ? 1 : 0;
    if (one.reports > 0 && !std::isfinite(one.newest)) {
      without += fmt::format("{}`{}`", without.empty() ? "" : ", ", one.sensor.name);
    }
    if (one.implausible) {
      wrong += fmt::format("{}`{}` (index {}) {:.10g} {}", wrong.empty() ? "" : ", ",
                           one.sensor.name, index, *one.implausible, one.sensor.unit);
    }
  }
  if (heard == 0) {
    return notChecked("values", what, "no sensor was reported");
  }
  if (wrong.empty() && without.contains("`m_depth`")) {
    return notGood("values", what, "no number: " + without,
                   "type `report + m_depth` at the vehicle: without a depth no mission can fly");
  }
  const std::string numbers = without.empty() ? "" : "; no number yet: " + without;
  return wrong.empty() ? good("values", what,
                              fmt::format("{}, each in the range of its sensor{}",
                                          counted(heard, "sensor"), numbers))
                       : notGood("values", what, "not possible: " + wrong,
                                 std::string(kOtherList) + "; or the sensor is broken");
}

DockCheck missionFinding(const DockSetup& setup, const VehicleRecord& record) {
  const std::string what = "mission file on the vehicle";
  const double number = record.value("u_mission_param_l");
  const double prompt = record.value("x_in_gliderdos");
  const std::string run = fmt::format("at the vehicle type `run {}.mi`", setup.plan.file);
  if (number == setup.plan.port.program) {
    return good("mission-file", what,
                fmt::format("`{}.mi` of this folder (u_mission_param_l {:.0f}){}", setup.plan.file,
                            number, prompt == 1 ? "; the vehicle is at its prompt" : ""));
  }
  if (prompt == 1) {
    return notChecked("mission-file", what, "the vehicle is at its prompt", run);
  }
  if (std::isnan(number)) {
    return notChecked("mission-file", what, "u_mission_param_l was not reported",
                      run + ", and repeat the check; if it flies: " + kReportAgain);
  }
  return notGood(
      "mission-file", what,
      fmt::format("another: its u_mission_param_l is {:.10g}, that of the program {}", number,
                  setup.plan.port.program),
      fmt::format("copy `{}.mi` of the folder to the vehicle, and run it", setup.plan.file));
}

DockCheck restartsFinding(const VehicleRecord& record) {
  const std::string what = "the vehicle's end of the port";
  if (record.byes_s.empty()) {
    return good("port-restarts", what,
                record.hellos_s.empty()
                    ? "stayed open"
                    : fmt::format("opened at {:.1f} s ($HI)", record.hellos_s.front()));
  }
  const double last = record.byes_s.back();
  const std::string ended =
      fmt::format("closed {} ($BY), last at {:.1f} s", counted(record.byes_s.size(), "time"), last);
  return record.newest_report_s > last
             ? good("port-restarts", what, ended + "; it reports again")
             : notGood("port-restarts", what, ended + "; nothing after that",
                       "at the vehicle type `put c_extctl_on 1`; if it ends again, see its log");
}

}  // namespace

std::vector<DockCheck> vehicleFindings(const DockSetup& setup, const DockLine& line, uint32_t baud,
                                       double seconds, const VehicleRecord& record) {
  const double rate = static_cast<double>(line.counts().sentences) / std::max(seconds, 1.0);
  std::vector<double> steps;
  for (size_t i = 1; i < record.cycles.size(); ++i) {
    steps.push_back(record.cycles[i].at_s - record.cycles[i - 1].at_s);
  }
  const double cycle_s = steps.empty() ? kCycleSecs : median(steps);
  return {cyclesFinding(record),
          loadFinding(baud, record.most_cycle_bytes, std::max(cycle_s, 1.0),
                      fmt::format("{:.1f} sentences a second", rate)),
          sensorsFinding(record),
          unknownFinding(record),
          valuesFinding(record),
          missionFinding(setup, record),
          restartsFinding(record)};
}

}  // namespace glider::slocum
