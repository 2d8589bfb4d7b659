// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <chrono>

/// How long the end of a campaign may take.
namespace glider::campaign {

/// After a flight has hung: for the others to come to their end.
inline constexpr std::chrono::seconds kToLand{1};
/// For flights that must stop, which they do within a cycle.
inline constexpr std::chrono::seconds kToStop{10};
/// For the other ranks after a signal: mpirun ends this process by force a second after it.
inline constexpr std::chrono::milliseconds kToStopRanks{400};

}  // namespace glider::campaign
