// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"

#include <variant>

namespace glider::frontend {

/// The item of a kind of which a mission has one at most; null if it has none. Of several it is the
/// first, and `again(item, first)` reports each of the others.
template <typename Item, typename Again>
const Item* onlyItem(const ast::File& file, Again again) {
  const Item* first = nullptr;
  for (const ast::Item& any : file.items) {
    const auto* item = std::get_if<Item>(&any);
    if (item != nullptr && first != nullptr) {
      again(*item, *first);
    } else if (item != nullptr) {
      first = item;
    }
  }
  return first;
}

}  // namespace glider::frontend
