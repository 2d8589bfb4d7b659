// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/propeller_motion.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glider::platforms {

inline constexpr double kJoulesPerWattHour = 3600;

/// When a row of the power table draws.
enum class DrawWhen : uint8_t {
#define DRAW(name, ...) name,
#include "platforms/load/draws.def"
};
/// "always", as in the file.
std::string_view wordOf(DrawWhen when);
/// The reverse; empty: no word of the file.
std::optional<DrawWhen> drawWhenOf(std::string_view word);
/// `"always", "surface"`: all words.
std::string drawWords();
/// "W", "J" or "J/cc".
std::string_view unitOf(DrawWhen when);
/// "at the surface".
std::string_view describe(DrawWhen when);

/// A row of the power table: what a device draws in one of its modes.
struct Draw {
  std::string device;
  DrawWhen when = DrawWhen::Always;
  double amount = 0;                 ///< in unitOf(when)
  double amount_per_m = 0;           ///< of PumpOut: added for each metre of depth
  double spread = 0;                 ///< the share by which it may be wrong to either side
  std::string source;                ///< where the number is from
  std::vector<std::string> sensors;  ///< of Read: the vehicle's names of what the device measures
  /// Of Always and Read, of a device that is an instrument which missions switch: its place among
  /// them, and for how long it is on for a reading, s.
  std::optional<uint32_t> instrument = {};
  double reading_s = 0;
};

/// The share of the time for which an instrument of the table is on, for a code of
/// hooks/protocol/sampling.h; none: the code leaves it as the row says.
std::optional<double> shareOn(const Draw& draw, uint32_t code);

/// What bounds of the energy of a flight assume of a glider beyond the rows.
struct EnergyModel {
  /// Along its path, with the whole pump: a leg at a pitch p takes it no faster up or down, on
  /// average, than this times the sine of p and `pitch_off_deg` together.
  double glide_m_s = 0;
  double pitch_off_deg = 0;         ///< the pitch may be so far from what is commanded
  double hover_pump_cc_s = 0;       ///< what a hover pumps out on average, and as much in
  double hover_swell_cc_s = 0;      ///< how much more in a swell near the surface: hoverPump
  double pitch_battery_share = 0;   ///< of the time of a leg, while it moves
  double pitch_battery_turn_s = 0;  ///< the same for a turn between the steepest dive and climb
  double dive_start_s = 0;          ///< from the command to dive it stays so long at the surface
};

/// What a hover at `depth_m` or deeper pumps out on average, and as much in, cc/s: also in a swell
/// of kSwell_m and kSwell_s, in water that is kBelowDives_m deeper.
double hoverPump(const EnergyModel& model, double depth_m);
/// The greatest amplitude of a swell, m, and its longest period, s.
inline constexpr double kSwell_m = 3, kSwell_s = 20;
/// How far below the depths of a mission the bottom is at least, m: hookbeh turns no dive while it
/// is farther below the vehicle than `min_altitude` and what a vehicle that sinks needs.
inline constexpr double kBelowDives_m = 10;
/// How fast an internal wave moves the water up and down at most, m/s.
inline constexpr double kWaterMoves_m_s = 0.1;

/// The batteries and all that they feed.
struct Power {
  double capacity_kj = 1;
  double full_V = 1;   ///< without load
  double empty_V = 0;  ///< the same; between them the voltage falls linearly with what was used
  double resistance_ohm = 0;
  std::string board;  ///< the SBC whose power is counted; "": none
  std::vector<Draw> draws;
  PropellerPower propeller;           ///< drawn too; empty without one
  std::optional<EnergyModel> bounds;  ///< empty: the energy of flights has no bounds
};

// What has no row in the power table of a vehicle: its propeller, the SBC (its board's file), and
// the acoustic modem ([modem]).
inline constexpr std::string_view kPropellerDevice = "propeller";
inline constexpr std::string_view kSbcDevice = "SBC";
inline constexpr std::string_view kModemDevice = "acoustic modem";

/// What draws power, each once: those of the table in its order, then those above.
std::vector<std::string> devicesOf(const Power& power);
/// The place of `device`, which is one of them.
size_t placeOf(const Power& power, std::string_view device);

}  // namespace glider::platforms
