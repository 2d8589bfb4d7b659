// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "tests/differential/records.h"

#include <span>
#include <string>

namespace glider::differential {

/// Compiles the missions of `trials` for `board` at `level` into one program with the runtime's
/// core, runs it (in the board's emulator) over their streams and compares each tick with ir/eval.
/// Empty if all agree; else the first difference, with what is needed to see it again.
std::string judge(std::span<const Trial> trials, const std::string& board, int level);

}  // namespace glider::differential
