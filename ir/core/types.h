// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "support/units/units.h"

/// The types by their names.
namespace glider::ir {

constexpr Type quantity(support::Dimension dimension) {
  return {TypeKind::Quantity, dimension};
}
constexpr Type plainNumber() {
  return quantity(support::dimension::number);
}
constexpr Type boolean() {
  return {TypeKind::Bool, {}};
}
constexpr Type latitude() {
  return {TypeKind::Latitude, {}};
}
constexpr Type longitude() {
  return {TypeKind::Longitude, {}};
}

}  // namespace glider::ir
