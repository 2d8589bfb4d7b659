// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "simulator/journal.h"
#include "simulator/magnetism/declination.h"
#include "simulator/sensors/sensor_list.h"
#include "simulator/slocum/flight/current_estimate.h"
#include "simulator/slocum/flight/device.h"
#include "simulator/slocum/flight/dynamic_control.h"
#include "simulator/slocum/flight/geography.h"
#include "simulator/slocum/flight/layered_control.h"
#include "simulator/slocum/flight/mission_variables.h"
#include "simulator/slocum/flight/navigator.h"
#include "simulator/slocum/line/flight_science_line.h"

#include <limits>
#include <memory>
#include <optional>
#include <string>

namespace glider::simulator {

/// The instruction of the SBC that hookbeh obeys, for the trace. NaN: none.
struct ObeyedInstruction {
  double vertical = std::numeric_limits<double>::quiet_NaN();
  double depth_m = std::numeric_limits<double>::quiet_NaN();
  double top_m = std::numeric_limits<double>::quiet_NaN();  ///< target of the state's last ascend
  double bottom_m = std::numeric_limits<double>::quiet_NaN();  ///< target of its last descend
};

/// The flight controller: every four seconds sensors → layered control → dynamic control → devices
/// → flight-science link.
class FlightController {
 public:
  /// `year`, with its fraction, is for the magnetic field.
  FlightController(const platforms::Platform& platform, const slocum::MissionFile& mission,
                   const SensorSettings& sensors, uint64_t seed, const LocalFrame& frame,
                   double year, Journal& journal, Code15 code_15 = Code15::FarFromWaypoint);

  /// The vehicle starts at (x, y) of the frame instead of its origin.
  void startAt(double x, double y) { navigator_.startAt(x, y); }
  /// The control cycle at time `now_s` of the mission.
  void cycle(double now_s, const Ocean& ocean, Vehicle& vehicle, FlightScienceLine& line);

  [[nodiscard]] const SensorArray& array() const { return array_; }
  /// m_x_lmc and m_y_lmc as metres true east and north of where the flight started.
  [[nodiscard]] Planar reckoned() const;
  /// m_water_vx and m_water_vy towards true east and north.
  [[nodiscard]] Planar waterVelocity() const;
  [[nodiscard]] const ObeyedInstruction& obeyed() const { return obeyed_; }
  [[nodiscard]] bool hookActive() const;
  /// Complete after an abort, Absent without a hookbeh.
  [[nodiscard]] hooks::HookState hookState() const;
  /// When the mission in progress began, s of the flight.
  [[nodiscard]] double missionStart() const { return mission_start_s_; }
  /// What hookbeh commanded in this cycle; null without one, and after an abort.
  [[nodiscard]] const hooks::HookbehOutputs* hookbeh() const;
  /// Which slots of the command record hookbeh did not fill last in this cycle.
  [[nodiscard]] uint8_t hookbehMasked() const {
    return layers_->hookbeh() != nullptr ? layers_->hookbeh()->masked() : 0;
  }
  /// How often the instruments of the science bay are to sample.
  [[nodiscard]] const SamplePeriods& samplePeriods() const { return sample_periods_; }
  /// What the SBC orders of them: a word of hooks/protocol/sampling.h.
  [[nodiscard]] uint32_t sampling() const { return sampling_; }
  /// Heading, pitch and pump were all commanded in this cycle, by whichever behaviour.
  [[nodiscard]] bool commandedWhole() const { return commanded_whole_; }
  [[nodiscard]] bool aborted() const { return abort_ != Abort::None; }
  /// The behaviour that commands the pitch, by its place in the mission file; kNoLayer after an
  /// abort.
  [[nodiscard]] int layer() const { return layer_; }
  /// The waypoint that the vehicle steers to, degrees and minutes (ddmm.mmmm); NaN: to none.
  [[nodiscard]] double waypointLatitude() const { return waypoint_latitude_ddmm_; }
  [[nodiscard]] double waypointLongitude() const { return waypoint_longitude_ddmm_; }
  /// How the mission ended; none while it is not over.
  [[nodiscard]] const std::optional<News>& end() const { return end_; }
  /// The SBC's mission has changed state: of the range that the previous state commanded, only the
  /// command in force is still valid.
  void noteTransition();
  /// The operator or the science computer sets a sensor of the mission's, as u_mission_param_a.
  void put(const std::string& sensor, double value) { variables_.set(sensor, value); }
  /// What the mission file or a put() has set a sensor of the mission's to; NaN: nothing has.
  [[nodiscard]] double setting(const std::string& sensor) const {
    return variables_.find(sensor).value_or(std::numeric_limits<double>::quiet_NaN());
  }
  /// Without hookbeh nothing on the vehicle can take control away: an SBC at the port for a
  /// backseat driver has it while its mission `flies`.
  void noteBackseat(bool flies) { backseat_flies_ = flies; }
  /// A device fails: the mission is aborted.
  void failDevice(double now_s);
  /// Restarts its mission at `now_s`, as after a restart of the computer; with `keeps_array`, as
  /// for a new mission without such a restart. A mission that is over or aborted stays so.
  void restart(double now_s, bool keeps_array);
  /// Puts an instruction into the sensor array as an earlier mission would have left it.
  void leaveOver(const Leftover& leftover);
  /// Sets what sensors report from now on instead of the truth.
  void damageBy(SensorDamage* damage) { array_.damageBy(damage); }
  /// Ends the mission at the surface when nothing is left to fly; `sbc_gone`: the SBC will not come
  /// back.
  void noteSbcGone(bool sbc_gone) { sbc_gone_ = sbc_gone; }

