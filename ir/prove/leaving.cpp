// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/leaving.h"

#include "ir/core/ops.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr double kMost = std::numeric_limits<double>::max();

class Leaving {
 public:
  Leaving(const Ground& ground, const State& state, const Valuation& values)
      : ground_(ground), m_(ground.mission), state_(state), values_(values) {
    const Interval all{0, kMost, false};
    const Possible ever(ground, values, {all, all, all});
    for (const Case& c : state.cases) {
      gather(c.guard, ever);
    }
  }

  std::optional<double> by(double since) const {
    const double gap = ground_.platform.world.tick_gap_s;
    double best = std::numeric_limits<double>::infinity();
    for (const double stay : stays_) {
      // As long as it has been current, the mission has flown.
      const Interval on{stay, kMost, false};
      if (since + stay + gap < best && mustGo({on, on, on})) {
        best = since + stay + gap;
      }
    }
    constexpr Interval kEver{0, kMost, false};
    for (const double time : times_) {
      const double left = std::max(since, time) + gap;
      if (left < best && mustGo({{time, kMost, false}, kEver, kEver})) {
        best = left;
      }
    }
    return std::isfinite(best) ? std::optional(best) : std::nullopt;
  }

 private:
  /// Times that the guards compare clocks with.
  void gather(ExprId root, const Possible& ever) {
    std::vector<ExprId> open{root};
    while (!open.empty()) {
      const Expr& e = m_[open.back()];
      open.pop_back();
      for (uint32_t i = 0; i < opInfo(e.op).operands; ++i) {
        open.push_back(e.operands.at(i));
      }
      if (e.op >= Op::Less && e.op <= Op::GreaterEqual) {
        keep(e.operands[0], e.operands[1], ever);
        keep(e.operands[1], e.operands[0], ever);
      }
    }
  }

  void keep(ExprId clock, ExprId time, const Possible& ever) {
    const Op op = m_[clock].op;
    const Interval& x = ever.number(time);
    if (x.empty || x.highest >= kMost || x.highest < 0) {
      return;
    }
    std::set<double>* kept = op == Op::MissionTime                         ? &times_
                             : op == Op::StateTime || op == Op::ResumeTime ? &stays_
                                                                           : nullptr;
    if (kept != nullptr) {
      kept->insert(x.highest);
      kept->insert(std::nextafter(x.highest, kMost));  // what lies past it
    }
  }

  /// Some case that leads away must be true, and none before it may keep the state.
  [[nodiscard]] bool mustGo(const ClockRanges& clocks) const {
    const Possible then(ground_, values_, clocks);
    for (const Case& c : state_.cases) {
      const Truths& guard = then.truth(c.guard);
      if (!guard.is_true) {
        continue;
      }
      if (c.transition == Transition::Stay) {
        return false;
      }
      if (!guard.is_false && !guard.is_unknown) {
        return true;
      }
    }
    return false;
  }

  const Ground& ground_;
  const Mission& m_;
  const State& state_;
  const Valuation& values_;
  std::set<double> stays_{0};  ///< of the state's clocks, s
  std::set<double> times_;     ///< of mission time, s
};

}  // namespace

std::optional<double> leftBy(const Ground& ground, const State& state, const Valuation& values,
                             double since) {
  return Leaving(ground, state, values).by(since);
}

}  // namespace glider::ir::prove
