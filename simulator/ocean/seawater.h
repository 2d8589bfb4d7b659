// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::simulator {

/// The conductivity (S/m) of water of a practical salinity (PSS-78), temperature (degC, ITS-90) and
/// pressure (dbar): the inverse of what a mission calls `salinity`.
double conductivityOf(double salinity, double temperature_degC, double dbar);

}  // namespace glider::simulator
