// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/link/sbc_link.h"

#include <algorithm>
#include <array>

namespace glider::simulator {
namespace {

bool isIn(const std::vector<Span>& spans, double now_s) {
  return std::ranges::any_of(spans, [&](const Span& span) { return span.has(now_s); });
}

}  // namespace

void SbcLink::pump(double now_s) {
  followPower(now_s);
  followPort(now_s);
  followCard(now_s);
  if (port_ != nullptr) {
    port_->setTime(now_s);
  }
  std::array<uint8_t, SerialLine::kCapacity> bytes;
  const int32_t count = end_.read(end_.self, bytes.data(), static_cast<uint32_t>(bytes.size()));
  if (alive() && !without_port_) {
    exchange({bytes.begin(), bytes.begin() + std::max(count, 0)}, now_s);
  } else if (alive() && port_->keepsTime()) {
    port_->deliver({}, sbcClock(now_s));
    (void)port_->collect();  // it has no line to send it on
  }
  flush();
  noteDeath(now_s);
}

void SbcLink::exchange(const std::vector<uint8_t>& bytes, double now_s) {
  if (isIn(faults_.stuck, now_s)) {
    answerAsStuck(bytes);
  } else if (!bytes.empty() || port_->keepsTime()) {
    port_->deliver(bytes, sbcClock(now_s));
    const std::vector<uint8_t> answer = port_->collect();
    watchDone(answer);
    if (observer_ != nullptr && !answer.empty()) {
      observer_->said(answer, now_s);
    }
    waiting_.insert(waiting_.end(), answer.begin(), answer.end());
  }
}

double SbcLink::sbcClock(double now_s) {
  double clock = now_s;
  for (const ClockJump& jump : faults_.clock) {
    clock += now_s >= jump.at_s ? jump.by_s : 0;
  }
  newest_clock_s_ = std::max(newest_clock_s_, clock);  // a clock that is set back stops
  return newest_clock_s_;
}

void SbcLink::followPower(double now_s) {
  const bool off = isIn(faults_.power, now_s);
  if (off && !without_power_ && alive()) {
    port_->kill();
    waiting_.clear();
    line_.dropRight();
    noteDeath(now_s);
  }
  if (!off && without_power_) {
    startAgain(now_s, EventId::SbcHasPower);
  }
  without_power_ = off;
}

void SbcLink::startAgain(double now_s, EventId why) {
  if (!start_) {
    return;
  }
  auto again = start_();
  if (!again) {
    journal_.add(now_s, EventId::SbcDoesNotRestart, {}, again.error().message);
    return;
  }
  port_ = std::move(*again);
  death_noted_ = false;
  last_done_ = {};
  journal_.add(now_s, why);
}

void SbcLink::followPort(double now_s) {
  const bool away = isIn(faults_.port, now_s);
  if (away != without_port_ && port_ != nullptr) {
    port_->plug(!away);
    waiting_.clear();
    line_.dropRight();
    journal_.add(now_s, away ? EventId::PortGone : EventId::PortBack);
    if (!away && !alive() && !without_power_) {
      startAgain(now_s, EventId::SbcRestarted);
    }
  }
  without_port_ = away;
}

void SbcLink::followCard(double now_s) {
  card_fault_done_.resize(faults_.card.size());
  for (size_t i = 0; i < faults_.card.size(); ++i) {
    if (port_ != nullptr && !card_fault_done_[i] && now_s >= faults_.card[i].at_s) {
      card_fault_done_[i] = true;
      port_->damageCard(faults_.card[i], seed_ + i);
      journal_.add(now_s, EventId::CheckpointsDamaged);
    }
  }
}

bool SbcLink::goneForGood(double now_s) const {
  // Shortly after power returns, no program is running yet.
  constexpr double kToStart = 4;
  const auto passes = [&](const Span& span) {
    return span.to_s != kForever && span.to_s + kToStart > now_s && span.from_s <= now_s;
  };
  const bool returns = start_ && (std::ranges::any_of(faults_.power, passes) ||
                                  std::ranges::any_of(faults_.port, passes));
  return !alive() && !returns;
}

void SbcLink::answerAsStuck(const std::vector<uint8_t>& bytes) {
  for (const uint8_t byte : bytes) {
    if (!heard_.push(byte) || !hooks::expectsAnswer(heard_.frame())) {
      continue;
    }
    last_done_.answered = heard_.frame().sequence;
    hooks::Frame frame;
    hooks::encode(last_done_, frame);
    frame.sequence = ++said_sequence_;
    std::array<uint8_t, hooks::kMostEncodedBytes> encoded;
    const uint32_t size = hooks::encodeFrame(frame, encoded.data());
    waiting_.insert(waiting_.end(), encoded.begin(), encoded.begin() + size);
  }
}

void SbcLink::watchDone(const std::vector<uint8_t>& bytes) {
  for (const uint8_t byte : bytes) {
    hooks::Done done;
    if (said_.push(byte)) {
      said_sequence_ = said_.frame().sequence;
      last_done_ = hooks::decode(said_.frame(), done) ? done : last_done_;
    }
  }
}

void SbcLink::flush() {
  if (!waiting_.empty()) {
    const int32_t taken =
        end_.write(end_.self, waiting_.data(), static_cast<uint32_t>(waiting_.size()));
    waiting_.erase(waiting_.begin(), waiting_.begin() + taken);
  }
}

void SbcLink::noteDeath(double now_s) {
  if (port_ != nullptr && !death_noted_ && !port_->alive()) {
    death_noted_ = true;
    journal_.add(now_s, EventId::SbcGone, {}, port_->exitReason());
  }
}

}  // namespace glider::simulator
