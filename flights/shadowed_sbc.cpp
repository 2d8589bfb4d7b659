// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "flights/shadowed_sbc.h"

#include "hooks/protocol/frame.h"
#include "hooks/protocol/messages.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace glider::flights {
namespace {

using simulator::SbcPort;

/// What an SBC reports of its mission with each answer.
class Reports {
 public:
  std::vector<hooks::MissionStatus> in(std::span<const uint8_t> bytes) {
    std::vector<hooks::MissionStatus> found;
    for (const uint8_t byte : bytes) {
      hooks::Done done;
      if (decoder_.push(byte) && hooks::decode(decoder_.frame(), done)) {
        found.push_back(done.status);
      }
    }
    return found;
  }

 private:
  hooks::FrameDecoder decoder_;
};

bool agree(const std::vector<hooks::MissionStatus>& one,
           const std::vector<hooks::MissionStatus>& other) {
  return std::ranges::equal(one, other, [](const auto& a, const auto& b) {
    return a.mission_time_s == b.mission_time_s && a.state == b.state &&
           a.stack_depth == b.stack_depth && a.phase == b.phase;
  });
}

/// Passes all that the flown SBC gets to the shadow too, and compares what both report of the
/// mission. The shadow's answers never reach the vehicle, so a flight with it is the same as one
/// without.
class ShadowedSbc final : public SbcPort {
 public:
  ShadowedSbc(std::unique_ptr<SbcPort> flown, std::unique_ptr<SbcPort> shadow,
              RequirementWatch& watch)
      : flown_(std::move(flown)), shadow_(std::move(shadow)), watch_(watch) {}

  [[nodiscard]] std::string way() const override { return flown_->way(); }
  void setTime(double now_s) override {
    now_s_ = now_s;
    flown_->setTime(now_s);
    shadow_->setTime(now_s);
  }
  void deliver(std::span<const uint8_t> bytes, double now_s) override {
    flown_->deliver(bytes, now_s);
    shadow_->deliver(bytes, now_s);
  }
  std::vector<uint8_t> collect() override {
    std::vector<uint8_t> answer = flown_->collect();
    if (!agree(reports_.in(answer), shadows_reports_.in(shadow_->collect()))) {
      watch_.depart(now_s_);
    }
    return answer;
  }
  std::vector<support::LoggedNote> takeNotes() override { return shadow_->takeNotes(); }
  void kill() override {
    flown_->kill();
    shadow_->kill();
  }
  [[nodiscard]] bool alive() const override { return flown_->alive(); }
  [[nodiscard]] bool keepsTime() const override { return flown_->keepsTime(); }
  void plug(bool in) override {
    flown_->plug(in);
    shadow_->plug(in);
  }
  void damageCard(const simulator::CardFault& fault, uint64_t seed) override {
    flown_->damageCard(fault, seed);
    shadow_->damageCard(fault, seed);
  }
  [[nodiscard]] std::string exitReason() const override { return flown_->exitReason(); }

 private:
  std::unique_ptr<SbcPort> flown_;
  std::unique_ptr<SbcPort> shadow_;
  RequirementWatch& watch_;
  Reports reports_;
  Reports shadows_reports_;
  double now_s_ = 0;
};

}  // namespace

simulator::StartSbc shadowed(simulator::StartSbc flown, simulator::StartSbc shadow,
                             RequirementWatch& watch) {
  return [flown = std::move(flown), shadow = std::move(shadow),
          &watch]() -> support::Result<std::unique_ptr<SbcPort>> {
    auto one = flown();
    if (!one) {
      return one;
    }
    auto other = shadow();
    if (!other) {
      return other;
    }
    return std::make_unique<ShadowedSbc>(std::move(*one), std::move(*other), watch);
  };
}

}  // namespace glider::flights
