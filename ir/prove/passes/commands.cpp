// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pass `commands`: depths, pitches, fin angles, pump volumes and battery positions beyond the
// vehicle's envelope, or above the surface (GL3104), pitches that the vehicle refuses (GL3108), and
// profiles that never turn (GL3105, GL3145). In: the interval of each argument, and the guards
// before it, which are computed only if the plain interval is too wide. No report is a proof for
// commands with known ranges. An error may name a value that no flight commands: the pilot then
// narrows a range or adds a condition. Not checked: code in C, numbers without a range.

#include "ir/prove/context/commands.h"

#include "ir/core/walk.h"
#include "ir/prove/context/setting.h"
#include "ir/prove/encoding/question.h"
#include "ir/prove/passes.h"
#include "ir/verify/guarded_ranges.h"
#include "ir/verify/value_text.h"
#include "support/diagnostics/ids/verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace glider::ir::prove {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

/// A greater bound means that the number has no range.
constexpr double kNoBound = 1e300;

/// Angles as pilots write them.
std::string shown(double value, Type type) {
  const bool angle = type.dimension == support::dimension::angle;
  return angle ? fmt::format("{:.4g} deg", value * 180 / std::numbers::pi) : withUnit(value, type);
}

constexpr double kCubicMetresPerCc = 1e-6;
constexpr double kMetresPerInch = 0.0254;
/// The vehicle holds both as float32: what their conversion adds is not more than the limit.
constexpr double kRounded = 1 + 1e-9;

/// The limit of a part that a command moves, and how it is written.
struct Part {
  double most;                   ///< in SI units
  std::string_view what = {};    ///< before a value that is too far
  std::string_view lacks = {};   ///< of a vehicle whose limit is 0
  double unit = 0;               ///< in which values are shown; 0: that of the type
  std::string_view symbol = {};  ///< of that unit
};

std::optional<Part> partMoved(Command command, const platforms::Envelope& envelope) {
  switch (command) {
    case Command::Fin:
      return Part{envelope.fin_rad, "a fin angle of ",
                  "its platform has no `fin_rad`: the vehicle has no fin to command"};
    case Command::Pump:
      return Part{envelope.pump_cc * kCubicMetresPerCc * kRounded, "a pump volume of ",
                  "its platform has no `pump_cc`: the vehicle has no pump to command"};
    case Command::Battery:
      return Part{envelope.battery_in * kMetresPerInch * kRounded, "a battery position of ",
                  "its platform has no `battery_in`: the vehicle has no pitch battery to command",
                  kMetresPerInch, "inch"};
    case Command::Descend:
    case Command::Ascend:
    case Command::DescendAt:
    case Command::AscendAt:
    case Command::Hover:
    case Command::Surface:
    case Command::Steer:
    case Command::SteerTo:
    case Command::Drift:
      break;
  }
  return std::nullopt;
}

/// Checks the commands of every state and of `always`, with the ranges of all that they are made
/// from.
class CommandCheck {
 public:
  explicit CommandCheck(Proof& proof)
      : proof_(proof),
        m_(proof.proof_context.mission),
        envelope_(proof.proof_context.platform.envelope) {}

  void run() {
    for (const State& state : m_.states) {
      commands_ = commandsOf(m_, state.profile);
      checkEnvelope(commands_, state.profile.range);
      checkTurns(state);
      checkEnvelope(commandsOf(m_, state.route), state.route.range);
      checkCases(state.cases);
      checkBlock(state.entry);
    }
    checkCases(m_.always);
  }

 private:
  /// Without what its guard says.
  [[nodiscard]] const Interval& range(const Statement& statement, size_t argument) const {
    return proof_.proof_context.intervals[statement.values.at(argument).index];
  }

  /// With it; empty for a command that no guard lets through. Few missions need it.
  [[nodiscard]] Interval guardedRange(const Statement& statement, size_t argument) {
    if (!guarded_) {
      guarded_ = commandRanges(m_, proof_.proof_context.intervals);
    }
    const auto found = guarded_->find({&statement, argument});
    return found == guarded_->end() ? Interval{0, 0, true} : found->second;
  }

