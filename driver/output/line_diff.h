// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::driver {

/// What changes `before` to `after`, line by line, in the unified form that `patch` reads; empty if
/// they are equal. Texts that differ in very many lines are shown as one change.
std::string lineDiff(std::string_view name, std::string_view before, std::string_view after);

}  // namespace glider::driver
