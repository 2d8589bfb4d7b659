// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/science/sbc_link.h"

#include <array>

namespace glider::simulator {

void SbcLink::pump(double now_s) {
  std::array<uint8_t, SerialLine::kCapacity> bytes;
  const int32_t count = end_.read(end_.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
  if (count > 0 && alive()) {
    port_->deliver({bytes.data(), static_cast<size_t>(count)}, now_s);
    const std::vector<uint8_t> answer = port_->collect();
    waiting_.insert(waiting_.end(), answer.begin(), answer.end());
  }
  if (!waiting_.empty()) {
    const int32_t taken =
        end_.write(end_.self, waiting_.data(), static_cast<uint32_t>(waiting_.size()));
    waiting_.erase(waiting_.begin(), waiting_.begin() + taken);
  }
  noteDeath(now_s);
}

void SbcLink::kill(double now_s) {
  if (alive()) {
    port_->kill();
    waiting_.clear();
  }
  noteDeath(now_s);
}

void SbcLink::noteDeath(double now_s) {
  if (port_ != nullptr && !death_noted_ && !port_->alive()) {
    death_noted_ = true;
    journal_.add(now_s, "link", "the SBC is gone", port_->epitaph());
  }
}

}  // namespace glider::simulator
