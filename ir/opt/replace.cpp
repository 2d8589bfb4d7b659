// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/opt/replace.h"

#include "ir/core/references.h"
#include "ir/opt/compact.h"

namespace glider::ir::opt {
namespace {

struct Replacement {
  const std::vector<ExprId>& by;

  void operator()(ExprId& id) const { id = by[id.index]; }
};

}  // namespace

void replace(Mission& mission, const std::vector<ExprId>& by) {
  const Replacement replacement{by};
  References(replacement).of(mission);
  compact(mission);
}

}  // namespace glider::ir::opt