  void checkCases(const std::vector<Case>& cases) {
    for (const Case& c : cases) {
      checkBlock(c.action);
    }
  }

  void checkBlock(BlockId block) {
    forEachStatement(m_, block, [&](const Statement& statement) {
      if (statement.kind == StatementKind::Command) {
        checkEnvelope({&statement}, statement.range);
      }
    });
  }

  /// Checks depth, pitch, fin, pump and battery of each command; a number without a range is not
  /// checked. `place`: of all of them.
  void checkEnvelope(const std::vector<const Statement*>& commands,
                     const support::SourceRange& place) {
    for (const Statement* statement : commands) {
      const bool sloped = isDescent(statement->command) || isAscent(statement->command);
      if (sloped || statement->command == Command::Hover) {
        hold(place, *statement, 0, {envelope_.greatest_depth_m});
        holdUnderWater(place, *statement);
      }
      if (const auto part = partMoved(statement->command, envelope_)) {
        hold(place, *statement, 0, *part);
      }
      if (sloped && envelope_.steersBySpeed()) {
        hold(place, *statement, 1, {envelope_.fastest_m_s, "a speed of "});
        holdLeast(place, *statement, envelope_.slowest_m_s, support::diagnostics::speedTooSlow);
      } else if (sloped) {
        hold(place, *statement, 1, {envelope_.steepest_pitch_rad});
        holdLeast(place, *statement, envelope_.shallowest_pitch_rad,
                  support::diagnostics::pitchTooShallow);
      }
    }
  }

  void hold(const support::SourceRange& place, const Statement& statement, size_t argument,
            const Part& part) {
    const auto greatest = [](const Interval& given) {
      return given.empty ? 0 : std::max(given.highest, -given.lowest);
    };
    const double plain = greatest(range(statement, argument));
    if (plain >= kNoBound || plain <= part.most) {
      return;
    }
    const double given = greatest(guardedRange(statement, argument));
    if (given <= part.most) {
      return;
    }
    const support::SourceRange where = placeOf(place, statement, argument);
    if (!isNew(where)) {
      return;
    }
    const Type type = m_[statement.values.at(argument)].type;
    const auto text = [&](double value) {
      return part.unit > 0 ? fmt::format("{:.4g} {}", value / part.unit, part.symbol)
                           : shown(value, type);
    };
    auto report =
        proof_.diagnostics.report(support::diagnostics::commandBeyondEnvelope, where,
                                  fmt::format("{}{}", part.what, text(given)),
                                  part.most > 0 ? "beyond the vehicle's limit of " + text(part.most)
                                                : fmt::format("but {}", part.lacks));
    if (part.most > 0 && isFixed(range(statement, argument)) && where != place) {
      report.hint(fmt::format("write at most `{}`", text(part.most)));
    }
  }

  /// Whether it is one value, as it is written.
  static bool isFixed(const Interval& range) {
    return !range.empty && range.lowest == range.highest;
  }

  /// A depth slightly above the surface is not a depth to fly to, but it is not an error either.
  void holdUnderWater(const support::SourceRange& place, const Statement& statement) {
    const Interval& depth = range(statement, 0);
    if (depth.empty || depth.highest >= 0) {
      return;
    }
    const support::SourceRange where = placeOf(place, statement, 0);
    if (isNew(where)) {
      in_the_air_.insert(place.begin);
      const Type type = m_[statement.values.at(0)].type;
      auto report = proof_.diagnostics.report(support::diagnostics::commandBeyondEnvelope, where,
                                              shown(depth.highest, type), "above the surface");
      if (isFixed(depth) && where != place) {
        report.hint(fmt::format("depths are positive: write `{}`", shown(-depth.highest, type)));
      } else if (isFixed(depth)) {  // no argument has it: a behaviour works it out
        report.hint("change the arguments that it is computed from: depths are positive");
      }
    }
  }

