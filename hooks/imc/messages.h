// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/fields.h"

namespace glider::hooks::imc {

// A struct for each message of messages.def, with its id as kId.
#define MESSAGE(name, number) \
  struct name {               \
    static constexpr uint16_t kId = number;
#define FIELD(type, name) type name{};
#define MESSAGE_END \
  }                 \
  ;
#include "hooks/imc/messages.def"

/// Goes through the fields of a message in their order: FieldsOf<Message>::each(visitor, message)
/// calls visitor.take(field) for each.
template <typename Message>
struct FieldsOf;
#define MESSAGE(name, number)                     \
  template <>                                     \
  struct FieldsOf<name> {                         \
    template <typename Visitor, typename Message> \
    static void each([[maybe_unused]] Visitor& visitor, [[maybe_unused]] Message& of) {
#define FIELD(type, name) visitor.take(of.name);
#define MESSAGE_END \
  }                 \
  }                 \
  ;
#include "hooks/imc/messages.def"

}  // namespace glider::hooks::imc
