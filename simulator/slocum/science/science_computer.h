// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/dictionary.h"
#include "platforms/load/platform.h"
#include "simulator/faults/sensor_damage.h"
#include "simulator/journal.h"
#include "simulator/ocean/ocean.h"
#include "simulator/sensors/provided.h"
#include "simulator/sensors/sensor_list.h"
#include "simulator/slocum/line/flight_science_line.h"
#include "simulator/slocum/science/sample_periods.h"
#include "simulator/slocum/science/sbc_proglet.h"

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace glider::simulator {

/// The science computer: runs its sensors and the proglet that serves the SBC once a second.
class ScienceComputer {
 public:
  ScienceComputer(const platforms::Platform& platform, uint64_t seed,
                  const SensorSettings& settings, MakeProglet make);

  /// Where the vehicle is: m down, east and north of the world's origin.
  struct Place {
    double depth_m = 0, x = 0, y = 0;
  };
  /// The science cycle at time `now_s`. `sbc` is the 115200 line, `line` the one to the flight
  /// controller.
  void run(double now_s, const Ocean& ocean, const Place& place, const GliderByteStream& sbc,
           FlightScienceLine& line);

  /// From now on each instrument samples that often; until this is called, in each cycle.
  void sampleEvery(const SamplePeriods& periods);
  /// Restarts it: its state is lost.
  void restart();
  /// True for a sensor that it reads itself: one of an instrument on board, or its clock.
  [[nodiscard]] bool reads(uint16_t id) const;
  /// Sets what its sensors report from now on instead of the truth.
  void damageBy(SensorDamage* damage) { damage_ = damage; }
  [[nodiscard]] hooks::SeatEvent nextEvent() { return proglet_->nextEvent(); }
  [[nodiscard]] hooks::SbcView sbc() const { return proglet_->sbc(); }
  [[nodiscard]] bool sbcMaySleep() const { return proglet_->sbcMaySleep(); }
  /// The newest good reading of one of its own sensors, NaN before the first and of others.
  [[nodiscard]] double value(uint16_t id) const {
    return id < values_.size() ? values_[id] : std::numeric_limits<double>::quiet_NaN();
  }
  /// The same for the trace: NaN while the instrument is off.
  [[nodiscard]] double recorded(uint16_t id) const;

 private:
  /// An instrument on board, with the numbers that the vehicle gives its sensors.
  struct OnBoard {
    std::unique_ptr<Instrument> instrument;
    std::vector<uint16_t> numbers;
    std::vector<double> readings;  ///< the newest
    double period_s = 0;           ///< negative: off
    double sampled_s = -std::numeric_limits<double>::infinity();
  };
  void fit(const platforms::Platform& platform, std::unique_ptr<Instrument> instrument);
  void sample(OnBoard& one, const Sampling& at);
  void set(uint16_t id, double value);
  /// What a sensor keeps: rounded to its width.
  void store(uint16_t id, double value);
  void receive();
  static void write(void* self, uint16_t id, double value);
  static double get(void* self, uint16_t id, bool* fresh);

  std::vector<OnBoard> instruments_;
  SensorDamage* damage_ = nullptr;
  MakeProglet make_proglet_;
  SensorNumbers numbers_;
  platforms::Dictionary dictionary_;
  std::unique_ptr<SbcProglet> proglet_;
  std::vector<double> values_;  ///< by number
  std::vector<uint8_t> fresh_, bytes_, of_flight_;
  FlightScienceLine* line_ = nullptr;  ///< during run
};

}  // namespace glider::simulator
