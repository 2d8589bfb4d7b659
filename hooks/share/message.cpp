// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/share/message.h"

namespace glider::hooks::share {
namespace {

constexpr uint32_t kByteBits = 8;

}  // namespace

uint32_t digitOf(const Scale& scale, double value) {
  const double steps = (value - scale.lowest) / scale.step;
  if (!(steps > -0.5 && steps < scale.values - 0.5)) {  // nor is it NaN
    return 0;
  }
  const auto below = static_cast<uint32_t>(steps);
  return below + (steps - below >= 0.5 ? 2 : 1);
}

double valueOf(const Scale& scale, uint32_t digit) {
  return digit == 0 ? __builtin_nan("") : scale.lowest + (digit - 1) * scale.step;
}

MessageSize sizeOf(const Scale* scales, uint32_t count) {
  Number greatest;
  bool fits = true;
  for (uint32_t i = count; i != 0; --i) {
    fits = greatest.put(scales[i - 1].values + 1, scales[i - 1].values) && fits;
  }
  Number mini = greatest;
  const bool mini_fits =
      fits && mini.put(MessageReader::kMiniSignatures, MessageReader::kMiniSignatures - 1) &&
      mini.bits() <= kMiniBits;
  fits = greatest.put(MessageReader::kSignatures, MessageReader::kSignatures - 1) && fits;
  return fits ? MessageSize{greatest.size(), greatest.bits(), mini_fits ? mini.bits() : 0}
              : MessageSize{};
}

MessageWriter& MessageWriter::put(const Scale& scale, double value) {
  fits_ = number_.put(scale.values + 1, digitOf(scale, value)) && fits_;
  return *this;
}

bool MessageWriter::end(uint8_t signature, uint8_t* bytes, uint32_t size) {
  if (size > Number::kMostBytes) {
    return false;
  }
  fits_ = number_.put(MessageReader::kSignatures, signature) && fits_;
  for (uint32_t i = 0; i < size; ++i) {
    bytes[i] = number_.byte(i);
  }
  return fits_ && number_.size() <= size;
}

bool MessageWriter::endMini(uint8_t signature, uint32_t& bits) {
  constexpr uint32_t kMini = MessageReader::kMiniSignatures;
  fits_ = number_.put(kMini, signature % kMini) && fits_;
  bits = number_.byte(0) | static_cast<uint32_t>(number_.byte(1)) << kByteBits;
  return fits_ && number_.bits() <= kMiniBits;
}

MessageReader::MessageReader(uint32_t mini_bits) : size_(0) {
  const uint8_t bytes[] = {static_cast<uint8_t>(mini_bits),
                           static_cast<uint8_t>(mini_bits >> kByteBits)};
  number_ = Number(bytes, sizeof bytes);
  signature_ = number_.take(kMiniSignatures);
}

}  // namespace glider::hooks::share
