// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glider::report {

/// The width of `text` (UTF-8) in characters of a monospaced font.
size_t columnsOf(std::string_view text);

/// `text` on at most `most_lines` lines of at most `columns` characters: broken at spaces, if
/// possible after `&&`, `||` or a comma. Text that is left out at the end is shown as `…`.
std::vector<std::string> wrap(std::string_view text, size_t columns, size_t most_lines);

/// `text` escaped for XML, between tags or in an attribute; characters that XML does not have, and
/// bytes that are not valid UTF-8, become `?`.
std::string toXml(std::string_view text);

}  // namespace glider::report
