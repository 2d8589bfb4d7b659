// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/energy/instruments.h"

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
      lag_s_(context.seen.platform.world.line_lag_s +
             kCyclesToObey * context.seen.platform.envelope.cycle_s) {
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
    const bool always = draw.when == platforms::DrawWhen::Always;
    const double otherwise = always || readsWhatMeasures(m_, draw) ? 1 : 0;
    const auto ordered = std::ranges::find(state.sampling, *draw.instrument, &Sampling::place);
    // A word that is not known leaves in force what another state has commanded.
    double share = known ? otherwise : 1;
    if (known && ordered != state.sampling.end()) {
      share = greatest(draw, *ordered, ordered->code, otherwise);
    }
    shares[*draw.instrument] = std::max(shares[*draw.instrument], share);
  }
  return shares;
}

/// Also a number that is replaced where it is not known.
bool InstrumentShares::isKnown(ExprId code) const {
  const Expr& e = m_[code];
  const bool replaced = e.op == Op::Select && m_[e.operands[0]].op == Op::Known &&
                        m_[e.operands[0]].operands[0] == e.operands[1];
  return context_.seen.known.expressions[(replaced ? e.operands[2] : code).index];
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the choices of one word
double InstrumentShares::greatest(const platforms::Draw& draw, const Sampling& sampling,
                                  ExprId code, double otherwise) const {
  const Expr& e = m_[code];
  if (e.op == Op::Constant) {
    return platforms::shareOn(draw, static_cast<uint32_t>(e.number)).value_or(otherwise);
  }
  if (e.op == Op::Select) {
    const Expr& condition = m_[e.operands[0]];
    if (condition.op == Op::Known && context_.seen.known.expressions[condition.operands[0].index]) {
      return greatest(draw, sampling, e.operands[1], otherwise);
    }
    return std::max(greatest(draw, sampling, e.operands[1], otherwise),
                    greatest(draw, sampling, e.operands[2], otherwise));
  }
  if (!sampling.period.valid()) {
    return 1;
  }
  const Interval& period = context_.held[sampling.period.index];
  const double shortest = period.empty ? 0 : std::max(0.0, period.lowest);
  return platforms::shareOn(draw, hookSamplingCode(shortest)).value_or(otherwise);
}

void InstrumentShares::addTo(EnergyLines& lines, StateId state) const {
  const InstrumentSeconds& shares = by_state_[state.index];
  for (EnergyLine& line : lines) {
    line.rate.instruments_s = shares;
    for (size_t i = 0; i < shares.size(); ++i) {
      line.offset.instruments_s[i] = lag_s_ * (most_[i] - shares[i]);
    }
  }
}

}  // namespace glider::ir::prove
