// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/parse/outline.h"

#include <cstdint>
#include <optional>

namespace glider::frontend {

/// What a name immediately after token type `keyword`, which comes after `before`, refers to.
std::optional<Naming> namingAfter(uint32_t keyword, uint32_t before);

/// What token type `t` between `before` and `next` refers to in an expression or statement; none if
/// it is not a name there.
std::optional<Naming> valueNaming(uint32_t before, uint32_t t, uint32_t next);

}  // namespace glider::frontend
