// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "vehicles/dock.h"
#include "vehicles/slocum/dock/dock_run.h"
#include "vehicles/slocum/dock/sbc_record.h"
#include "vehicles/slocum/dock/vehicle_record.h"

#include <string>
#include <vector>

// The lines of the check-list, from what was recorded.

namespace glider::slocum {

/// With start and stop bit.
inline constexpr double kBitsOfByte = 10;

vehicles::DockCheck good(std::string id, std::string what, std::string measured);
vehicles::DockCheck notGood(std::string id, std::string what, std::string measured,
                            std::string todo);
vehicles::DockCheck notChecked(std::string id, std::string what, std::string why,
                               std::string todo = "");

/// "1 sentence", "2 sentences".
std::string counted(uint64_t count, const std::string& noun);

/// "35 ms", "1.20 s".
std::string timeText(double seconds);

/// Whether the list of sensors that the vehicle is given is that of the program.
vehicles::DockCheck listFinding(const DockSetup& setup);
/// Whether the line is open at the baud rate of that list.
vehicles::DockCheck baudFinding(const DockSetup& setup, uint32_t baud);
/// Whether what arrives is whole.
vehicles::DockCheck lineFinding(const DockLine& line);
/// How much of the line `most_bytes` in a control cycle of `cycle_s` need; `text` says what was
/// counted.
vehicles::DockCheck loadFinding(uint32_t baud, double most_bytes, double cycle_s,
                                const std::string& text);
/// What the device has counted from `before` to `after`.
vehicles::DockCheck deviceFinding(const vehicles::DockHost::DeviceErrors& before,
                                  const vehicles::DockHost::DeviceErrors& after);
/// The device went away.
vehicles::DockCheck goneFinding(double now_s);
/// Nothing that can be understood came in `seconds`, although this computer played `part`.
vehicles::DockCheck nobodyFinding(const DockRun& run, vehicles::DockPart part, double seconds);
/// The other end is what this computer plays.
vehicles::DockCheck sameSideFinding(vehicles::DockPart part);

/// What an SBC did; the control cycle is `cycle_s` of real time.
std::vector<vehicles::DockCheck> sbcFindings(const DockSetup& setup, const DockLine& line,
                                             uint32_t baud, const SbcRecord& record);
/// What a vehicle did in `seconds`.
std::vector<vehicles::DockCheck> vehicleFindings(const DockSetup& setup, const DockLine& line,
                                                 uint32_t baud, double seconds,
                                                 const VehicleRecord& record);

}  // namespace glider::slocum
