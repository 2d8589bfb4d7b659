// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "driver/json_document.h"
#include "logs/render.h"

namespace glider::driver {

/// An entry of a mission's log: the columns of its CSV as members, its values as an object each.
Json entryOf(const logs::LogEntry& entry);
/// How much of the log was damaged.
Json damageOf(const logs::LogDamage& damage);

}  // namespace glider::driver
