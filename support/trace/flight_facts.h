// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace glider::support {

/// A position that the mission names; degrees, north and east positive.
struct NamedPlace {
  std::string name;
  double latitude_deg = 0, longitude_deg = 0;
};

/// A condition of the mission compares the distance to the centre with the radius.
struct WatchCircle {
  double latitude_deg = 0, longitude_deg = 0;  ///< of the centre
  double radius_m = 0;
};

/// A column with a value of a `log` statement.
struct LoggedValue {
  std::string column;
  std::string text;       ///< of the statement
  std::string value;      ///< the expression as it is written
  std::string half = {};  ///< what it is of a position: "latitude", "longitude"; otherwise empty
};

/// Undecided: the flight was too short to show it.
enum class Verdict : uint8_t { Held, Violated, NotChecked, Undecided };

/// A requirement or an assumption of the mission, and what this flight did.
struct FlownPromise {
  std::string text;  ///< as it is written, on one line
  Verdict verdict = Verdict::Held;
  std::optional<double> vehicle_time_s;  ///< of the violation, or after which it was not checked
  std::string words;                     ///< how it was violated, or why that is not known
};

/// What a device took from the batteries in a flight.
struct Consumer {
  std::string device;
  double used_Wh = 0;
};

/// What the text of a mission says about its flight.
struct MissionFacts {
  std::vector<std::string> listed;  ///< the sensors of its `sensors` lists, by the vehicle's names
  std::vector<std::string> read;    ///< those that its conditions read, those of cases first
  std::vector<NamedPlace> places;
  std::vector<WatchCircle> watch_circles;
  std::vector<LoggedValue> logged;
  std::vector<FlownPromise> promises;
  /// What its flights take at most until they end, by device, the greatest first; empty: there is
  /// no bound.
  std::vector<Consumer> at_most;
};

/// The batteries at the start of a flight, and what they gave in it.
struct BatteryFacts {
  double capacity_Wh = 0;
  double used_Wh = 0;  ///< of a full pack
  /// What each device took in the flight, in the order of the power table; only those that took
  /// some.
  std::vector<Consumer> consumers = {};
  /// Whether the SBC takes less while it sleeps than while it does not.
  bool sleep_saves = true;
};

/// What the acoustic modem of a vehicle did in its flight.
struct AcousticTotals {
  uint32_t sent = 0;      ///< frames
  uint32_t received = 0;  ///< frames for this vehicle, or for all
  uint32_t lost = 0;      ///< the same, within range, that were not received
  double on_air_s = 0;    ///< how long it was sending
  double sent_J = 0;
  double received_J = 0;  ///< of all frames that it listened to
  double listen_J = 0;
};

/// Depths of the bottom on a grid around the flight; m, east and north of the start.
struct BottomGrid {
  std::vector<double> x_m, y_m;
  std::vector<double> depths_m;  ///< x × y, y fastest
};

}  // namespace glider::support
