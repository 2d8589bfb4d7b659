// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/extctl/sentence.h"
#include "hooks/flight_science_link/flight_science_link.h"
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
  /// Sets a sensor of the flight controller.
  std::function<void(const std::string&, double)> put;
};

/// The vendor's proglet extctl, as far as is publicly known: reports the changes of the sensors
/// that extctl.ini lists, and writes those that the SBC sends. Between the two computers values
/// cross as text with six decimals, each by itself and seconds late.
class ExtctlProglet final : public SbcProglet {
 public:
  struct Settings {
    uint64_t seed = 0;
    bool virtual_time = false;  ///< reported to the SBC, whose clock then waits
  };
  /// `dictionary` and `platform` outlive this.
  ExtctlProglet(const GliderDictionary& dictionary, const platforms::Platform& platform,
                const slocum::ExtctlFile& file, ExtctlVehicle vehicle, const Settings& settings);

  void run(double now_s, const hooks::ScienceSensors& own, const GliderByteStream& sbc,
           const GliderByteStream& flight) override;
  hooks::SeatEvent nextEvent() override;
  [[nodiscard]] hooks::SbcView sbc() const override { return view_; }

  /// A value needs this long from one computer's behaviours to the other's, s.
  static constexpr double kLeastDelay = 1, kMostDelay = 8;
  /// An SBC that has written nothing for this long is lost, s.
  static constexpr double kSilence = 12;

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
  /// A value on its way to the flight controller.
  struct Passing {
    double due_s;
    std::string name;
    double value;
  };

  void watch(double now_s);
  void takeFlight(const GliderByteStream& flight);
  void hear(double now_s, const GliderByteStream& sbc);
  void obey(double now_s);
  void writePairs(double now_s, std::string_view pairs);
  void setModes(double now_s, std::string_view numbers);
  void takeText(std::string_view text);
  void takeOwnWrite(const Row& row, double value);
  void pass(double now_s, const std::string& name, double value);
  void arrive(double now_s);
  void refresh(double now_s, const hooks::ScienceSensors& own);
  double cross(double now_s, Row& row);
  void report();
  void say(const std::string& body);
  void flush(const GliderByteStream& sbc);

  const platforms::Platform& platform_;
  ExtctlVehicle vehicle_;
  hooks::FlightScienceLink link_;
  hooks::extctl::SentenceReader reader_;
  std::vector<Row> rows_;
  std::vector<double> flight_values_;  ///< by number in the platform file
  std::deque<Passing> passing_;
  uint32_t modes_ = 0;
  Noise noise_;
  Noise mark_noise_;
  std::string out_;
  std::deque<hooks::SeatEvent> events_;
  hooks::SbcView view_;
  bool virtual_time_;
  bool begun_ = false;
  double heard_s_ = 0;  ///< when the SBC last wrote
};

}  // namespace glider::simulator
