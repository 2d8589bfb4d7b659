// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/load/loaded_mission.h"
#include "hooks/protocol/lockstep.h"
#include "hooks/transport/byte_stream.h"
#include "runtime/abi/runtime.h"
#include "simulator/sbc_port.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glider::driver {

/// An SBC within this process: the compiled mission, loaded as a shared object, speaks the real
/// protocol over memory.
class InProcessSbc final : public simulator::SbcPort {
 public:
  /// `parameters`: one value each, as the mission allows them.
  InProcessSbc(codegen::LoadedMission mission, std::vector<double> parameters);

  [[nodiscard]] std::string way() const override { return "in-process"; }
  void deliver(std::span<const uint8_t> bytes, double now_s) override;
  std::vector<uint8_t> collect() override;
  void kill() override { killed_ = alive(); }
  [[nodiscard]] bool alive() const override { return !killed_ && !ended_; }
  [[nodiscard]] std::string epitaph() const override {
    return killed_ ? "killed" : ended_ ? "exited with status 0" : "";
  }

 private:
  static int32_t readBytes(void* self, uint8_t* bytes, uint32_t capacity);
  static int32_t writeBytes(void* self, const uint8_t* bytes, uint32_t count);
  static double now(void* self);

  codegen::LoadedMission mission_;
  std::vector<double> parameters_;
  std::unique_ptr<std::byte[]> runtime_memory_;
  std::unique_ptr<std::byte[]> context_memory_;
  GliderRuntime* runtime_ = nullptr;
  std::vector<uint8_t> to_sbc_;
  size_t taken_ = 0;  ///< of to_sbc_
  std::vector<uint8_t> from_sbc_;
  hooks::Lockstep lockstep_;
  double now_s_ = 0;
  bool killed_ = false;
  bool finished_ = false;  ///< the mission has given control back: a program would end here
  bool ended_ = false;     ///< and has been missed
};

}  // namespace glider::driver
