// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/imc/codec.h"

#include "hooks/imc/crc.h"
#include "hooks/protocol/bytes.h"

namespace glider::hooks::imc {
namespace {

constexpr uint32_t kPlaceOfSize = 4;

/// Appends fields to a packet.
class FieldWriter {
 public:
  explicit FieldWriter(HookByteWriter* out) : out_(out) {}

  void take(U8 value) { hookWriteU8(out_, value); }
  void take(U16 value) { hookWriteU16(out_, value); }
  void take(U32 value) { hookWriteU32(out_, value); }
  void take(I16 value) { hookWriteU16(out_, static_cast<uint16_t>(value)); }
  void take(I32 value) { hookWriteU32(out_, static_cast<uint32_t>(value)); }
  void take(F32 value) { hookWriteF32(out_, value); }
  void take(F64 value) { hookWriteF64(out_, value); }
  void take(const Text& text) {
    take(static_cast<U16>(text.size));  // a longer one is beyond kMostPayload
    for (uint32_t i = 0; i < text.size; ++i) {
      hookWriteU8(out_, static_cast<uint8_t>(text.bytes[i]));
    }
  }
  template <typename Message>
  void take(const Maybe<Message>& inner) {
    takeInner(inner.present, inner.value);
  }
  template <typename Message>
  void take(const AnyMessage<Message>& inner) {
    takeInner(inner.present, inner.value);
    // Without it this would be another message than the one that was decoded.
    if (!inner.present && inner.id != kNoMessage) {
      out_->fits = false;
    }
  }
  template <typename Message>
  void take(const AtMostOne<Message>& list) {
    take(static_cast<U16>(list.present ? 1 : 0));
    if (list.present) {
      takeInner(true, list.value);
    }
  }
  void take(const EmptyList&) { take(U16{0}); }

 private:
  template <typename Message>
  void takeInner(bool present, const Message& message) {
    take(present ? Message::kId : kNoMessage);
    if (present) {
      FieldsOf<Message>::each(*this, message);
    }
  }

  HookByteWriter* out_;
};

/// Reads the fields of a payload. From the first one on that is not there or cannot be read, they
/// stay as they are.
class FieldReader {
 public:
  explicit FieldReader(const Packet& packet)
      : payload_(packet.payload), size_(packet.size), order_(packet.order) {}

  template <typename Field>
  void take(Field& field) {
    if (good()) {
      read(field);
    }
  }
  /// True when each field was there and nothing is left over, except behind an AnyMessage.
  [[nodiscard]] bool complete() const { return end_ == End::Hidden || (good() && at_ == size_); }

 private:
  enum class End : uint8_t {
    None,
    Short,       ///< the payload ends within the fields
    Unreadable,  ///< a message or list that is not known here
    Hidden,      ///< the same, in an AnyMessage
  };

  [[nodiscard]] bool good() const { return end_ == End::None; }

  /// The next bytes; null if there are not so many.
  const uint8_t* bytes(uint32_t count) {
    if (size_ - at_ < count) {
      end_ = End::Short;
      return nullptr;
    }
    at_ += count;
    return payload_ + at_ - count;
  }
  uint64_t number(uint32_t width) {
    const uint8_t* const found = bytes(width);
    return found != nullptr ? numberAt(found, width, order_) : 0;
  }
  template <typename Number>
  void readWhole(Number& value) {
    value = static_cast<Number>(number(sizeof value));
  }

