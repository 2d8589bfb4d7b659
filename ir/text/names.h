// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/text/cursor.h"

#include <string>
#include <string_view>
#include <unordered_map>

namespace glider::ir::text {

/// The things of one kind that a text has named, with their numbers.
class Names {
 public:
  /// `what` is the kind, for messages: "sensor".
  Names(Cursor& in, std::string_view what) : in_(in), what_(what) {}

  /// `name` stands for number `index` from now on; a second time is a mistake.
  void define(const Token& name, size_t index) {
    if (!numbers_.emplace(name.text, static_cast<uint32_t>(index)).second) {
      in_.fail(support::DiagnosticId::irDefinedTwice, name.range, what_, name.text);
    }
  }

  /// The number that `name` stands for; UINT32_MAX after the mistake that it stands for none.
  uint32_t find(const Token& name) {
    auto found = numbers_.find(name.text);
    if (found != numbers_.end()) {
      return found->second;
    }
    in_.fail(support::DiagnosticId::irUnknownName, name.range, what_, name.text);
    return UINT32_MAX;
  }

 private:
  Cursor& in_;
  std::string_view what_;
  std::unordered_map<std::string, uint32_t> numbers_;
};

}  // namespace glider::ir::text
