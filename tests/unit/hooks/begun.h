// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

namespace glider::hooks {

/// A part of hookbeh as its init function leaves it: begun(hookCadenceInit), or
/// begun(hookUnseenSinkInit, &kHull).
template <typename Part, typename... Needs, typename... Given>
Part begun(void (*init)(Part*, Needs...), Given... given) {
  Part part;
  init(&part, given...);
  return part;
}

/// The address of a value that C takes by pointer; it is there until the end of the statement.
template <typename Value>
const Value* given(const Value& value) {
  return &value;
}

}  // namespace glider::hooks
