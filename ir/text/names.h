// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/text/cursor.h"
#include "support/diagnostics/ids/ir_text.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace glider::ir::text {

/// The objects of one kind that a text has named, with their numbers.
class Names {
 public:
  /// `what` is the kind, for messages: "sensor".
  Names(Cursor& in, std::string_view what) : in_(in), what_(what) {}

  /// Gives number `index` the name `name`; a second definition is an error.
  void define(const Token& name, size_t index) {
    if (!numbers_.emplace(name.text, static_cast<uint32_t>(index)).second) {
      in_.fail(support::diagnostics::irDefinedTwice, name.range, what_, name.text);
    }
  }

  /// The number with the name `name`; UINT32_MAX after an error if there is none.
  uint32_t find(const Token& name) {
    auto found = numbers_.find(name.text);
    if (found != numbers_.end()) {
      return found->second;
    }
    in_.fail(support::diagnostics::irUnknownName, name.range, what_, name.text);
    return UINT32_MAX;
  }

 private:
  Cursor& in_;
  std::string_view what_;
  std::unordered_map<std::string, uint32_t> numbers_;
};

}  // namespace glider::ir::text
