// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/against/log_ticks.h"

#include "report/picture/picture.h"
#include "vehicles/slocum/data_tables/log_units.h"
#include "vehicles/slocum/data_tables/merge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace glider::analysis {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr const char* kDepth = "m_depth";

/// One update of a record.
struct LoggedUpdate {
  uint32_t row = 0;
  uint32_t column = 0;  ///< of the merged table
  double value = 0;
};

/// `heading` less `by`, both within a full turn, in [0, 2 pi).
double turnedBack(double heading, double by) {
  constexpr double kTurn = 2 * std::numbers::pi;
  const double turned = heading - by;
  const double within = turned < 0 ? turned + kTurn : turned >= kTurn ? turned - kTurn : turned;
  return within < kTurn ? within : 0;
}

/// Makes magnetic headings true, as runtime/core/compass.cpp does on the SBC.
class TrueHeadings {
 public:
  explicit TrueHeadings(const ir::Mission& mission) : m_(mission) {
    if (mission.compass && mission.compass->declination) {
      variation_ = -*mission.compass->declination;
    }
  }

  void convert(std::vector<ir::SensorUpdate>& frame) {
    if (!m_.compass) {
      return;
    }
    for (const ir::SensorUpdate& update : frame) {
      if (update.sensor == m_.compass->variation && std::fabs(update.raw) <= std::numbers::pi) {
        variation_ = update.raw;
      }
    }
    for (ir::SensorUpdate& update : frame) {
      if (m_[update.sensor].encoding == ir::Encoding::Magnetic && update.raw >= 0 &&
          update.raw <= 2 * std::numbers::pi) {
        update.raw = turnedBack(update.raw, variation_);
      }
    }
  }

 private:
  const ir::Mission& m_;
  double variation_ = 0;
};

/// What hookprog leaves out to save bytes on the line.
class Reduction {
 public:
  Reduction(const ir::Mission& mission, const platforms::Platform& platform)
      : m_(mission), platform_(platform), sent_(mission.sensors.size()) {}

  /// Of the next tick.
  void reduce(std::vector<ir::SensorUpdate>& frame) {
    ++tick_;
    std::erase_if(frame, [&](ir::SensorUpdate& update) { return !passes(update); });
  }

 private:
  struct LastSent {
    double tick = -std::numeric_limits<double>::infinity();
    double value = kUnknown;
  };

  bool passes(ir::SensorUpdate& update) {
    const uint16_t id = m_[update.sensor].id;
    if (id >= platform_.sensors.size()) {
      return true;
    }
    const platforms::PlatformSensor& sensor = platform_.sensors[id];
    LastSent& sent = sent_[update.sensor.index];
    if ((tick_ - sent.tick) * platform_.envelope.cycle_s < sensor.every_s) {
      return false;
    }
    sent.tick = tick_;
    if (sensor.dead_band > 0 && std::fabs(update.raw - sent.value) <= sensor.dead_band) {
      update.raw = sent.value;
    }
    sent.value = update.raw;
    return true;
  }

  const ir::Mission& m_;
  const platforms::Platform& platform_;
  std::vector<LastSent> sent_;
  double tick_ = 0;
};

/// A sensor of the vehicle at each tick, for people.
class ShownQuantity {
 public:
  ShownQuantity(const platforms::Platform& platform, std::string_view name)
      : name_(name), sensor_(platform.find(name)) {}

  [[nodiscard]] const std::string& name() const { return name_; }

  void take(double value, double time) {
    value_ = value;
    time_ = time;
  }
  [[nodiscard]] double at(double time) const {
    const bool known = sensor_ != nullptr && value_ >= sensor_->lowest &&
                       value_ <= sensor_->highest && time - time_ <= sensor_->stale_after_s;
    return known ? value_ : kUnknown;
  }

 private:
  std::string name_;
  const platforms::PlatformSensor* sensor_;
  double value_ = kUnknown;
  double time_ = 0;
};

/// Makes ticks of the merged records of a vehicle: collects the updates since the last tick, as
/// hookprog would have sent them (Reduction), and ends a tick at each record of the flight
/// computer.
class TickBuilder {
 public:
  TickBuilder(const std::vector<slocum::LogFile>& files, const ir::Mission& mission,
              const platforms::Platform& platform)
      : m_(mission),
        platform_(platform),
        merged_(slocum::merge(files, namesOf(mission))),
        headings_(mission),
        reduction_(mission, platform) {
    shown_.emplace_back(platform, kDepth);
    for (const report::TrackQuantity& quantity : report::pictureQuantities()) {
      shown_.emplace_back(platform, quantity.column);
    }
    out_.sensors.resize(mission.sensors.size());
    out_.science = std::ranges::none_of(files, [](const slocum::LogFile& file) {
      return file.data.computer == slocum::Computer::Flight;
    });
  }

