// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/load/loaded_mission.h"
#include "flights/launch_choice.h"
#include "flights/port_end.h"
#include "hooks/transport/byte_stream.h"
#include "runtime/abi/runtime.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/talk/talker.h"
#include "simulator/ports/line_turns.h"
#include "simulator/ports/sbc_port.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glider::flights {

/// The card of an SBC in this process: its content survives a power cut.
using Card = std::vector<uint8_t>;

/// An SBC within this process: the compiled mission, loaded as a shared object, speaks the real
/// protocol over memory.
class InProcessSbc final : public simulator::SbcPort {
 public:
  /// `parameters`: one value each, as the mission allows them. `keeps_time`: its clock is the
  /// vehicle's, and time-outs expire; otherwise its clock does not advance between frames. `card`:
  /// where it stores its checkpoints. `port`: it is at another port of the vehicle; none: at
  /// hookprog's.
  InProcessSbc(std::shared_ptr<const codegen::LoadedMission> mission,
               std::vector<double> parameters, std::shared_ptr<Card> card, bool keeps_time = false,
               const std::optional<PortEnd>& port = {});

  /// Calls `watcher` each time that the runtime has been polled, once its mission has started, with
  /// the runtime's context and the vehicle's time, s.
  using Watcher = std::function<void(const GliderContext&, double now_s)>;
  void watch(Watcher watcher) { watcher_ = std::move(watcher); }

  /// Its program uses its modem, in its turns. Nothing if the mission shares nothing.
  void talk(const Turn& turn);

  /// Mission time of the newest checkpoint that it found on its card, s; none: there was none.
  [[nodiscard]] std::optional<double> kept() const { return kept_; }

  [[nodiscard]] std::string way() const override { return "in-process"; }
  void setTime(double now_s) override { vehicle_now_s_ = now_s; }
  void deliver(std::span<const uint8_t> bytes, double now_s) override;
  std::vector<uint8_t> collect() override;
  void kill() override { end("killed"); }
  [[nodiscard]] bool alive() const override { return exit_reason_.empty(); }
  [[nodiscard]] bool keepsTime() const override { return keeps_time_; }
  void plug(bool in) override { plugged_ = in; }
  void hearModem(std::span<const uint8_t> bytes) override;
  void hearValue(uint16_t id, double raw) override;
  std::vector<support::LoggedNote> takeNotes() override { return std::exchange(notes_, {}); }
  std::vector<uint8_t> toModem() override;
  void damageCard(const simulator::CardFault& fault, uint64_t seed) override;
  [[nodiscard]] std::string exitReason() const override { return exit_reason_; }

 private:
  static int32_t readBytes(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t writeBytes(void* self, const uint8_t* bytes, uint32_t count);
  static int32_t readModem(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t writeModem(void* self, const uint8_t* bytes, uint32_t count);
  static double now(void* self);
  static int32_t readCard(void* self, uint32_t offset, uint8_t* bytes, uint32_t count);
  static int32_t writeCard(void* self, uint32_t offset, const uint8_t* bytes, uint32_t count);
  [[nodiscard]] size_t onCard(uint32_t offset) const;
  void run();
  void showToWatcher() const;
  void keepNotes();
  [[nodiscard]] std::optional<double> findKept();
  void end(const std::string& exit_reason);

  std::shared_ptr<const codegen::LoadedMission> mission_;
  std::vector<double> parameters_;
  Watcher watcher_;
  std::vector<support::LoggedNote> notes_;
  std::vector<support::LoggedNote> newest_notes_;  ///< of the newest tick that had some
  std::shared_ptr<Card> card_;
  std::unique_ptr<std::byte[]> runtime_memory_;
  std::unique_ptr<std::byte[]> context_memory_;
  GliderRuntime* runtime_ = nullptr;
  std::vector<uint8_t> to_sbc_;
  size_t taken_ = 0;  ///< bytes of to_sbc_ already read
  std::vector<uint8_t> from_sbc_;
  SeatOnBoard seat_;
  std::optional<runtime::talk::Talker> talker_;
  std::vector<uint8_t> from_modem_;
  std::vector<uint8_t> to_modem_;
  std::unique_ptr<simulator::LineTurns> turns_;
  double now_s_ = 0;          ///< by its own clock
  double vehicle_now_s_ = 0;  ///< by that of the simulated world
  std::optional<double> kept_;
  runtime::LinkFacts kept_link_;  ///< of that checkpoint
  bool keeps_time_;
  bool plugged_ = true;
  bool finished_ = false;    ///< the mission has released control: a program would end here
  std::string exit_reason_;  ///< empty while it is alive
};

}  // namespace glider::flights
