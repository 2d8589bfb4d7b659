// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_traces/quantities.h"

#include "vehicles/slocum/data_traces/samples.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace glider::slocum {
namespace {

constexpr double kNoQuantity = std::numeric_limits<double>::quiet_NaN();
constexpr double kAnyAge = std::numeric_limits<double>::infinity();
constexpr double kSlowGap = 3600;    // s; for what changes over hours
constexpr double kAltitudeGap = 30;  // s; in more, the vehicle moves through most of the range

/// One column and the sensor that it is made from.
struct Source {
  const char* column;
  const char* unit;
  const char* sensor;
  Between between = Between::Line;
  double longest_gap_s = kLongestGap;
};

// Of several rows of one column, the first whose sensor was logged is used.
constexpr Source kSources[] = {
    {"missiontime", "s", "m_present_secs_into_mission"},
    {"m_pitch", "rad", "m_pitch"},
    {"m_roll", "rad", "m_roll"},
    {"m_heading", "rad", "m_heading", Between::Angle},
    {"m_fin", "rad", "m_fin"},
    {"m_ballast_pumped", "cc", "m_ballast_pumped"},
    {"c_ballast_pumped", "cc", "c_ballast_pumped", Between::Hold, kAnyAge},
    {"m_de_oil_vol", "cc", "m_de_oil_vol"},
    {"c_de_oil_vol", "cc", "c_de_oil_vol", Between::Hold, kAnyAge},
    {"m_battpos", "in", "m_battpos"},
    {"m_depth_rate", "m/s", "m_depth_rate"},
    {"m_depth_rate", "m/s", "m_depth_rate_avg_final"},
    {"m_speed", "m/s", "m_speed"},
    {"m_altitude", "m", "m_altitude", Between::Line, kAltitudeGap},
    {"m_battery", "V", "m_battery", Between::Line, kSlowGap},
    {"m_battery", "V", "m_battery_inst", Between::Line, kSlowGap},
    {"m_coulomb_current", "A", "m_coulomb_current"},
    {"m_lithium_battery_relative_charge", "%", "m_lithium_battery_relative_charge", Between::Line,
     kSlowGap},
    {"m_vacuum", "inHg", "m_vacuum", Between::Line, kSlowGap},
    {"sci_water_temp", "degC", "sci_water_temp"},
    {"sci_water_cond", "S/m", "sci_water_cond"},
    {"sci_water_pressure", "bar", "sci_water_pressure"},
    {"sci_oxy4_oxygen", "uM", "sci_oxy4_oxygen"},
    {"sci_oxy4_saturation", "%", "sci_oxy4_saturation"},
    {"cc_final_heading_mode", "", "cc_final_heading_mode", Between::Hold, kAnyAge},
    {"cc_final_pitch_mode", "", "cc_final_pitch_mode", Between::Hold, kAnyAge},
    {"cc_final_bpump_mode", "", "cc_final_bpump_mode", Between::Hold, kAnyAge},
    {"x_dr_state", "", "x_dr_state", Between::Hold, kAnyAge},
};

// Optical instruments differ from vehicle to vehicle, their names in the middle of these.
constexpr const char* kOptics[] = {"sci_*_chlor_units", "sci_*_turb_units", "sci_*_bb_units",
                                   "sci_*_cdom_units"};

// Sensors that are used for columns of another name.
constexpr const char* kOthers[] = {"c_heading",       "c_pitch",       "m_water_depth",
                                   "m_coulomb_amphr", "m_depth_state", "cc_final_depth_state_mode"};

const std::vector<double>* find(const std::vector<FlightColumn>& columns, std::string_view name) {
  const auto found = std::ranges::find(
      columns, name, [](const FlightColumn& c) { return std::string_view(c.column.name); });
  return found == columns.end() ? nullptr : &found->values;
}

/// A commanded angle, where the vehicle's control is in one of the modes in which it steers for it:
/// it keeps the last one in the others. Unknown modes: where it was updated lately.
FlightColumn commandedAngle(const Merged& merged, const std::vector<double>& times_s,
                            const char* name, const std::vector<double>* mode, double least,
                            double greatest) {
  FlightColumn made{{name, "rad"}, resampled(samplesOf(merged, name), times_s, Between::Hold)};
  for (size_t i = 0; mode != nullptr && i < times_s.size(); ++i) {
    const bool steers = (*mode)[i] >= least && (*mode)[i] <= greatest;
    made.values[i] = steers ? made.values[i] : kNoQuantity;
  }
  return made;
}

/// Depth of the water; -1 is the vehicle's own value for unknown.
FlightColumn waterDepth(const Merged& merged, const std::vector<double>& times_s) {
  Samples samples = samplesOf(merged, "m_water_depth");
  for (double& value : samples.values) {
    value = value > 0 ? value : kNoQuantity;
  }
  return {{"water_depth", "m"}, resampled(samples, times_s, Between::Line)};
}

/// Whether a gap lies between two times.
bool hasGap(const std::vector<support::TraceGap>& gaps, double from_s, double to_s) {
  const auto first = std::ranges::upper_bound(gaps, from_s, {}, &support::TraceGap::to_s);
  return first != gaps.end() && first->from_s < to_s;
}

/// Power from voltage and current; energy since the first row from voltage and the charge that has
/// flowed, because the current between two records is not known. What flowed in a gap is left out:
/// it is not of the time that the log knows, and the counter may have been reset there.
void addPower(const Merged& merged, const std::vector<double>& times_s,
              const std::vector<support::TraceGap>& gaps, std::vector<FlightColumn>& columns) {
  const std::vector<double>* volts = find(columns, "m_battery");
  if (volts == nullptr) {
    return;
  }
  FlightColumn power{{"power", "W"}, {}}, energy{{"energy", "Wh"}, {}};
  const std::vector<double>* amps = find(columns, "m_coulomb_current");
  const auto charge = resampled(samplesOf(merged, "m_coulomb_amphr"), times_s, Between::Line);
  double sum = 0, before = kNoQuantity, before_s = 0;
  for (size_t i = 0; i < times_s.size(); ++i) {
    power.values.push_back(amps == nullptr ? kNoQuantity : (*volts)[i] * (*amps)[i]);
    const double now_s = times_s[i] - times_s[0];
    const double used = (charge[i] - before) * (*volts)[i];
    // A counter that was reset has used nothing.
    sum += used > 0 && !hasGap(gaps, before_s, now_s) ? used : 0;
    if (!std::isnan(charge[i])) {
      before = charge[i];
      before_s = now_s;
    }
    energy.values.push_back(std::isnan(charge[i] + (*volts)[i]) ? kNoQuantity : sum);
  }
  columns.push_back(std::move(power));
  columns.push_back(std::move(energy));
}

/// Makes `values` at `times_s` unknown from the end of each gap to the next sample.
void forgetInGaps(const Samples& samples, const std::vector<double>& times_s,
                  const std::vector<support::TraceGap>& gaps, std::vector<double>& values) {
  for (size_t i = 0; i < times_s.size(); ++i) {
    const auto after =
        std::ranges::upper_bound(gaps, times_s[i] - times_s[0], {}, &support::TraceGap::to_s);
    const size_t count = samples.countUntil(times_s[i]);
    if (after != gaps.begin() && count > 0 &&
        samples.times_s[count - 1] - times_s[0] < std::prev(after)->to_s) {
      values[i] = kNoQuantity;
    }
  }
}

/// What the vehicle does: 0 at the surface, 1 dives, 2 climbs, 3 hovers. What it did before a gap
/// it need not do after it: the files there may not have the sensor.
FlightColumn states(const Merged& merged, const std::vector<double>& times_s,
                    const std::vector<support::TraceGap>& gaps) {
  Samples samples = samplesOf(merged, "m_depth_state");
  if (samples.empty()) {
    samples = samplesOf(merged, "cc_final_depth_state_mode");
  }
  for (double& value : samples.values) {
    value = value >= 0 && value <= 3 ? value : kNoQuantity;
  }
  auto values = resampled(samples, times_s, Between::Hold, kAnyAge);
  forgetInGaps(samples, times_s, gaps, values);
  return {{"state", "id"}, std::move(values)};
}

}  // namespace

