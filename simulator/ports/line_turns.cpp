// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/ports/line_turns.h"

#include "hooks/extctl/port.h"
#include "hooks/extctl/sentence.h"
#include "hooks/imc/codec.h"
#include "hooks/imc/packet_reader.h"
#include "hooks/recon/codec.h"

#include <fmt/format.h>

#include <cmath>
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
      if (to_sbc_.push(bytes[i]) && isNewCycle()) {
        owed_ = true;
      }
    }
  }
  void fromSbc(const uint8_t* bytes, uint32_t count) override {
    for (uint32_t i = 0; i < count; ++i) {
      if (from_sbc_.push(bytes[i]) && has(from_sbc_, "SW", answer_)) {
        owed_ = false;
      }
    }
  }
  [[nodiscard]] bool settled() const override { return !owed_; }

 private:
  /// A cycle that the line has doubled is one: the clock has not changed.
  bool isNewCycle() {
    const std::string_view body(to_sbc_.body(), to_sbc_.size());
    if (!has(to_sbc_, "SD", cycle_)) {
      return false;
    }
    const size_t at = body.find(cycle_) + cycle_.size();
    const std::string_view clock = body.substr(at, body.find(',', at) - at);
    return clock != std::exchange(clock_, std::string(clock));
  }
  static bool has(const hooks::extctl::SentenceReader& sentence, std::string_view name,
                  std::string_view pair) {
    const std::string_view body(sentence.body(), sentence.size());
    return body.starts_with(name) && body.find(pair) != std::string_view::npos;
  }

  std::string cycle_, answer_;
  hooks::extctl::SentenceReader to_sbc_, from_sbc_;
  std::string clock_;  ///< in the newest cycle
  bool owed_ = false;
};

class ImcTurns final : public LineTurns {
 public:
  void toSbc(const uint8_t* bytes, uint32_t count) override {
    each(to_sbc_, bytes, count, [&](const hooks::imc::Packet& packet) {
      const bool state = packet.id == hooks::imc::EstimatedState::kId;
      owed_ = owed_ || (state && std::floor(packet.header.time_s) !=
                                     std::exchange(second_, std::floor(packet.header.time_s)));
    });
  }
  void fromSbc(const uint8_t* bytes, uint32_t count) override {
    each(from_sbc_, bytes, count, [&](const hooks::imc::Packet& packet) {
      owed_ = owed_ && packet.id != hooks::imc::Heartbeat::kId;
    });
  }
  [[nodiscard]] bool settled() const override { return !owed_; }

 private:
  template <typename Work>
  static void each(hooks::imc::PacketReader& reader, const uint8_t* bytes, uint32_t count,
                   Work work) {
    for (uint32_t taken = 0; taken < count;) {
      taken += reader.push(bytes + taken, count - taken);
      for (hooks::imc::Packet packet; reader.next(&packet);) {
        work(packet);
      }
    }
  }

  hooks::imc::PacketReader to_sbc_, from_sbc_;
  double second_ = -1;  ///< of the newest cycle
  bool owed_ = false;
};

class ReconTurns final : public LineTurns {
 public:
  void toSbc(const uint8_t* bytes, uint32_t count) override {
    each(to_sbc_, bytes, count, [&](const hooks::recon::Line& line) {
      hooks::recon::TimeSet time;
      hooks::recon::State state;
      dated_ = dated_ || decode(line, time);
      if (dated_ && decode(line, state)) {
        const double second = std::floor(state.time_s);
        owed_ = owed_ || second != second_;
        second_ = second;
      }
    });
  }
  void fromSbc(const uint8_t* bytes, uint32_t count) override {
    each(from_sbc_, bytes, count, [&](const hooks::recon::Line& line) {
      hooks::recon::SimulationText text;
      hooks::recon::TimeQuery query;
      const bool ends = decode(line, query) ||
                        (decode(line, text) &&
                         std::string_view(text.text.bytes, text.text.size).starts_with("state,"));
      owed_ = owed_ && !ends;
    });
  }
  [[nodiscard]] bool settled() const override { return !owed_; }

 private:
  template <typename Work>
  static void each(hooks::recon::LineReader& reader, const uint8_t* bytes, uint32_t count,
                   Work work) {
    for (uint32_t i = 0; i < count; ++i) {
      if (hooks::recon::Line line; reader.push(bytes[i], &line)) {
        work(line);
      }
    }
  }

  hooks::recon::LineReader to_sbc_, from_sbc_;
  double second_ = -1;  ///< of the newest cycle
  bool dated_ = false;
  bool owed_ = false;
};

}  // namespace

std::unique_ptr<LineTurns> hookTurns() {
  return std::make_unique<HookTurns>();
}

std::unique_ptr<LineTurns> portTurns(uint32_t clock) {
  return std::make_unique<PortTurns>(clock);
}

std::unique_ptr<LineTurns> imcTurns() {
  return std::make_unique<ImcTurns>();
}

std::unique_ptr<LineTurns> reconTurns() {
  return std::make_unique<ReconTurns>();
}

}  // namespace glider::simulator
