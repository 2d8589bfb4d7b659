// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/acoustics/liar.h"

#include "simulator/acoustics/uniform.h"
#include "support/check.h"

#include <array>

namespace glider::simulator {

const char* nameOf(Lie lie) {
  constexpr std::array<const char*, kLies> kNames = {
      "values at random", "its first message for ever", "values at random as another vehicle",
      "bytes at random"};
  return kNames[static_cast<size_t>(lie)];
}

/// 0 to `count` - 1.
uint32_t Liar::below(uint32_t count) {
  constexpr uint32_t kStream = 0x6C696172;  // apart from what the channel draws
  return static_cast<uint32_t>(uniform(seed_, {drawn_++, 0, 0, kStream}) * count);
}

void Liar::putValues(AcousticFrame& frame) {
  const MessageForm& form = forms_[below(static_cast<uint32_t>(forms_.size()))];
  hooks::share::MessageWriter writer;
  for (size_t i = form.scales.size(); i != 0; --i) {
    const hooks::share::Scale& scale = form.scales[i - 1];
    // The first of these is that the sender does not know.
    writer.put(scale, hooks::share::valueOf(scale, below(scale.values + 1)));
  }
  frame.is_mini = form.is_mini;
  frame.data.size = form.is_mini ? 0 : form.bytes;
  const bool fits = form.is_mini ? writer.endMini(form.signature, frame.mini_bits)
                                 : writer.end(form.signature, frame.data.bytes, frame.data.size);
  CHECK(fits, "the form of a message fits it");
}

AcousticFrame Liar::insteadOf(const AcousticFrame& frame) {
  AcousticFrame told = frame;
  switch (lie_) {
    case Lie::Frozen:
      first_ = first_ ? first_ : frame;
      told = *first_;
      break;
    case Lie::Masked:
      if (!others_.empty()) {
        told.source = others_[below(static_cast<uint32_t>(others_.size()))];
      }
      [[fallthrough]];
    case Lie::Values:
      putValues(told);
      break;
    case Lie::Rubbish:
      told.mini_bits = below(1U << hooks::share::kMiniBits);
      told.data.size = 1 + below(hooks::micro_modem::kMostFrameBytes);
      for (uint32_t i = 0; i < told.data.size; ++i) {
        told.data.bytes[i] = static_cast<uint8_t>(below(256));
      }
      break;
  }
  return told;
}

}  // namespace glider::simulator