std::vector<std::string> quantitySensors() {
  std::vector<std::string> names(std::begin(kOptics), std::end(kOptics));
  names.insert(names.end(), std::begin(kOthers), std::end(kOthers));
  for (const Source& source : kSources) {
    names.emplace_back(source.sensor);
  }
  return names;
}

std::vector<FlightColumn> quantities(const Merged& merged, const std::vector<double>& times_s,
                                     const std::vector<support::TraceGap>& gaps) {
  std::vector<FlightColumn> columns = {states(merged, times_s, gaps)};
  for (const Source& source : kSources) {
    const Samples samples = samplesOf(merged, source.sensor, source.unit);
    if (!samples.empty() && find(columns, source.column) == nullptr) {
      columns.push_back({{source.column, source.unit},
                         resampled(samples, times_s, source.between, source.longest_gap_s)});
    }
  }
  for (const MergedColumn& column : merged.columns) {
    if (std::ranges::any_of(kOptics,
                            [&](const char* name) { return matches(column.name, name); })) {
      columns.push_back({{column.name, column.sensor.unit},
                         resampled(samplesOf(merged, column.name), times_s, Between::Line)});
    }
  }
  // Heading: to the waypoint or to a heading. Pitch: set once from the calibration, or controlled.
  columns.push_back(
      commandedAngle(merged, times_s, "c_heading", find(columns, "cc_final_heading_mode"), 0, 1));
  columns.push_back(
      commandedAngle(merged, times_s, "c_pitch", find(columns, "cc_final_pitch_mode"), 2, 3));
  columns.push_back(waterDepth(merged, times_s));
  addPower(merged, times_s, gaps, columns);
  return columns;
}

}  // namespace glider::slocum
