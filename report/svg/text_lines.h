// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glider::report {

/// How many characters `text` (UTF-8) is wide in a font of equal widths.
size_t columnsOf(std::string_view text);

/// `text` on at most `most_lines` lines of at most `columns` characters: broken at blanks, if it
/// can be after `&&`, `||` or a comma. What is left out at the end shows as `…`.
std::vector<std::string> wrap(std::string_view text, size_t columns, size_t most_lines);

/// `text` as it stands in XML, between tags or in an attribute; characters that XML lacks, and
/// bytes that are no UTF-8, become `?`.
std::string toXml(std::string_view text);

}  // namespace glider::report
