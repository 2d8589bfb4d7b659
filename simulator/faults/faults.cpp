// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/faults/faults.h"

#include <algorithm>

namespace glider::simulator {
namespace {

/// Calls `visit` with the span of each fault; a fault at a single moment has a span of length 0.
template <typename Visit>
void eachSpan(const Faults& faults, const Visit& visit) {
  for (const LineFault& fault : faults.lines) {
    visit(fault.when);
  }
  for (const SensorFault& fault : faults.sensors) {
    visit(fault.when);
  }
  for (const auto* list : {&faults.power, &faults.port, &faults.stuck, &faults.modem,
                           &faults.science, &faults.console}) {
    std::ranges::for_each(*list, visit);
  }
  for (const ClockJump& jump : faults.clock) {
    visit(Span{jump.at_s, jump.at_s});
  }
  for (const double at_s : faults.aborts) {
    visit(Span{at_s, at_s});
  }
  for (const CardFault& fault : faults.card) {
    visit(Span{fault.at_s, fault.at_s});
  }
  for (const FlightRestart& restart : faults.flight) {
    visit(restart.when);
  }
  if (!faults.leftover.empty()) {
    visit(Span{0, 0});
  }
}

}  // namespace

bool Faults::empty() const {
  return first() == kForever;
}

double Faults::first() const {
  double first = kForever;
  eachSpan(*this, [&](const Span& span) { first = std::min(first, span.from_s); });
  return first;
}

double Faults::lastEnd() const {
  double last = 0;
  eachSpan(*this, [&](const Span& span) {
    last = span.to_s == kForever ? last : std::max(last, span.to_s);
  });
  return last;
}

double Faults::over() const {
  double over = 0;
  eachSpan(*this, [&](const Span& span) { over = std::max(over, span.to_s); });
  return over;
}

void Faults::add(const Faults& more) {
  const auto append = [](auto& list, const auto& others) {
    list.insert(list.end(), others.begin(), others.end());
  };
  append(lines, more.lines);
  append(sensors, more.sensors);
  append(power, more.power);
  append(port, more.port);
  append(stuck, more.stuck);
  append(modem, more.modem);
  append(science, more.science);
  append(console, more.console);
  append(clock, more.clock);
  append(aborts, more.aborts);
  append(card, more.card);
  append(flight, more.flight);
  append(leftover, more.leftover);
}

}  // namespace glider::simulator