  LogTicks build() {
    const std::vector<LoggedUpdate> updates = updatesByRow();
    auto next = updates.begin();
    for (uint32_t row = 0; row < merged_.rows.size(); ++row) {
      const slocum::MergedRow& record = merged_.rows[row];
      for (; next != updates.end() && next->row == row; ++next) {
        if (std::isfinite(record.time)) {
          take(*next, record.time);
        }
      }
      const bool flight = merged_.files[record.file].data.computer == slocum::Computer::Flight;
      if (flight != out_.science && std::isfinite(record.time)) {
        tick(record.time);
      }
    }
    return std::move(out_);
  }

 private:
  static std::vector<std::string> namesOf(const ir::Mission& mission) {
    std::vector<std::string> names = {kDepth};
    for (const report::TrackQuantity& quantity : report::pictureQuantities()) {
      names.emplace_back(quantity.column);
    }
    for (const ir::Sensor& sensor : mission.sensors) {
      if (sensor.isOfVehicle()) {
        names.push_back(sensor.vehicle_name);
      }
    }
    return names;
  }

  std::vector<LoggedUpdate> updatesByRow() {
    std::vector<LoggedUpdate> updates;
    for (uint32_t column = 0; column < merged_.columns.size(); ++column) {
      sensors_.push_back(sensorCalled(merged_.columns[column].name));
      factors_.push_back(factorOf(merged_.columns[column]));
      if (sensors_.back().valid()) {
        out_.sensors[sensors_.back().index].present = true;
      }
      merged_.forEachUpdateOf(column, [&](uint32_t row, double value) {
        updates.push_back({row, column, value * factors_[column]});
      });
    }
    std::ranges::stable_sort(updates, {}, &LoggedUpdate::row);
    return updates;
  }

  /// What turns the values of a column into the unit of the platform.
  [[nodiscard]] double factorOf(const slocum::MergedColumn& column) const {
    const platforms::PlatformSensor* sensor = platform_.find(column.name);
    return sensor == nullptr ? 1
                             : slocum::factorBetween(column.sensor.unit, sensor->unit).value_or(1);
  }

  [[nodiscard]] ir::SensorId sensorCalled(const std::string& name) const {
    const auto found = std::ranges::find_if(m_.sensors, [&](const ir::Sensor& sensor) {
      return sensor.symbol.empty() && slocum::isSameName(sensor.vehicle_name, name);
    });
    return found == m_.sensors.end()
               ? ir::SensorId{}
               : ir::SensorId{static_cast<uint32_t>(found - m_.sensors.begin())};
  }

  void take(const LoggedUpdate& update, double time) {
    for (ShownQuantity& shown : shown_) {
      if (slocum::isSameName(merged_.columns[update.column].name, shown.name())) {
        shown.take(update.value, time);
      }
    }
    if (const ir::SensorId sensor = sensors_[update.column]; sensor.valid()) {
      // Only the newest value of a cycle reaches the mission.
      std::erase_if(frame_, [&](const ir::SensorUpdate& older) { return older.sensor == sensor; });
      frame_.push_back({sensor, update.value});
      ++out_.sensors[sensor.index].updates;
    }
  }

  void tick(double utc) {
    const double time = out_.ticks.empty() ? 0 : utc - out_.ticks.front().utc_s;
    headings_.convert(frame_);
    reduction_.reduce(frame_);
    std::vector<double> quantities;
    for (size_t i = 1; i < shown_.size(); ++i) {
      quantities.push_back(shown_[i].at(utc));
    }
    out_.ticks.push_back({utc, time, shown_[0].at(utc), std::move(quantities), std::move(frame_)});
    frame_.clear();
  }

  const ir::Mission& m_;
  const platforms::Platform& platform_;
  slocum::Merged merged_;
  TrueHeadings headings_;
  Reduction reduction_;
  std::vector<ShownQuantity> shown_;   ///< the depth, then the quantities
  std::vector<ir::SensorId> sensors_;  ///< of the mission, for each column
  std::vector<double> factors_;        ///< to the platform's unit, for each column
  std::vector<ir::SensorUpdate> frame_;
  LogTicks out_;
};

}  // namespace

LogTicks ticksAlong(const std::vector<slocum::LogFile>& files, const ir::Mission& mission,
                    const platforms::Platform& platform) {
  return TickBuilder(files, mission, platform).build();
}

}  // namespace glider::analysis