  void read(U8& value) { readWhole(value); }
  void read(U16& value) { readWhole(value); }
  void read(U32& value) { readWhole(value); }
  void read(I16& value) { readWhole(value); }
  void read(I32& value) { readWhole(value); }
  void read(F32& value) { value = hookFloatOf(static_cast<uint32_t>(number(sizeof value))); }
  void read(F64& value) { value = hookDoubleOf(number(sizeof value)); }
  void read(Text& text) {
    const auto size = static_cast<U16>(number(sizeof(U16)));
    const uint8_t* const found = bytes(size);
    if (good()) {
      text = {reinterpret_cast<const char*>(found), size};
    }
  }
  template <typename Message>
  void read(Maybe<Message>& inner) {
    const auto id = static_cast<uint16_t>(number(sizeof kNoMessage));
    inner.present = id != kNoMessage;
    if (inner.present) {
      readInner(id, inner.value);
    }
  }
  template <typename Message>
  void read(AnyMessage<Message>& inner) {
    inner.id = static_cast<uint16_t>(number(sizeof kNoMessage));
    if (inner.id == kNoMessage) {
      return;
    }
    readInner(inner.id, inner.value);
    inner.present = good();
    if (end_ == End::Unreadable) {
      end_ = End::Hidden;
      inner.value = {};
    }
  }
  template <typename Message>
  void read(AtMostOne<Message>& list) {
    const auto count = static_cast<uint16_t>(number(sizeof kNoMessage));
    list.present = count == 1;
    if (list.present) {
      readInner(static_cast<uint16_t>(number(sizeof kNoMessage)), list.value);
    } else if (count != 0) {
      end_ = End::Unreadable;
    }
  }
  void read(EmptyList&) {
    if (number(sizeof kNoMessage) != 0) {
      end_ = End::Unreadable;
    }
  }
  template <typename Message>
  void readInner(uint16_t id, Message& message) {
    if (!good()) {
      return;
    }
    if (id == Message::kId) {
      FieldsOf<Message>::each(*this, message);
    } else {
      end_ = End::Unreadable;
    }
  }

  const uint8_t* payload_;
  uint32_t size_;
  uint32_t at_ = 0;
  ByteOrder order_;
  End end_ = End::None;
};

void writeHeader(uint16_t id, const Header& header, HookByteWriter* out) {
  hookWriteU16(out, kSync);
  hookWriteU16(out, id);
  hookWriteU16(out, 0);  // the size, which is not known yet
  hookWriteF64(out, header.time_s);
  hookWriteU16(out, header.source);
  hookWriteU8(out, header.source_entity);
  hookWriteU16(out, header.destination);
  hookWriteU8(out, header.destination_entity);
}

/// Adds what depends on the payload. Returns the size of the packet.
uint32_t finish(HookByteWriter* out) {
  if (!out->fits) {
    return 0;
  }
  HookByteWriter size = hookWriterTo(out->bytes + kPlaceOfSize, sizeof(uint16_t));
  hookWriteU16(&size, out->size - kHeaderBytes);
  hookWriteU16(out, crc16Arc(out->bytes, out->size));
  return out->fits ? out->size : 0;
}

template <typename Message>
uint32_t write(const Header& header, const Message& message, uint8_t* bytes, uint32_t capacity) {
  HookByteWriter out = hookWriterTo(bytes, capacity < kMostPacket ? capacity : kMostPacket);
  writeHeader(Message::kId, header, &out);
  FieldWriter fields(&out);
  FieldsOf<Message>::each(fields, message);
  return finish(&out);
}

template <typename Message>
bool readMessage(const Packet& packet, Message& message) {
  message = {};
  FieldReader fields(packet);
  if (packet.id == Message::kId) {
    FieldsOf<Message>::each(fields, message);
  }
  return packet.id == Message::kId && fields.complete();
}

}  // namespace

#define MESSAGE(name, number)                                                                     \
  uint32_t encode(const Header& header, const name& message, uint8_t* bytes, uint32_t capacity) { \
    return write(header, message, bytes, capacity);                                               \
  }                                                                                               \
  bool decode(const Packet& packet, name& message) {                                              \
    return readMessage(packet, message);                                                          \
  }
#define FIELD(type, name)
#define MESSAGE_END
#include "hooks/imc/messages.def"

}  // namespace glider::hooks::imc
