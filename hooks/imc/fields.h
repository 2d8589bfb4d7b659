// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/text.h"

#include <stdint.h>

/// What the fields of a message are: the types that messages.def names. No heap.
namespace glider::hooks::imc {

using U8 = uint8_t;
using U16 = uint16_t;
using U32 = uint32_t;
using I16 = int16_t;
using I32 = int32_t;
using F32 = float;
using F64 = double;

/// In place of the id of a message: there is none.
inline constexpr uint16_t kNoMessage = 65535;

using hooks::Text;
using hooks::textOf;

/// A message within another, or none. One of another kind there makes the whole unreadable.
template <typename Message>
struct Maybe {
  bool present = false;
  Message value{};
};

/// Any message within another, or none. A message within another has no length, so one that cannot
/// be read hides all that follows it: the fields behind it then have their defaults.
template <typename Message>
struct AnyMessage {
  uint16_t id = kNoMessage;  ///< of what was there, also if it could not be read; not encoded
  bool present = false;      ///< it is a Message, and was read as a whole
  Message value{};
};

/// A list of messages with at most one, of this kind. With more the whole is unreadable.
template <typename Message>
struct AtMostOne {
  bool present = false;
  Message value{};
};

/// A list without elements. With any the whole is unreadable.
struct EmptyList {};

}  // namespace glider::hooks::imc
