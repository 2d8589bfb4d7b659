// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/share/message.h"
#include "simulator/acoustics/acoustic_frame.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace glider::simulator {

/// How a message of a fleet is packed.
struct MessageForm {
  std::vector<hooks::share::Scale> scales;  ///< of its values, in the order of the mission
  uint8_t signature = 0;
  uint32_t bytes = 0;
  bool is_mini = false;  ///< it is a mini packet
};

/// What a vehicle sends instead of the truth.
enum class Lie : uint8_t {
  Values,   ///< messages of the fleet with values at random, each of its range or unknown
  Frozen,   ///< the first message that it sent
  Masked,   ///< values at random, and the address of another vehicle
  Rubbish,  ///< bytes at random
};
inline constexpr uint32_t kLies = 4;
/// "values at random".
const char* nameOf(Lie lie);

/// Replaces the frames of a vehicle. The same seed gives the same frames.
class Liar {
 public:
  /// `forms`: one at least. `others`: the addresses of the other vehicles; empty: none talks.
  Liar(Lie lie, std::vector<MessageForm> forms, std::vector<uint32_t> others, uint64_t seed)
      : lie_(lie), forms_(std::move(forms)), others_(std::move(others)), seed_(seed) {}

  /// What is sent instead of `frame`.
  AcousticFrame insteadOf(const AcousticFrame& frame);

 private:
  uint32_t below(uint32_t count);
  void putValues(AcousticFrame& frame);

  Lie lie_;
  std::vector<MessageForm> forms_;
  std::vector<uint32_t> others_;
  uint64_t seed_;
  uint32_t drawn_ = 0;  ///< numbers, so far
  std::optional<AcousticFrame> first_;
};

}  // namespace glider::simulator
