// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

/// A second codec of RECON: it follows a description of the lines as text, knows fields by name,
/// and shares nothing with hooks/recon.
namespace glider::recon_described {

/// A number, NaN if it is unknown, or a text.
struct Value {
  double number = 0;
  std::string text;
};
/// Each field of a message by its name.
using Values = std::map<std::string, Value>;

/// Whether each number of the one is that of the other, except for the rounding of a last digit.
bool isSame(const Values& one, const Values& other);
std::string shown(const Values& values);

/// The names of the messages that are described.
std::vector<std::string> described();

/// Values for all fields of a message that its line can hold without loss.
Values randomValues(const std::string& name, std::mt19937& random);

/// The whole line with its line feed.
std::string lineOf(const std::string& name, const Values& values);
/// Nothing if it is not exactly such a line.
std::optional<Values> valuesOf(const std::string& name, const std::string& line);

/// The line of any text from `#` to `*`.
std::string summed(const std::string& text);

}  // namespace glider::recon_described
