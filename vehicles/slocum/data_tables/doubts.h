// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "vehicles/slocum/data_tables/log_files.h"

#include <span>
#include <vector>

namespace glider::slocum {

/// Marks the records of one vehicle's files whose time cannot be right (LogFile::left_out): before
/// 2000, after 2100, or more than 60 days from the middle one of the file. Adds warnings (GL5212).
/// If no record of the vehicle is of this century, its clock was never set: all are kept.
void leaveOutTimes(std::span<LogFile> files, std::vector<support::Failure>& warnings);

/// Marks the GPS fixes of one vehicle's files that cannot be right (LogFile::wild_fixes): those
/// that no vehicle can have moved to from most of the fixes and dead-reckoned positions around
/// them. Adds warnings (GL5213).
void leaveOutFixes(std::span<LogFile> files, std::vector<support::Failure>& warnings);

/// Warns of the sensors of one vehicle whose unit differs between its files (GL5211).
void warnOfUnits(std::span<const LogFile> files, std::vector<support::Failure>& warnings);

}  // namespace glider::slocum
