// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/instruments.h"

#include "hooks/protocol/sampling.h"
#include "ir/core/sampling.h"

#include <algorithm>

namespace glider::ir::prove {
namespace {

/// An instruction may wait for the one before (runtime/core/control.h), then crosses the vehicle's
/// line.
constexpr double kCyclesToObey = 8;

}  // namespace

InstrumentShares::InstrumentShares(const LegContext& context)
    : context_(context),
      m_(context.seen.mission),
      lag_s_(context.seen.platform.world.line_lag_s + context.seen.platform.world.command_delay_s +
             kCyclesToObey * context.seen.platform.envelope.cycle_s) {
  for (const platforms::Draw& draw : context.seen.platform.power.draws) {
    if (draw.instrument) {
      double& before = before_[*draw.instrument];
      before = std::max(before, otherwise(draw));
    }
  }
  for (const State& state : m_.states) {
    by_state_.push_back(sharesIn(state));
    for (size_t i = 0; i < most_.size(); ++i) {
      most_[i] = std::max(most_[i], by_state_.back()[i]);
    }
  }
}

InstrumentSeconds InstrumentShares::sharesIn(const State& state) const {
  const bool known =
      std::ranges::all_of(state.sampling, [&](const Sampling& one) { return isKnown(one.code); });
  InstrumentSeconds shares{};
  for (const platforms::Draw& draw : context_.seen.platform.power.draws) {
    if (!draw.instrument) {
      continue;
    }
    const Sampling* ordered = samplingOf(state, *draw.instrument);
    // A word that is not known leaves in force what another state has commanded.
    double share = known ? otherwise(draw) : 1;
    if (known && ordered != nullptr) {
      share = greatest(draw, *ordered);
    }
    shares[*draw.instrument] = std::max(shares[*draw.instrument], share);
  }
  return shares;
}

/// Where the vehicle's own mission says how often.
double InstrumentShares::otherwise(const platforms::Draw& draw) const {
  return draw.when == platforms::DrawWhen::Always || readsWhatMeasures(m_, draw) ? 1 : 0;
}

/// Also a number that is replaced where it is not known.
bool InstrumentShares::isKnown(ExprId code) const {
  const Expr& e = m_[code];
  const bool replaced = e.op == Op::Select && m_[e.operands[0]].op == Op::Known &&
                        m_[e.operands[0]].operands[0] == e.operands[1];
  return context_.seen.known.expressions[(replaced ? e.operands[2] : code).index];
}

double InstrumentShares::greatest(const platforms::Draw& draw, const Sampling& sampling) const {
  const auto isKnown = [&](ExprId code) { return context_.seen.known.expressions[code.index]; };
  double greatest = 0;
  forEachCode(m_, sampling, isKnown, [&](const Expr& code) {
    greatest = std::max(greatest, with(code, sampling.period, draw).value_or(otherwise(draw)));
  });
  return greatest;
}

/// None where the vehicle's own mission says how often.
std::optional<double> InstrumentShares::with(const Expr& code, ExprId period,
                                             const platforms::Draw& draw) const {
  if (code.op == Op::Constant) {
    return platforms::shareOn(draw, static_cast<uint32_t>(code.number));
  }
  if (!period.valid()) {
    return 1;
  }
  const Interval& seconds = context_.held[period.index];
  const double shortest = seconds.empty ? 0 : std::max(0.0, seconds.lowest);
  return platforms::shareOn(draw, hookSamplingCode(shortest));
}

void InstrumentShares::addTo(EnergyLines& lines, StateId state) const {
  const InstrumentSeconds& shares = by_state_[state.index];
  for (EnergyLine& line : lines) {
    line.rate.instruments_s = shares;
    for (size_t i = 0; i < shares.size(); ++i) {
      const bool first = state.index == 0;
      const double before = first ? std::max(most_[i], before_[i]) : most_[i];
      line.offset.instruments_s[i] = lag_s_ * (before - shares[i]);
    }
  }
}

void InstrumentShares::addMostTo(EnergyLine& line) const {
  line.rate.instruments_s = most_;
  for (size_t i = 0; i < most_.size(); ++i) {
    line.offset.instruments_s[i] = lag_s_ * std::max(0.0, before_[i] - most_[i]);
  }
}

}  // namespace glider::ir::prove
