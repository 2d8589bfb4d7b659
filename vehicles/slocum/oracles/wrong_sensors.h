// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "simulator/faults/faults.h"
#include "vehicles/slocum/oracles/names.h"

#include <initializer_list>
#include <string_view>

namespace glider::slocum::oracles {

/// True if a fault of one of these sensors has effect at `now_s`, or had it in the `fades_s`
/// before.
bool isWrong(const Faults& faults, std::initializer_list<std::string_view> sensors, double now_s,
             double fades_s);

/// Whether one of these is reported in few cycles only, by a fault that leaves some.
bool isSeldom(const Faults& faults, std::initializer_list<std::string_view> sensors, double now_s,
              double fades_s);

/// The same as isWrong of any sensor.
bool anyWrong(const Faults& faults, double now_s, double fades_s);

}  // namespace glider::slocum::oracles
