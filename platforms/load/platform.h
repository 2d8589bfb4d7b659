// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/instrument.h"
#include "platforms/load/modem.h"
#include "platforms/load/power.h"
#include "platforms/load/propeller_motion.h"
#include "support/units/units.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::platforms {

enum class Computer : uint8_t { Flight, Science };

/// How missions see a sensor's value.
enum class SensorKind : uint8_t { Quantity, Latitude, Longitude };

struct PlatformSensor {
  uint16_t id = 0;    ///< index in the file: the number on the wire
  std::string name;   ///< the vehicle's own: "m_depth"
  std::string alias;  ///< the language's: "depth"; empty if it has none
  std::string unit;   ///< as in the file
  SensorKind kind = SensorKind::Quantity;
  support::Dimension dimension;  ///< of a Quantity
  double to_si = 1;              ///< factor from the vehicle's unit
  double lowest = 0;             ///< plausible range, in the vehicle's unit
  double highest = 0;
  double stale_after_s = 0;
  double every_s = 0;    ///< the shortest time between two reports to the SBC
  double dead_band = 0;  ///< a change of at most this size is not sent; in the vehicle's unit
  Computer computer = Computer::Flight;
  bool magnetic = false;  ///< a heading from magnetic north; missions see it from true north
  double noise = 0;    ///< two readings of the same water may differ by this, in the vehicle's unit
  std::string source;  ///< where the front seat reads it, in its own words; empty: by its name
  std::string role;   ///< of hooks/protocol/roles.def; empty: the role of its name, if there is one
  uint8_t bytes = 4;  ///< width in the sensor array: 1 (int8), 4 (float32) or 8 (float64)
  std::string what;   ///< one line of explanation
  bool counts = false;  ///< it has whole values, compared exactly; so has every sensor of one byte
  std::vector<std::string> states;  ///< conditions of the language: [i] is true at the value i
};

struct Envelope {
  double greatest_depth_m = 0;
  double steepest_pitch_rad = 0;
  double shallowest_pitch_rad = 0;    ///< a dive or climb at a smaller pitch is refused
  double vertical_rate_m_s = 0;       ///< the fastest it sinks or climbs
  double inflection_overshoot_m = 0;  ///< how far it goes past a target depth while it turns
  /// The same at more than `overshoot_pitch_rad`; 0: no more than at any other pitch.
  double steep_overshoot_m = 0;
  double overshoot_pitch_rad = 0;
  double drift_m_s = 0;   ///< the strongest current that missions account for
  double pump_cc = 0;     ///< of the buoyancy pump, in either direction; 0: missions have none
  double fin_rad = 0;     ///< of the fin, to either side; 0: missions have no fin
  double battery_in = 0;  ///< of the pitch battery, to either side; 0: missions have none
  double cycle_s = 0;     ///< of the flight controller
  // What a command to go to a depth also says: of a vehicle that glides its pitch, of one with a
  // propeller its speed. The usual one is taken where a mission names none; 0: there is none.
  double usual_pitch_rad = 0;
  double usual_speed_m_s = 0;
  double slowest_m_s = 0;  ///< through the water, under command
  double fastest_m_s = 0;  ///< 0: it takes no speed

  /// Whether it takes a speed, not a pitch.
  [[nodiscard]] bool steersBySpeed() const { return fastest_m_s > 0; }
};

/// What proofs assume about the vehicle and the water, in addition to the envelope and the sensors'
/// ranges.
struct EnvironmentModel {
  double start_depth_m = 0;      ///< the greatest depth when the mission gets control
  double surface_depth_m = 0;    ///< down to this depth the vehicle is at the surface
  double slowest_climb_m_s = 0;  ///< the slowest vertical speed of a climb
  double turn_s = 0;             ///< from obeying the command to climb until it climbs
  /// How much later than over the vehicle's line (line_lag_s and a cycle) a command is obeyed.
  double command_delay_s = 0;
  double climb_hold_m = 0;       ///< how far below the end of a climb it may sink to hold it
  double depth_error_m = 0;      ///< the greatest error of a depth reading
  double tick_gap_s = 0;         ///< the longest time between two ticks of a mission
  double through_water_m_s = 0;  ///< the greatest horizontal speed through the water
  double steering_error_m = 0;   ///< the farthest that turning takes it off the straight course
  double surface_drift_m_s = 0;  ///< the fastest drift at the surface by current, wind and waves
  double line_lag_s = 0;         ///< the longest that a value needs between the vehicle's computers
};

/// The steady flight of a winged hull (simulator/vehicle/flight_model.h has its formulas).
struct FlightCoefficients {
  double mass_kg = 0;
  double hull_volume_m3 = 0;  ///< not the platform's: neutral in the water of a scenario
  double reference_area_m2 = 0;
  double drag = 0;          ///< C_D0
  double induced_drag = 0;  ///< C_D1, rad^-2
  double wing_lift = 0;     ///< a_w, rad^-1
  double hull_lift = 0;     ///< a_h, rad^-1
  double compressibility_per_pa = 0;
};

/// How the vehicle moves, for the simulator. Signs: pump positive outwards, battery positive
/// forward, pitch nose up, fin positive to turn to starboard.
struct Motion {
  std::string model;  ///< which of the simulator's models flies it: "glider", "propeller"
  /// Of the model "propeller", which uses nothing else of this; empty for any other.
  std::optional<PropellerMotion> propelled;
  // The motors: their range on either side of the middle, and their rate.
  double pump_rate_cc_s = 0;  ///< its range is Envelope::pump_cc
  double pitch_battery_limit_in = 0;
  double pitch_battery_rate_in_s = 0;
  double fin_rate_rad_s = 0;  ///< its range is Envelope::fin_rad
  // Trim: tan pitch = trim_pump V - trim_battery x + trim_offset; V in m3, x in m.
  double trim_pump_per_m3 = 0;
  double trim_battery_per_m = 0;
  double trim_offset = 0;
  double pitch_lag_s = 0;  ///< the hull's swing after weight and volume have moved
  // Yaw: yaw_lag dr/dt = yaw_gain sin(fin) U^2 - r.
  double yaw_gain_rad_s_m2 = 0;
  double yaw_lag_s = 0;
  double speed_lag_s = 0;  ///< of mass and added mass against the drag
  FlightCoefficients flight;
};

/// The sensor for magnetic minus true heading; a vehicle may lack it.
inline constexpr std::string_view kVariationSensor = "m_gps_mag_var";

/// A vehicle as data: platforms/<name>.toml.
struct Platform {
  std::string name;
  std::string description;
  std::string family;  ///< of vehicles/vehicles.def, whose code flies it; may be empty
  /// Ways from the SBC to the vehicle, by the names of `build --dialect`: the first is the usual
  /// one.
  std::vector<std::string> front_seats;
  Envelope envelope;
  EnvironmentModel world;
  std::optional<Motion> motion;  ///< empty: missions for it can be checked and built, not simulated
  Power power;                   ///< means something with `motion`
  std::optional<Modem> modem;    ///< empty: the vehicle has none
  std::vector<PlatformSensor> sensors;  ///< sensors[i].id == i
  std::vector<Instrument> instruments;  ///< those that missions switch

  /// Whether the SBC's own program answers its frames of the hook protocol: the vehicle has
  /// neither of the hooks, and another port.
  [[nodiscard]] bool seatIsOnBoard() const;
  /// The sensor called `name` by the vehicle or by the language; null if there is none.
  [[nodiscard]] const PlatformSensor* find(std::string_view name) const;
};

}  // namespace glider::platforms
