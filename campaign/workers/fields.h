// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// The parts of a message: texts that hold no zero byte.
namespace glider::campaign {

inline std::string joinFields(const std::vector<std::string>& fields) {
  std::string text;
  for (const std::string& field : fields) {
    text += field;
    text += '\0';
  }
  return text;
}

/// The reverse; missing ones are empty, so that there are `count`.
inline std::vector<std::string> splitFields(std::string_view text, size_t count) {
  std::vector<std::string> fields;
  for (size_t end = 0; (end = text.find('\0')) != std::string_view::npos;) {
    fields.emplace_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  fields.resize(count);
  return fields;
}

}  // namespace glider::campaign