 private:
  [[nodiscard]] bool waitsForOperator(const Situation& situation) const;
  void readSensors(double now_s, const Ocean& ocean, const Vehicle& vehicle);
  void locate(double now_s, double declination, const Vehicle& vehicle);
  [[nodiscard]] bool isReported(const Gps::Fix& fix);
  void noteLocalPosition();
  [[nodiscard]] Planar currentUsed() const;
  void noteCurrent(double now_s, bool at_surface, const std::optional<Gps::Fix>& fix, Planar used);
  [[nodiscard]] double variation() const;
  void readPressure(double now_s, const Ocean& ocean, const Vehicle& vehicle);
  void readAttitude(double declination, const Vehicle& vehicle);
  void readAltimeter(const Ocean& ocean, const Vehicle& vehicle);
  /// The value of `sensor` after `truth` was stored: `truth`, with all its digits, unless the
  /// sensor is damaged.
  [[nodiscard]] double felt(Sensor sensor, double truth) const;
  void receive(LineDirection& line);
  void send(LineDirection& line) const;
  [[nodiscard]] Situation situation(double now_s);
  void noteInstruction();
  void noteRange();
  void startAbort(Abort abort, const std::string& why, double now_s);
  void tellHookIsOver();
  [[nodiscard]] Commands decide(const Situation& situation);
  void control(const Commands& commands, const Situation& situation, Vehicle& vehicle);
  void judgeEnd(const Situation& situation);
  void countInflections(const Situation& situation);

  slocum::MissionFile mission_;
  bool backseat_flies_ = false;
  Code15 code_15_;
  MissionVariables variables_;
  std::vector<platforms::Instrument> instruments_;  ///< that missions switch
  SensorArray array_;
  const LocalFrame& frame_;
  Declination declination_;
  Navigator navigator_;
  CurrentEstimate current_;
  DepthSensor depth_sensor_;
  AttitudeSensor attitude_;
  Altimeter altimeter_;
  Gps gps_;
  Device pressure_device_{"c_pressure_time"}, attitude_device_{"c_att_time"},
      altimeter_device_{"c_alt_time"}, gps_device_{"c_gps_on"}, battery_device_{"u_battery_time"},
      vacuum_device_{"u_vacuum_time"}, leak_device_{"c_leakdetect_time"};
  bool altimeter_needed_ = false;  ///< by the leg of the last cycle
  SamplePeriods sample_periods_;
  uint32_t sampling_ = 0;
  hooks::Hull hull_;
  std::unique_ptr<LayeredControl> layers_;
  DynamicControl dynamics_;
  Journal& journal_;
  double cycle_s_;         ///< the platform's
  double cycle_at_s_ = 0;  ///< when the newest cycle began
  double took_s_ = 0;      ///< since the one before

  uint32_t cycles_ = 0;
  double last_depth_ = 0, depth_rate_ = 0;                  ///< as computed by the vehicle itself
  double pressed_s_ = 0;                                    ///< when the pressure was last read
  double contact_s_ = 0, tickled_s_ = 0, submerged_s_ = 0;  ///< when last; of the mission
  double mission_start_s_ = 0;
  std::optional<Geography> geography_;  ///< of the place where the mission started
  Planar origin_;                       ///< that place, from where the flight started
  double inflections_ = 0, last_moving_ = 0;
  bool has_fix_ = false, commanded_whole_ = true;
  Abort abort_ = Abort::None;
  ObeyedInstruction obeyed_;
  double obeyed_sequence_ = std::numeric_limits<double>::quiet_NaN();
  double waypoint_latitude_ddmm_ = std::numeric_limits<double>::quiet_NaN();
  double waypoint_longitude_ddmm_ = std::numeric_limits<double>::quiet_NaN();
  int layer_ = kNoLayer;
  bool sbc_gone_ = false;
  std::optional<News> end_;
};

}  // namespace glider::simulator
