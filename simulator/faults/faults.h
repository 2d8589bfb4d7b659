// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace glider::simulator {

inline constexpr double kForever = std::numeric_limits<double>::infinity();

/// A time of the flight, s; without an end if `to_s` is infinite.
struct Span {
  double from_s = 0;
  double to_s = kForever;
  [[nodiscard]] bool has(double now_s) const { return now_s >= from_s && now_s < to_s; }
};

/// The directions of the serial lines, seen from the science computer: of the line to the SBC
/// (115200 baud) and of the flight-science link (9600 baud), the vehicle's own.
enum class LineWay : uint8_t { ToSbc, FromSbc, ToFlight, FromFlight };

/// What a line does to its bytes for some time. Shares are from 0 to 1.
struct LineFault {
  LineWay way = LineWay::ToSbc;
  Span when = {};
  bool cut = false;          ///< nothing gets through
  double loss = 0;           ///< share of bytes that vanish
  double flips = 0;          ///< share of bytes in which one bit is flipped
  double bursts = 0;         ///< share of bytes at which a burst of noise begins
  double burst_bytes = 20;   ///< length of a burst, in bytes
  double delay_s = 0;        ///< bytes arrive this much later
  double doubled = 0;        ///< share of frames that arrive twice
  double replayed = 0;       ///< share of frames after which an earlier one is repeated
  double heard_at_baud = 0;  ///< the receiver runs at this speed; 0: at the right one
};

/// What a sensor reports for some time instead of the truth.
struct SensorFault {
  enum class Kind : uint8_t { Frozen, Value, Missing, Drift, Scale, Jumps, Offset, Sways };
  std::string name;  ///< the vehicle's
  uint16_t id = 0;   ///< in the platform; set when the flight begins
  Span when = {};
  Kind kind = Kind::Frozen;
  /// Value: what it reports, may be NaN; Drift: how much is added per second; Scale: the factor by
  /// which it is multiplied; Jumps: the greatest jump of a reading in either direction; Offset: how
  /// much is added; Sways: the amplitude of a sine that is added. In the sensor's unit.
  double value = 0;
  double period_s = 120;  ///< Sways: of the sine, which begins at 0 when the fault does
  double share = 1;       ///< Value, Jumps, Missing: share of readings that are wrong in this way
};

/// The SBC's own clock jumps.
struct ClockJump {
  double at_s = 0;
  double by_s = 0;
};

/// What happens to the SBC's checkpoints on its storage card.
struct CardFault {
  enum class Kind : uint8_t { Flips, Cut, Zeroed };
  double at_s = 0;
  Kind kind = Kind::Flips;
  /// Flips: this many bits are flipped, at random. Cut: this share of the file remains. Zeroed:
  /// this share of its blocks of 4096 bytes, at random, reads zero.
  double amount = 0;
};

/// The flight controller restarts its mission, from the first second.
struct FlightRestart {
  Span when = {};            ///< it does nothing meanwhile; the motors stay at their last commands
  bool keeps_array = false;  ///< a new mission without a restart: the sensor array stays as it was
};

/// An instruction left in the sensor array by an earlier mission, as if it had been written
/// completely: take control and descend.
struct Leftover {
  uint32_t session = 1;
  uint16_t sequence = 1;
  double depth_m = 20;
};

/// All faults of a flight. Empty: there are none.
struct Faults {
  std::vector<LineFault> lines;
  std::vector<SensorFault> sensors;
  std::vector<Span> power;    ///< the SBC has no power; afterwards its program restarts
  std::vector<Span> port;     ///< the SBC's serial port is missing
  std::vector<Span> stuck;    ///< the SBC answers, but its mission does not advance
  std::vector<Span> modem;    ///< noise in the water hides all that arrives at its modem
  std::vector<Span> science;  ///< the science computer restarts during this time
  /// An operator has a console on the science computer: nothing crosses the flight-science link.
  std::vector<Span> console;
  std::vector<ClockJump> clock;
  std::vector<double> aborts;  ///< the flight controller aborts its mission at these times
  std::vector<CardFault> card;
  std::vector<FlightRestart> flight;
  std::vector<Leftover> leftover;  ///< at the start; the last one counts

  [[nodiscard]] bool empty() const;
  /// When the first of them begins; infinite without any.
  [[nodiscard]] double first() const;
  /// When the last of those that end is over; 0 without any.
  [[nodiscard]] double lastEnd() const;
  /// When the last of all is over; infinite if one does not end, 0 without any.
  [[nodiscard]] double over() const;
  /// Adds the faults of `more`.
  void add(const Faults& more);
};

}  // namespace glider::simulator
