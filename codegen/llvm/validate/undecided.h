// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <stdexcept>
#include <string>

namespace glider::codegen::validate {

/// Thrown where the meaning of code is not understood: what is being compared stays undecided. It
/// never leaves this folder. `what` says what was met: "a loop".
class Undecided : public std::runtime_error {
 public:
  explicit Undecided(const std::string& what) : std::runtime_error(what) {}
};

}  // namespace glider::codegen::validate
