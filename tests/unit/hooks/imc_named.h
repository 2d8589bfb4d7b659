// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/codec.h"
#include "tests/unit/hooks/imc_described.h"

#include <cstring>
#include <string>

/// The messages of hooks/imc as the second codec has them: values by the names of their fields.
namespace glider::imc_named {

using namespace hooks::imc;
using imc_described::Bytes;
using imc_described::Leaves;

template <typename Message>
struct NamedFields;
#define MESSAGE(name, number)                     \
  template <>                                     \
  struct NamedFields<name> {                      \
    template <typename Visitor, typename Message> \
    static void each([[maybe_unused]] Visitor& visitor, [[maybe_unused]] Message& of) {
#define FIELD(type, name) visitor.take(#name, of.name);
#define MESSAGE_END \
  }                 \
  }                 \
  ;
#include "hooks/imc/messages.def"

/// Calls `f` with an empty message of this id; false if there is none.
template <typename F>
bool withMessage(uint16_t id, F f) {
#define MESSAGE(name, number) \
  if (id == (number)) {       \
    f(name{});                \
    return true;              \
  }
#define FIELD(type, name)
#define MESSAGE_END
#include "hooks/imc/messages.def"
  return false;
}

/// Writes the values of a message into leaves.
struct Collector {
  Leaves* leaves;
  std::string path;

  template <typename Number>
  void take(const char* name, const Number& number) {
    uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof number);  // the boards and this machine are little-endian
    (*leaves)[path + name] = bits;
  }
  void take(const char* name, const Text& text) {
    (*leaves)[path + name] = std::string(text.bytes, text.size);
  }
  template <typename Message>
  void take(const char* name, const Maybe<Message>& inner) {
    takeInner(name, inner);
  }
  template <typename Message>
  void take(const char* name, const AnyMessage<Message>& inner) {
    takeInner(name, inner);
  }
  template <typename Message>
  void take(const char* name, const AtMostOne<Message>& inner) {
    takeInner(name, inner);
  }
  void take(const char*, const EmptyList&) {}

 private:
  template <typename Inner>
  void takeInner(const char* name, const Inner& inner) {
    (*leaves)[path + name + "?"] = uint64_t{inner.present};
    if (inner.present) {
      Collector within{leaves, path + name + "."};
      NamedFields<decltype(inner.value)>::each(within, inner.value);
    }
  }
};

/// Sets the fields of a message from leaves, which outlive its texts.
struct Filler {
  const Leaves& leaves;
  std::string path;

  template <typename Number>
  void take(const char* name, Number& number) {
    const uint64_t bits = std::get<uint64_t>(leaves.at(path + name));
    std::memcpy(&number, &bits, sizeof number);
  }
  void take(const char* name, Text& text) {
    const auto& value = std::get<std::string>(leaves.at(path + name));
    text = {value.data(), static_cast<uint16_t>(value.size())};
  }
  template <typename Message>
  void take(const char* name, Maybe<Message>& inner) {
    takeInner(name, inner);
  }
  template <typename Message>
  void take(const char* name, AnyMessage<Message>& inner) {
    takeInner(name, inner);
  }
  template <typename Message>
  void take(const char* name, AtMostOne<Message>& inner) {
    takeInner(name, inner);
  }
  void take(const char*, EmptyList&) {}

 private:
  template <typename Inner>
  void takeInner(const char* name, Inner& inner) {
    inner.present = std::get<uint64_t>(leaves.at(path + name + "?")) != 0;
    if (inner.present) {
      Filler within{leaves, path + name + "."};
      NamedFields<decltype(inner.value)>::each(within, inner.value);
    }
  }
};

template <typename Message>
Leaves leavesOfMessage(const Message& message) {
  Leaves leaves;
  Collector collector{&leaves, ""};
  NamedFields<Message>::each(collector, message);
  return leaves;
}

template <typename Message>
void fill(const Leaves& leaves, Message& message) {
  Filler filler{leaves, ""};
  NamedFields<Message>::each(filler, message);
}

/// The packet that encode writes; empty if it writes none.
template <typename Message>
Bytes encoded(const Header& header, const Message& message, uint32_t capacity = kMostPacket) {
  Bytes bytes(capacity);
  bytes.resize(encode(header, message, bytes.data(), capacity));
  return bytes;
}

/// A packet as the reader gives it, over these bytes of a payload.
inline Packet packetWith(uint16_t id, const Bytes& payload, ByteOrder order = ByteOrder::Little) {
  return {.id = id,
          .header = {},
          .order = order,
          .payload = payload.data(),
          .size = static_cast<uint32_t>(payload.size())};
}

}  // namespace glider::imc_named
