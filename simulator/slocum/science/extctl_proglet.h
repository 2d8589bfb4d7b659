// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/sentence.h"
#include "platforms/load/platform.h"
#include "simulator/sensors/noise.h"
#include "simulator/slocum/science/sbc_proglet.h"
#include "vehicles/slocum/mission_files/extctl_file.h"

#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <vector>

namespace glider::simulator {

/// What the proglet has of the vehicle around it.
struct ExtctlVehicle {
  /// A sensor of the flight controller that no mission reads, as u_mission_param_l; NaN if the
  /// vehicle does not have it.
  std::function<double(const std::string&)> value;
  /// Sets a sensor of the flight controller, over the line between the two.
  std::function<void(const std::string&, double)> put;
};

/// The vendor's proglet extctl, as far as is publicly known: reports the changes of the sensors
/// that extctl.ini lists, and writes those that the SBC sends.
class ExtctlProglet final : public SbcProglet {
 public:
  struct Settings {
    uint64_t seed = 0;
    bool virtual_time = false;  ///< reported to the SBC, whose clock then waits
  };
  ExtctlProglet(const platforms::Platform& platform, const slocum::ExtctlFile& file,
                ExtctlVehicle vehicle, const Settings& settings);

  void run(double now_s, const hooks::ScienceMemory& memory, const GliderByteStream& sbc) override;
  hooks::SeatEvent nextEvent() override;
  [[nodiscard]] hooks::SbcView sbc() const override { return view_; }

  /// An SBC that has written nothing for this long is lost, s.
  static constexpr double kSilence = 12;
  /// A sensor that only the flight controller has needs so long until it is here, s.
  static constexpr double kLeastDelay = 1, kMostDelay = 8;

 private:
  /// A sensor with an index on the port.
  struct Row {
    std::string name;
    uint16_t id = 0;        ///< in the platform file; kNoSensor: only the flight controller has it
    bool reported = false;  ///< section is
    double value = std::numeric_limits<double>::quiet_NaN();
    /// Of the flight controller, on its way here until `due_s`; only without an id.
    double newest = std::numeric_limits<double>::quiet_NaN();
    double due_s = 0;
    bool told = false;  ///< the SBC has `value`, as far as the vehicle knows
  };

  void watch(double now_s);
  void hear(double now_s, const GliderByteStream& sbc);
  void obey(double now_s);
  void writePairs(std::string_view pairs);
  void setModes(std::string_view numbers);
  void takeText(std::string_view text);
  void takeOwnWrite(const Row& row, double value);
  void refresh(double now_s, const hooks::ScienceMemory& memory);
  double cross(double now_s, Row& row);
  void report();
  void say(const std::string& body);
  void flush(const GliderByteStream& sbc);

  ExtctlVehicle vehicle_;
  hooks::extctl::SentenceReader reader_;
  std::vector<Row> rows_;
  uint32_t modes_ = 0;
  Noise mark_noise_;
  std::string out_;
  std::deque<hooks::SeatEvent> events_;
  hooks::SbcView view_;
  bool virtual_time_;
  bool begun_ = false;
  double heard_s_ = 0;  ///< when the SBC last wrote
};

}  // namespace glider::simulator
