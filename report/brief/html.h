// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The text of a web page; everything is escaped here, and only here.
namespace glider::report::html {

/// `text` as it is.
std::string raw(std::string_view text);
/// `text` with what is in backticks as code.
std::string words(std::string_view text);
/// `text` as code; empty if it is empty.
std::string cell(std::string_view text);
/// A table; heads and cells are HTML. Columns that are empty in all rows are left out.
std::string table(const std::vector<std::string>& heads,
                  const std::vector<std::vector<std::string>>& rows);

}  // namespace glider::report::html
