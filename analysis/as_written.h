// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Statements as the pilot wrote them: in the IR a loop is written out, and one `set` of an array
/// may be a choice among many.
namespace glider::analysis {

/// A `for` of a mission's text.
struct WrittenLoop {
  support::SourceRange whole;
  support::SourceRange header;  ///< `for i in 0 .. 7`
};
/// Those of a mission and its libraries, an outer one before those in it; none for null.
std::vector<WrittenLoop> loopsOf(const compiler::Parsed* parsed);

/// Whether one range lies in the other.
bool isIn(const support::SourceRange& inner, const support::SourceRange& outer);

/// `set recent[n] = temp`
struct WrittenSet {
  std::string target;
  std::string value;
};
/// The parts of a statement that is a `set`; empty for any other text.
std::optional<WrittenSet> asSet(std::string_view statement);

/// Whether the text of a statement is a `push`.
bool isPush(std::string_view statement);

}  // namespace glider::analysis
