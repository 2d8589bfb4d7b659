// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>

namespace glider::support {

/// A part of a mission's text on one line: without comments, with each run of white space as one
/// space, and `printable`.
std::string onOneLine(std::string_view text);

/// The condition of a case on one line; of one that is always true, that it has none.
std::string conditionOnOneLine(std::string_view text);

/// `text` made safe for a terminal: a tab becomes one space, other control characters become '?'.
/// As long as `text`.
std::string printable(std::string_view text);

}  // namespace glider::support
