// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::runtime {

class Persistence;

/// What a part that not every program has reports after each tick. By a pointer, so that other
/// programs do not carry it.
struct AfterTick {
  void (*report)(void* self, Persistence& persistence) = nullptr;  ///< null: nothing
  void* self = nullptr;
};

}  // namespace glider::runtime
