// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/context_layout.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/core/lay_out.h"
#include "tests/slocum.h"
#include "tests/unit/runtime/power_cut_store.h"

#include <optional>
#include <vector>

namespace glider::tests {

/// What of an SBC outlives its power: a card with the runtime's own checkpoints, of a mission with
/// one state and nothing else.
class KeptSbc {
 public:
  KeptSbc() {
    mission_.abi_version = GLIDER_ABI_VERSION;
    mission_.dictionary = &gliderDictionary;
    mission_.state_count = 1;
    memory_.resize(gliderContextLayout(&mission_).bytes / sizeof(double) + 1);
    start(false);
  }
  KeptSbc(const KeptSbc&) = delete;
  KeptSbc& operator=(const KeptSbc&) = delete;

  /// A program starts, with an empty card unless `keeps`. True if it finds a checkpoint.
  bool start(bool keeps) {
    if (!keeps) {
      card_.content.clear();
    }
    context_ = runtime::layOut(memory_.data(), mission_);
    checkpoint_.emplace(card_.store(), 1U);
    return checkpoint_->find(*context_, facts_) == runtime::Checkpoint::Found::Good;
  }
  /// What it found.
  [[nodiscard]] const runtime::LinkFacts& facts() const { return facts_; }

  /// At the end of a tick in which the mission flies, before the answer.
  void keep(double mission_time_s, uint32_t session, uint32_t instruction) {
    context_->mission_time = mission_time_s;
    context_->moved_list = GLIDER_NO_LIST;
    (void)checkpoint_->keep(*context_, {mission_time_s, 0, 0, session, instruction});
  }

 private:
  GliderMission mission_{};
  std::vector<double> memory_;
  runtime::testing::RecordingStore card_;
  std::optional<runtime::Checkpoint> checkpoint_;
  GliderContext* context_ = nullptr;
  runtime::LinkFacts facts_;
};

}  // namespace glider::tests