  /// The magnitude of a pitch or speed must be `limit` or more.
  void holdLeast(const support::SourceRange& place, const Statement& statement, double limit,
                 support::DiagnosticId below) {
    const auto least = [](const Interval& given) {
      return std::max({given.lowest, -given.highest, 0.0});
    };
    const Interval& plain = range(statement, 1);
    if (plain.empty || plain.highest - plain.lowest >= kNoBound || least(plain) >= limit) {
      return;
    }
    const Interval given = guardedRange(statement, 1);
    if (given.empty || least(given) >= limit) {
      return;
    }
    const support::SourceRange where = placeOf(place, statement, 1);
    if (isNew(where)) {
      const Type type = m_[statement.values.at(1)].type;
      proof_.diagnostics.report(below, where, shown(least(given), type), shown(limit, type));
    }
  }

  /// Where the value of a fixed argument is written in the call of a profile or route at `place`:
  /// the one expression there that always has it; empty if there is none, or several.
  [[nodiscard]] std::optional<support::SourceRange> writtenIn(const support::SourceRange& place,
                                                              const Interval& fixed) const {
    std::optional<support::SourceRange> found;
    for (uint32_t i = 0; isFixed(fixed) && i < m_.exprs.size(); ++i) {
      const support::SourceRange& own = m_.exprs[i].range;
      const Interval& value = proof_.proof_context.intervals[i];
      const bool inside =
          own.valid() && own.file == place.file && own.begin > place.begin && own.end < place.end;
      if (!inside || !isFixed(value) || value.lowest != fixed.lowest || own == found) {
        continue;
      }
      if (found && !(own.begin <= found->begin && found->end <= own.end)) {
        return std::nullopt;
      }
      found = own;  // the whole of `-(20 m)`
    }
    return found;
  }

  /// An argument that is written at `place` itself or in its call, or all of `place`. It looks at
  /// all expressions: only for what is reported.
  [[nodiscard]] support::SourceRange placeOf(const support::SourceRange& place,
                                             const Statement& statement, size_t argument) const {
    const support::SourceRange& own = m_[statement.values.at(argument)].range;
    const bool within = place == statement.range && own.file == place.file &&
                        own.begin >= place.begin && own.end <= place.end;
    return within ? own : writtenIn(place, range(statement, argument)).value_or(place);
  }

  /// One report for each profile, route and argument of a command.
  bool isNew(const support::SourceRange& place) {
    return told_.emplace(place.file, place.begin).second;
  }

  /// A profile that climbs and dives turns where the one ends and the other begins.
  void checkTurns(const State& state) {
    if (in_the_air_.contains(state.profile.range.begin)) {
      return;  // it then clearly does not turn there either
    }
    Interval down{kEndless, -kEndless, true};
    Interval up = down;
    for (const Statement* statement : commands_) {
      if (isDescent(statement->command)) {
        widen(down, range(*statement, 0));
      } else if (isAscent(statement->command)) {
        widen(up, range(*statement, 0));
      }
    }
    const bool judged =
        !down.empty && !up.empty && up.lowest <= kNoBound && down.highest >= -kNoBound;
    if (judged && (up.lowest >= down.highest || !(surelyTurns() || canTurn(state)))) {
      auto report = proof_.diagnostics.report(support::diagnostics::profileTurnedRound,
                                              state.profile.range, depths(up), depths(down));
      if (isFixed(up) && isFixed(down) && down.lowest < up.lowest) {
        report.hint(fmt::format("put the shallower depth first: `{}` before `{}`", depths(down),
                                depths(up)));
      }
    } else if (judged && !surelyTurns() && isUpsideDown(state)) {
      proof_.diagnostics.report(support::diagnostics::profileUpsideDown, state.profile.range);
    }
  }

