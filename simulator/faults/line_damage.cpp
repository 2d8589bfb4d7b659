// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/faults/line_damage.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace glider::simulator {

LineDamage::LineDamage(const std::vector<LineFault>& faults, LineWay way, uint64_t seed,
                       double baud)
    : noise_(seed, static_cast<uint32_t>(NoiseStream::LineDamage) + static_cast<uint32_t>(way)),
      baud_(baud) {
  std::ranges::copy_if(faults, std::back_inserter(faults_),
                       [&](const LineFault& fault) { return fault.way == way; });
}

double LineDamage::pass(uint8_t value, double now_s, double at_s, std::deque<Arrival>& out) {
  damage(value, now_s, at_s, out);
  frame_.push_back(value);
  if (value != 0) {
    return 0;
  }
  std::vector<uint8_t> frame = std::exchange(frame_, {});
  double more_s = isDoubled(now_s) ? again(frame, now_s, at_s, out) : 0;
  if (const std::vector<uint8_t>* old = replayedFrame(now_s); old != nullptr) {
    more_s += again(*old, now_s, at_s + more_s, out);
  }
  remember(std::move(frame));
  return more_s;
}

/// Sends `frame` again after what arrives at the other end at `at_s`; returns how long that takes,
/// s.
double LineDamage::again(const std::vector<uint8_t>& frame, double now_s, double at_s,
                         std::deque<Arrival>& out) {
  const double byte_s = 10 / baud_;
  double more_s = 0;
  for (const uint8_t byte : frame) {
    more_s += byte_s;
    damage(byte, now_s, at_s + more_s, out);
  }
  return more_s;
}

void LineDamage::remember(std::vector<uint8_t> frame) {
  constexpr size_t kMost = 1000;  // some twenty minutes of a line's frames
  const bool can_come_again =
      std::ranges::any_of(faults_, [](const LineFault& fault) { return fault.replayed > 0; });
  if (!can_come_again) {
    return;
  }
  if (earlier_.size() < kMost) {
    earlier_.push_back(std::move(frame));
  } else {
    earlier_[static_cast<size_t>(noise_.uniform() * kMost)] = std::move(frame);
  }
}

const std::vector<uint8_t>* LineDamage::replayedFrame(double now_s) {
  const bool now = std::ranges::any_of(faults_, [&](const LineFault& fault) {
    return fault.replayed > 0 && fault.when.has(now_s) && noise_.uniform() < fault.replayed;
  });
  if (!now || earlier_.empty()) {
    return nullptr;
  }
  return &earlier_[static_cast<size_t>(noise_.uniform() * static_cast<double>(earlier_.size()))];
}

bool LineDamage::isDoubled(double now_s) {
  return std::ranges::any_of(faults_, [&](const LineFault& fault) {
    return fault.doubled > 0 && fault.when.has(now_s) && noise_.uniform() < fault.doubled;
  });
}

void LineDamage::damage(uint8_t value, double now_s, double at_s, std::deque<Arrival>& out) {
  double delay_s = 0;
  int copies = 1;
  for (const LineFault& fault : faults_) {
    if (!fault.when.has(now_s)) {
      continue;
    }
    if (vanishes(fault)) {
      return;
    }
    spoil(fault, value);
    delay_s += fault.delay_s;
    if (fault.heard_at_baud > 0) {
      copies = copiesAtAnotherBaud(fault);
    }
  }
  newest_s_ = std::max(newest_s_, at_s + delay_s);
  for (int i = 0; i < copies; ++i) {
    out.push_back({copies == 1 ? value : randomByte(), newest_s_});
  }
}

bool LineDamage::vanishes(const LineFault& fault) {
  return fault.cut || (fault.loss > 0 && noise_.uniform() < fault.loss);
}

void LineDamage::spoil(const LineFault& fault, uint8_t& value) {
  if (fault.flips > 0 && noise_.uniform() < fault.flips) {
    value = static_cast<uint8_t>(value ^ (1U << static_cast<uint32_t>(noise_.uniform() * 8)));
  }
  if (burst_left_ < 1 && fault.bursts > 0 && noise_.uniform() < fault.bursts) {
    burst_left_ = fault.burst_bytes;
  }
  if (burst_left_ >= 1) {
    burst_left_ -= 1;
    value = randomByte();
  }
  if (fault.heard_at_baud > 0) {
    value = randomByte();
  }
}

/// A receiver at twice the speed reads twice as many bytes, all of them wrong.
int LineDamage::copiesAtAnotherBaud(const LineFault& fault) {
  heard_ += fault.heard_at_baud / baud_;
  const double whole = std::floor(heard_);
  heard_ -= whole;
  return static_cast<int>(whole);
}

}  // namespace glider::simulator
