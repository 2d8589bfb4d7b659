// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"

#include <variant>

namespace glider::frontend {

/// The only item of a kind that a mission may have at most once; null if it has none. If there are
/// several, it is the first, and `again(item, first)` reports each of the others.
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
