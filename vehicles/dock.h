// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/transport/byte_stream.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// A check of the serial line between the SBC and a vehicle, with one of the two at its other end:
/// what such a check needs of this computer, and what it finds. Each family of vehicles has its own
/// check.
namespace glider::vehicles {

/// What this computer plays.
enum class DockPart : uint8_t {
  Auto,     ///< what the other end does not: it is found by listening
  Vehicle,  ///< an SBC is at the other end
  Sbc,      ///< the vehicle is at the other end
};

enum class DockVerdict : uint8_t { Good, NotGood, NotChecked };

/// A line of the check-list.
struct DockCheck {
  std::string id;  ///< "answers": for programs
  std::string what;
  std::string measured;
  DockVerdict verdict = DockVerdict::NotChecked;
  std::string todo;  ///< empty if there is nothing to do
};

/// How it ended.
enum class DockEnd : uint8_t {
  Complete,
  Interrupted,  ///< DockHost::stop
  LineGone,     ///< the device was unplugged, or failed
};

struct DockResult {
  DockPart played = DockPart::Auto;  ///< Auto: no one was found
  DockEnd end = DockEnd::Complete;
  double seconds = 0;
  bool has_begun = false;  ///< the program on the SBC flies its mission, for the played vehicle
  std::vector<DockCheck> checks;
  std::vector<std::pair<std::string, double>> numbers;  ///< counts and times by name, for programs
};

/// What a check has of this computer.
struct DockHost {
  GliderByteStream line;
  std::string device;  ///< its name
  uint32_t baud = 0;   ///< at which the line was opened
  /// Bytes that the device has counted as lost or damaged since it was plugged in; empty: it does
  /// not count.
  struct DeviceErrors {
    uint32_t overruns = 0, framing = 0;
  };
  std::function<std::optional<DeviceErrors>()> errors;
  std::function<double()> now;  ///< of a clock that is never set back, s
  std::function<void(double)> sleep;
  std::function<bool()> stop;  ///< true: end now, and report what is known
  std::function<void(const std::string&)> progress;
  /// Whether the user agrees to write to a vehicle what `text` says. Empty: nothing is written.
  std::function<bool(const std::string& text)> confirm;
};

}  // namespace glider::vehicles
