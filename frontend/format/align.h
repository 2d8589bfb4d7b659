// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <cstddef>
#include <string>
#include <vector>

/// Aligns similar parts of neighbouring lines.
namespace glider::frontend::formatting {

/// A line of the result.
struct Row {
  std::string text;           ///< with its indent
  std::string remark;         ///< a comment at its end
  bool blank_before = false;  ///< there is a blank line before it
  std::string shape;          ///< neighbours of one shape are aligned; "" for none
  std::vector<size_t> cells;  ///< the bytes of `text` where its parts begin
};

/// Aligns the parts, then the remarks, of neighbouring rows, except where a line would become too
/// long.
void align(std::vector<Row>& rows);

}  // namespace glider::frontend::formatting
