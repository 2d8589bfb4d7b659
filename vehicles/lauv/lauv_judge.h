// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/imc/packet_reader.h"
#include "simulator/campaign/floating_judge.h"

#include <cstdint>
#include <span>

namespace glider::lauv {

/// Checks a flight by the References that the SBC sends, and by its requests to end the plan.
class LauvJudge final : public simulator::FloatingJudge {
 public:
  explicit LauvJudge(const simulator::FloatingPromise& promise)
      : FloatingJudge(promise, "Reference") {}

  void said(std::span<const uint8_t> bytes, double now_s) override;

 private:
  void hear(const hooks::imc::Packet& packet, double now_s);

  hooks::imc::PacketReader packets_;
};

}  // namespace glider::lauv
