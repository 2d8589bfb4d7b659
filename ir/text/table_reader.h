// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/text/cursor.h"
#include "ir/text/names.h"

namespace glider::ir::text {

/// What follows the word `table`, up to and including its `end`.
GuardTable readTable(Cursor& in, Names& sensors);

}  // namespace glider::ir::text