  /// Whether every climb leads below where every dive leads, as long as no variable changes that
  /// the profile does not set itself.
  bool isUpsideDown(const State& state) {
    std::vector<bool> own(m_.variables.size(), false);
    const auto look = [&](const Statement& s) {
      if (s.kind == StatementKind::Set) {
        own[s.variable.index] = true;
      }
    };
    forEachStatement(m_, state.profile.entry, look);
    for (const Case& c : state.profile.cases) {
      forEachStatement(m_, c.action, look);
    }
    Unknowns unknowns(proof_.context);
    SymbolicState climbing(unknowns, proof_.proof_context);
    if (!fix(own, climbing)) {
      return false;
    }
    SymbolicState diving = climbing;
    z3::expr turns = proof_.context.bool_val(false);
    for (const Statement* up : commands_) {
      for (const Statement* down : commands_) {
        if (isAscent(up->command) && isDescent(down->command)) {
          turns = turns || climbing.number(up->values.at(0)).value <=
                               diving.number(down->values.at(0)).value;
        }
      }
    }
    Question question(proof_.context, proof_.checks, proof_.options.effort);
    question.add(unknowns);
    question.add(turns);
    return question.ask() == Answer::No;
  }

  /// Whether some climb leads above where some dive leads, for all their values: most profiles have
  /// fixed depths, so the solver is not needed.
  [[nodiscard]] bool surelyTurns() const {
    const auto known = [&](const Statement* statement) {
      return proof_.proof_context.known.expressions[statement->values.at(0).index];
    };
    return std::ranges::any_of(commands_, [&](const Statement* up) {
      return isAscent(up->command) && known(up) &&
             std::ranges::any_of(commands_, [&](const Statement* down) {
               return isDescent(down->command) && known(down) &&
                      range(*up, 0).highest < range(*down, 0).lowest;
             });
    });
  }

  /// Whether some climb of the profile leads above where some dive leads: `yo(layer + 5 m, layer +
  /// 5 m, …)` does not, for any `layer`, unless `layer` changes while the profile flies. The two
  /// commands are given at different times: only what does not change has one value for both.
  bool canTurn(const State& state) {
    Unknowns unknowns(proof_.context);
    SymbolicState climbing(unknowns, proof_.proof_context);
    (void)fix(setWhileCurrent(m_, state), climbing);
    SymbolicState diving = climbing;
    z3::expr turns = proof_.context.bool_val(false);
    for (const Statement* up : commands_) {
      for (const Statement* down : commands_) {
        if (isAscent(up->command) && isDescent(down->command)) {
          const NumberTerm top = climbing.number(up->values.at(0));
          const NumberTerm bottom = diving.number(down->values.at(0));
          turns = turns || (top.known && bottom.known && top.value < bottom.value);
        }
      }
    }
    Question question(proof_.context, proof_.checks, proof_.options.effort);
    question.add(unknowns);
    question.add(turns);
    return question.ask() != Answer::No;
  }

  /// Gives a value to each variable that the commands read, except for those of `set`; false if
  /// there is none.
  [[nodiscard]] bool fix(const std::vector<bool>& set, SymbolicState& moment) const {
    bool fixed = false;
    for (const Statement* statement : commands_) {
      for (const ExprId value : statement->values) {
        forEachIn(m_, value, [&](const Expr& e) {
          if (e.op != Op::Variable || set[e.variable.index]) {
            return;
          }
          if (e.type.kind == TypeKind::Bool) {
            (void)moment.truthOf(e.variable);
          } else {
            (void)moment.numberOf(e.variable);
          }
          fixed = true;
        });
      }
    }
    return fixed;
  }

  static std::string depths(const Interval& range) {
    constexpr Type kLength{TypeKind::Quantity, support::dimension::length};
    return range.lowest == range.highest ? withUnit(range.lowest, kLength)
                                         : fmt::format("{} to {}", withUnit(range.lowest, kLength),
                                                       withUnit(range.highest, kLength));
  }

  static void widen(Interval& all, const Interval& one) {
    if (!one.empty) {
      all = {std::min(all.lowest, one.lowest), std::max(all.highest, one.highest), false};
    }
  }

  Proof& proof_;
  const Mission& m_;
  const platforms::Envelope& envelope_;
  std::vector<const Statement*> commands_;  ///< of the current profile
  std::optional<std::map<CommandArgument, Interval>> guarded_;
  std::set<std::pair<uint32_t, uint32_t>> told_;
  std::set<uint32_t> in_the_air_;  ///< profiles that command a depth above the surface
};

}  // namespace

void passes::commands(Proof& proof) {
  CommandCheck(proof).run();
}

}  // namespace glider::ir::prove
