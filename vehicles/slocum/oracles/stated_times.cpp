// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/oracles/stated_times.h"

#include "simulator/campaign/promises.h"

#include <algorithm>

namespace glider::slocum::oracles {
namespace {

/// True if no frame gets through intact.
bool isDead(const LineFault& fault) {
  return fault.cut || fault.loss >= 1 || fault.heard_at_baud > 0;
}

}  // namespace

StatedTimes statedTimes(const Faults& faults, const ControlTimes& times) {
  StatedTimes stated;
  const double silent_after = releaseSecs(Control::Silent, times);
  double delay_s = 0;
  for (const LineFault& fault : faults.lines) {
    delay_s += fault.delay_s;
  }
  // Delayed bytes are still on the line when the fault begins.
  const auto dead = [&](const Span& span, const char* why) {
    stated.releases.push_back({{span.from_s + silent_after + delay_s, span.to_s}, why});
  };
  const auto all_dead = [&](const std::vector<Span>& spans, const char* why) {
    std::ranges::for_each(spans, [&](const Span& span) { dead(span, why); });
  };
  all_dead(faults.power, "the SBC has no power");
  all_dead(faults.port, "the SBC has no port");
  all_dead(faults.stuck, "the SBC's mission is stuck");
  all_dead(faults.science, "the science computer is down");
  all_dead(faults.console, "a console suspends the line");
  for (const LineFault& fault : faults.lines) {
    if (isDead(fault)) {
      dead(fault.when, "a line is dead");
    }
  }
  for (const double at_s : faults.aborts) {
    stated.releases.push_back({{at_s, kForever}, "the flight controller has aborted"});
  }
  stated.most_standstill_s = releaseSecs(Control::Unanswered, times) + delay_s;
  stated.most_unanswered_s = stated.most_standstill_s;
  return stated;
}

}  // namespace glider::slocum::oracles
