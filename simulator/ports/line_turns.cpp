// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ports/line_turns.h"

#include "hooks/extctl/port.h"
#include "hooks/extctl/sentence.h"

#include <fmt/format.h>

#include <string>
#include <string_view>
#include <utility>

namespace glider::simulator {
namespace {

class HookTurns final : public LineTurns {
 public:
  void toSbc(const uint8_t* bytes, uint32_t count) override { lockstep_.toSbc(bytes, count); }
  void fromSbc(const uint8_t* bytes, uint32_t count) override { lockstep_.fromSbc(bytes, count); }
  [[nodiscard]] bool settled() const override { return lockstep_.settled(); }

 private:
  hooks::Lockstep lockstep_;
};

class PortTurns final : public LineTurns {
 public:
  explicit PortTurns(uint32_t clock)
      : cycle_(fmt::format(",{}:", clock)),
        answer_(fmt::format(",{}:", static_cast<uint32_t>(hooks::extctl::PortSensor::Beat))) {}

  void toSbc(const uint8_t* bytes, uint32_t count) override {
    for (uint32_t i = 0; i < count; ++i) {
      owed_ += to_sbc_.push(bytes[i]) && has(to_sbc_, "SD", cycle_) ? 1U : 0U;
    }
  }
  void fromSbc(const uint8_t* bytes, uint32_t count) override {
    for (uint32_t i = 0; i < count; ++i) {
      const bool answers = from_sbc_.push(bytes[i]) && has(from_sbc_, "SW", answer_);
      owed_ -= answers && owed_ > 0 ? 1U : 0U;
    }
  }
  [[nodiscard]] bool settled() const override { return owed_ == 0; }

 private:
  static bool has(const hooks::extctl::SentenceReader& sentence, std::string_view name,
                  std::string_view pair) {
    const std::string_view body(sentence.body(), sentence.size());
    return body.starts_with(name) && body.find(pair) != std::string_view::npos;
  }

  std::string cycle_, answer_;
  hooks::extctl::SentenceReader to_sbc_, from_sbc_;
  uint32_t owed_ = 0;
};

}  // namespace

std::unique_ptr<LineTurns> hookTurns() {
  return std::make_unique<HookTurns>();
}

std::unique_ptr<LineTurns> portTurns(uint32_t clock) {
  return std::make_unique<PortTurns>(clock);
}

}  // namespace glider::simulator
