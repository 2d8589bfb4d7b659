// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "simulator/slocum/line/line_direction.h"

#include "hooks/protocol/decimal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace glider::simulator {
namespace {

/// Of the sensor's number and what separates two values: the vendor's own text is not public.
constexpr double kMoreCharacters = 6;

bool isOfOneSensor(const PassingValue& a, const PassingValue& b) {
  return a.id == b.id && a.name == b.name;
}

double charactersOf(double value) {
  std::array<char, hooks::kMostDecimal> text;
  return kMoreCharacters + hooks::writeDecimal(value, text.data());
}

}  // namespace

LineDirection::LineDirection(const Faults& faults, LineWay way, const LineLag& lag, uint64_t seed)
    : consoles_(faults.console),
      lag_(lag),
      noise_(seed, way == LineWay::ToFlight ? "line to flight" : "line to science") {
  std::ranges::copy_if(faults.lines, std::back_inserter(faults_),
                       [&](const LineFault& fault) { return fault.way == way; });
}

void LineDirection::setNow(double now_s) {
  const bool suspended =
      std::ranges::any_of(consoles_, [&](const Span& span) { return span.has(now_s_); });
  line_s_ += suspended ? 0 : now_s - now_s_;
  now_s_ = now_s;
}

double LineDirection::lag() {
  const double most_s = happens(lag_.waits_share) ? lag_.most_s : lag_.usual_s;
  return lag_.least_s + (most_s - lag_.least_s) * noise_.uniform();
}

void LineDirection::send(PassingValue value) {
  if (std::isnan(value.value)) {
    return;
  }
  value.value = hooks::asSixDecimals(value.value);
  const double more_s = lag();
  if (!getsThrough(value)) {
    return;
  }
  pass(value, more_s);
  for (const LineFault& fault : faults_) {
    if (!fault.when.has(now_s_)) {
      continue;
    }
    if (happens(fault.doubled)) {
      pass(value, more_s + lag());
    }
    if (happens(fault.replayed)) {
      repeat();
    }
  }
  if (std::ranges::any_of(faults_, [](const LineFault& fault) { return fault.replayed > 0; })) {
    constexpr size_t kMost = 1000;
    if (earlier_.size() == kMost) {
      earlier_.erase(earlier_.begin());
    }
    earlier_.push_back(std::move(value));
  }
}

void LineDirection::pass(PassingValue value, double more_s) {
  double due_s = line_s_ + more_s;
  for (const LineFault& fault : faults_) {
    due_s += fault.when.has(now_s_) ? fault.delay_s : 0;
  }
  for (const Passing& before : passing_) {
    due_s = isOfOneSensor(before.value, value) ? std::max(due_s, before.due_s) : due_s;
  }
  passing_.push_back({due_s, std::move(value)});
}

/// An earlier value comes again after those of its sensor that are on their way.
void LineDirection::repeat() {
  if (!earlier_.empty()) {
    const auto which = static_cast<size_t>(noise_.uniform() * static_cast<double>(earlier_.size()));
    pass(earlier_[which], lag());
  }
}

bool LineDirection::getsThrough(const PassingValue& value) {
  const double characters = charactersOf(value.value);
  bool whole = true;
  for (const LineFault& fault : faults_) {
    if (fault.when.has(now_s_) && isSpoilt(fault, characters)) {
      whole = false;
    }
  }
  if (burst_left_ > 0) {
    burst_left_ -= characters;
    whole = false;
  }
  return whole;
}

/// One wrong character is enough.
bool LineDirection::isSpoilt(const LineFault& fault, double characters) {
  if (happens(1 - std::pow(1 - fault.bursts, characters))) {
    burst_left_ = std::max(burst_left_, fault.burst_bytes);
  }
  return fault.cut || fault.heard_at_baud > 0 ||
         happens(1 - std::pow((1 - fault.loss) * (1 - fault.flips), characters));
}

std::optional<PassingValue> LineDirection::next() {
  const auto first = std::ranges::min_element(passing_, {}, &Passing::due_s);
  if (first == passing_.end() || first->due_s > line_s_) {
    return std::nullopt;
  }
  PassingValue value = std::move(first->value);
  passing_.erase(first);
  return value;
}

void LineDirection::dropArrived() {
  while (next()) {
  }
}

}  // namespace glider::simulator
