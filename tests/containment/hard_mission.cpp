// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/containment/hard_mission.h"

#include "ir/core/ops.h"
#include "ir/text/read.h"
#include "ir/verify/verify.h"
#include "support/check.h"
#include "support/diagnostics/render.h"
#include "tests/containment/hard_expressions.h"

#include <fmt/format.h>

namespace glider::containment {
namespace {

using ir::Command;
using ir::ListKind;
using ir::StatementKind;
using ir::TemporalKind;
using ir::Transition;

constexpr const char* kHeader = R"(glider_ir 1
mission hard platform slocum
sensor depth: length vehicle m_depth id 1 encoding linear to_si 1 lowest 0 highest 200 stale_after 20
sensor altitude: length vehicle m_altitude id 2 encoding linear to_si 1 lowest 0 highest 90 stale_after 60
sensor count: number vehicle m_count id 3 encoding linear to_si 1 lowest -3 highest 9 stale_after 20
sensor gap: time vehicle m_gap id 4 encoding linear to_si 60 lowest 0 highest 30 stale_after 20
sensor heading: angle vehicle m_heading id 5 encoding linear to_si 1 lowest 0 highest 6.3 stale_after 20
sensor lat: latitude vehicle m_lat id 6 encoding degrees_minutes to_si 1 lowest 3800 highest 4000 stale_after 600
sensor lon: longitude vehicle m_lon id 7 encoding degrees_minutes to_si 1 lowest 200 highest 400 stale_after 600
sensor ping: length symbol gliderTestPing id 65280 encoding linear to_si 1 lowest -5 highest 20 stale_after 12
behaviour profile inc symbol gliderProfileRecord () reads ()
behaviour route inc symbol gliderRouteRecord () reads ()
behaviour profile written symbol "" () reads ()
behaviour route written symbol "" () reads ()
)";

constexpr const char* kTables = R"(table latitude (39.1, 39.2, 39.3)
table longitude (2.5, 2.6, 2.7)
function level symbol gliderTestLevel (): length lowest -5 highest 20
function mixed symbol gliderTestMixed (a: number, b: length, c: bool): number lowest -100 highest 100
use level
use mixed
)";

struct Variable {
  std::string name;
  Kind kind = Kind::Number;
  ir::VariableKind of = ir::VariableKind::Mission;
  double lowest = 0, highest = 0;
  std::optional<uint32_t> state = std::nullopt;
  [[nodiscard]] std::string read() const { return fmt::format("(var \"{}\")", name); }
};

class Maker {
 public:
  Maker(uint64_t seed, bool simple) : random_(seed), expressions_(random_), simple_(simple) {}

  std::string text() {
    states_ = random_.between(1, 6);
    gone_to_ = random_.between(1, states_);
    text_ = kHeader;
    variables();
    text_ += kTables;
    initials();
    temporals();
    constexpr double kResume[] = {0, 20, 21, 300, 3600};
    text_ += fmt::format("resume within {}\n", random_.pick(kResume));
    always();
    for (uint32_t i = 0; i < states_; ++i) {
      state(i);
    }
    return text_;
  }

 private:
  static constexpr const char* kOwners[] = {"parameter", "mission", "argument",
                                            "state",     "profile", "route"};

  void declare(Variable v) {
    text_ += fmt::format("variable \"{}\": {} {}", v.name, typeText(v.kind),
                         kOwners[static_cast<size_t>(v.of)]);
    text_ += v.state ? fmt::format(" of s{}", *v.state) : "";
    text_ +=
        v.kind == Kind::Truth ? "\n" : fmt::format(" lowest {} highest {}\n", v.lowest, v.highest);
    expressions_.add({v.read(), v.kind, v.state, std::nullopt});
    variables_.push_back(std::move(v));
  }

  void variables() {
    const auto parameter = ir::VariableKind::Parameter;
    declare({"pl", Kind::Length, parameter, 0, random_.chance(0.5) ? 40.0 : 0});
    declare({"pt", Kind::Time, parameter, 0, random_.chance(0.5) ? 300.0 : 20});
    declare({"pn", Kind::Number, parameter, 1, 3});
    declare({"n", Kind::Number, ir::VariableKind::Mission, 0, 1.0 * random_.between(1, 4)});
    declare({"ml", Kind::Length, ir::VariableKind::Mission, 3, 40});
    declare({"mt", Kind::Time, ir::VariableKind::Mission, -20, 600});
    declare({"when", Kind::Time, ir::VariableKind::Mission, 0, 1e9});
    declare({"mb", Kind::Truth, ir::VariableKind::Mission});
    for (uint32_t i = 0; i < states_; ++i) {
      // The same ranges in all states: they may be passed on, and swapped.
      for (const char* name : {"a", "b"}) {
        if (i > 0) {
          declare(
              {fmt::format("s{}.{}", i, name), Kind::Length, ir::VariableKind::Argument, 5, 80, i});
        }
      }
      declare({fmt::format("s{}.v", i), Kind::Length, ir::VariableKind::State, -10, 60, i});
      declare({fmt::format("s{}.w", i), Kind::Number, ir::VariableKind::Profile, -10, 60, i});
      declare({fmt::format("s{}.p", i), Kind::Truth, ir::VariableKind::Profile, 0, 0, i});
      declare({fmt::format("s{}.r", i), Kind::Truth, ir::VariableKind::Route, 0, 0, i});
    }
  }

  /// Within the variable's range, or what has that range already.
  std::string within(const Variable& v, const std::string& value) {
    if (v.kind == Kind::Truth) {
      return value;
    }
    return fmt::format("(clamp {} {}:{} {}:{})", value, v.lowest, typeText(v.kind), v.highest,
                       typeText(v.kind));
  }

  void initials() {
    expressions_.stand(ListKind::Always, std::nullopt);
    text_ += fmt::format("initial pl {}:length\ninitial pt {}:time\ninitial pn 2\n",
                         variables_[0].highest,
                         random_.chance(0.5) ? variables_[1].highest : variables_[1].lowest);
    for (const Variable& v : variables_) {
      if (v.of == ir::VariableKind::Parameter || v.of == ir::VariableKind::Argument) {
        continue;
      }
      const std::string unknown = v.kind == Kind::Length ? "(sensor altitude)" : "";
      const std::string value = v.name == "when" ? "0:time"
                                : !unknown.empty() && random_.chance(0.2)
                                    ? unknown
                                    : expressions_.constant(v.kind);
      text_ +=
          fmt::format("initial \"{}\" {}\n", v.name, v.name == "when" ? value : within(v, value));
    }
  }

  void temporals() {
    for (uint32_t number = 0; number < 6; ++number) {
      const auto list = static_cast<ListKind>(random_.below(4));
      const auto kind = static_cast<TemporalKind>(random_.below(12));
      const std::optional<uint32_t> state =
          list == ListKind::Always ? std::nullopt : std::optional(random_.below(states_));
      constexpr const char* kLists[] = {"always", "state", "profile", "route"};
      expressions_.stand(list, state);
      const std::string where =
          state ? fmt::format("{} s{}", kLists[static_cast<size_t>(list)], *state) : kLists[0];
      text_ += watched(kind, where) + "\n";
      const bool truth = kind == TemporalKind::Became || kind == TemporalKind::Held;
      const Kind gives = truth ? Kind::Truth
                         : kind == TemporalKind::Slope || kind == TemporalKind::Steepest ||
                                 kind == TemporalKind::Number
                             ? Kind::Number
                             : Kind::Length;
      expressions_.add({fmt::format("(temporal {})", number), gives, state, list});
    }
  }

  std::string watched(TemporalKind kind, const std::string& where) {
    const std::string truth = random_.chance(0.3) ? "true" : expressions_.of(Kind::Truth, 1);
    constexpr const char* kAlong[] = {"", "", " along (sensor heading)"};
    constexpr double kLengths[] = {4, 8, 60};
    const double length = random_.pick(kLengths);
    const std::string window =
        fmt::format("{} (sensor {}) over {}{}", where, random_.chance(0.5) ? "depth" : "altitude",
                    length, random_.pick(kAlong));
    const std::string leg = fmt::format("over {} 0 {} along (sensor gap)",
                                        random_.chance(0.5) ? "this" : "last", random_.below(2));
    const std::string compared =
        fmt::format("{} (sensor depth) where (sensor altitude) {}", where, leg);
    switch (kind) {
      case TemporalKind::Became:
        return fmt::format("temporal became {} {}", where, truth);
      case TemporalKind::Held:
        return fmt::format("temporal held {} {} for {}", where, truth, expressions_.duration());
      case TemporalKind::Mean:
        return "temporal mean " + (random_.chance(0.3) ? where + " (sensor depth) " + leg : window);
      case TemporalKind::Lowest:
        return "temporal lowest " + window;
      case TemporalKind::Highest:
        return "temporal highest " + window;
      case TemporalKind::Spread:
        return "temporal spread " + window;
      case TemporalKind::Slope:
        return fmt::format("temporal slope {} (sensor gap) over {}", where, length);
      case TemporalKind::AtLowest:
        return "temporal at_lowest " + compared;
      case TemporalKind::AtHighest:
        return "temporal at_highest " + compared;
      case TemporalKind::Steepest:
        return "temporal steepest " + compared;
      case TemporalKind::AtSteepest:
        return "temporal at_steepest " + compared;
      case TemporalKind::Number:
        return fmt::format("temporal number {} (sensor gap) {}", where, leg);
    }
    return {};
  }

  std::string block(uint32_t depth) {
    std::string text;
    for (uint32_t k = random_.between(1, 3); k > 0; --k) {
      text += statement(static_cast<StatementKind>(random_.below(4)), depth);
    }
    return text;
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  std::string statement(StatementKind kind, uint32_t depth) {
    switch (kind) {
      case StatementKind::Set:
        return set();
      case StatementKind::If: {
        if (depth == 0) {
          return set();
        }
        // Often of a sensor, which may be unknown: neither branch runs.
        const std::string condition =
            random_.chance(0.5)
                ? fmt::format("(gt (sensor altitude) {})", expressions_.constant(Kind::Length))
                : expressions_.guard();
        if (random_.chance(0.3)) {  // both set the same: only an unknown condition keeps it
          return fmt::format("if {} set \"mt\" 60:time else set \"mt\" 90:time end\n", condition);
        }
        const std::string yes = block(depth - 1);
        return fmt::format("if {} {} {} end\n", condition, yes,
                           random_.chance(0.5) ? "else " + block(depth - 1) : "");
      }
      case StatementKind::Log:
        return fmt::format("log \"note\" ({})\n", expressions_.anything(1));
      case StatementKind::Command:
        return command(random_.pick(ir::commands()).command);
    }
    return {};
  }

  std::string set() {
    std::vector<const Variable*> settable;
    for (const Variable& v : variables_) {
      if (v.of != ir::VariableKind::Parameter && v.of != ir::VariableKind::Argument &&
          (!v.state || v.state == state_)) {
        settable.push_back(&v);
      }
    }
    const Variable& v = *random_.pick(settable);
    if (v.name == "when") {
      return "set \"when\" (min missiontime 1e9:time)\n";
    }
    return fmt::format("set \"{}\" {}\n", v.name, within(v, expressions_.of(v.kind, 2)));
  }

  std::string commandedDepth() {
    const std::string value = expressions_.of(Kind::Length, 1);
    return random_.chance(0.7) ? fmt::format("(clamp {} {}:length {}:length)", value,
                                             random_.pick(kTops), random_.pick(kDeeps))
                               : value;
  }

  std::string command(Command command) {
    const bool heading =
        command == Command::Steer || command == Command::Drift || command == Command::Fin;
    switch (only_waypoints_ && heading ? Command::SteerTo : command) {
      case Command::Descend:
        return fmt::format("descend ({}, 0.4:angle)\n", commandedDepth());
      case Command::Ascend:
        return fmt::format("ascend ({}, 0.4:angle)\n", commandedDepth());
      case Command::DescendAt:
        return fmt::format("descend_at ({}, 1.2:speed)\n", commandedDepth());
      case Command::AscendAt:
        return fmt::format("ascend_at ({}, 1.2:speed)\n", commandedDepth());
      case Command::Hover:
        return fmt::format("hover ({})\n", commandedDepth());
      case Command::Surface:
        return "surface ()\n";
      case Command::Steer:
        return fmt::format("steer ({})\n", expressions_.of(Kind::Angle, 1));
      case Command::SteerTo:
        return steerTo();
      case Command::Drift:
        return "drift ()\n";
      case Command::Pump:
        return fmt::format("pump ({})\n", random_.pick(kPumps));
      case Command::Battery:
        return fmt::format("battery ({})\n", random_.pick(kBatteries));
      case Command::Fin:
        return fmt::format("fin ({})\n", expressions_.of(Kind::Angle, 1));
    }
    return {};
  }

  /// A place of the path, a fixed one, or one in a box.
  std::string steerTo() {
    const std::string row = expressions_.of(Kind::Number, 1);
    switch (random_.below(3)) {
      case 0:
        return fmt::format("steer_to ((element 0 {}), (element 1 {}))\n", row, row);
      case 1:
        return fmt::format("steer_to ({}, {})\n", expressions_.constant(Kind::Latitude),
                           expressions_.constant(Kind::Longitude));
      default:
        return "steer_to ((clamp (sensor lat) 39:latitude 39.5:latitude), (clamp (sensor lon) "
               "2.5:longitude 2.75:longitude))\n";
    }
  }

  std::string action() { return random_.chance(0.5) ? "do " + block(1) + "end " : ""; }

  /// Swapped, passed on, or computed.
  std::string arguments(uint32_t target) {
    if (target == 0) {
      return "";
    }
    if (state_ && *state_ > 0 && random_.chance(0.6)) {
      const bool swap = random_.chance(0.7);
      return fmt::format(" ((var \"s{}.{}\"), (var \"s{}.{}\"))", *state_, swap ? "b" : "a",
                         *state_, swap ? "a" : "b");
    }
    const auto one = [&] {
      return fmt::format("(clamp {} 5:length 80:length)", expressions_.of(Kind::Length, 1));
    };
    const std::string first = one();
    return fmt::format(" ({}, {})", first, one());
  }

  std::string transition(Transition transition, uint32_t from) {
    switch (transition) {
      case Transition::Goto: {
        const uint32_t target = random_.below(gone_to_);
        return fmt::format("goto s{}{}", target, arguments(target));
      }
      case Transition::Call: {
        const uint32_t first = std::max(gone_to_, from + 1);
        if (first >= states_) {
          return "stay";
        }
        const uint32_t target = random_.between(first, states_ - 1);
        return fmt::format("call s{}{}", target, arguments(target));
      }
      case Transition::Return:
        return state_ && *state_ >= gone_to_ ? "return" : "stay";
      case Transition::Exit:
        return "exit";
      case Transition::Stay:
        return "stay";
      case Transition::Done:
        return "done";
    }
    return {};
  }

  std::string caseOf(Transition kind, uint32_t from) {
    const std::string guard = kind == Transition::Exit ? fmt::format("(ge missiontime {}:time)",
                                                                     random_.between(60, 4000))
                                                       : expressions_.guard();
    const std::string done = action();
    return fmt::format("case {} {}{}\n", guard, done, transition(kind, from));
  }

  void always() {
    expressions_.stand(ListKind::Always, std::nullopt);
    state_.reset();
    std::string cases;
    if (random_.chance(0.5)) {
      cases += caseOf(Transition::Exit, 0);
    }
    for (uint32_t k = random_.below(3); k > 0; --k) {
      constexpr Transition kKinds[] = {Transition::Stay, Transition::Call, Transition::Goto};
      cases += caseOf(simple_ ? Transition::Stay : random_.pick(kKinds), 0);
    }
    text_ += cases.empty() ? "" : "always\n" + cases;
  }

  std::string activity(uint32_t i, ListKind list) {
    const bool profile = list == ListKind::Profile;
    expressions_.stand(list, i);
    if (!only_waypoints_ && random_.chance(0.08)) {
      return fmt::format("{} inc ()\n", profile ? "profile" : "route");
    }
    constexpr Command kHeadings[] = {Command::Steer, Command::SteerTo, Command::Drift,
                                     Command::SteerTo, Command::Fin};
    constexpr Command kDepths[] = {Command::Descend, Command::Ascend,  Command::Hover,
                                   Command::Surface, Command::Surface, Command::Pump,
                                   Command::Battery};
    std::string entry =
        fmt::format("log \"deep\" ((le (sensor depth) {}:length))\n", random_.between(5, 200));
    entry += random_.chance(0.3) ? block(1) : "";
    entry += only_waypoints_ || random_.chance(0.8)
                 ? command(profile ? random_.pick(kDepths) : random_.pick(kHeadings))
                 : "";
    entry += random_.chance(0.1) ? block(1) : "";
    std::string text = fmt::format("{} written done \"s{}.{}\" begin entry do {} end\n",
                                   profile ? "profile" : "route", i, profile ? "p" : "r", entry);
    for (uint32_t k = random_.below(3); k > 0; --k) {
      text += caseOf(random_.chance(0.3) ? Transition::Done : Transition::Stay, i);
    }
    return text + "end\n";
  }

  void state(uint32_t i) {
    state_ = i;
    text_ +=
        fmt::format("state s{}{}\n", i, i == 0 ? "" : fmt::format(" (\"s{}.a\", \"s{}.b\")", i, i));
    text_ += activity(i, ListKind::Route);
    text_ += activity(i, ListKind::Profile);
    expressions_.stand(ListKind::State, i);
    text_ += random_.chance(0.4) ? "entry do " + block(1) + "end\n" : "";
    for (uint32_t k = random_.below(3); k > 0; --k) {
      constexpr Transition kKinds[] = {Transition::Stay, Transition::Call, Transition::Goto,
                                       Transition::Return, Transition::Exit};
      text_ += caseOf(random_.pick(kKinds), i);
    }
    leave(i);
  }

  /// A case by the clocks that leads on: forward, or round with a count, or back to the caller.
  void leave(uint32_t i) {
    constexpr const char* kClocks[] = {"statetime", "resumetime"};
    const std::string guard = fmt::format(
        "(ge {} {})", random_.pick(kClocks),
        random_.chance(0.7) ? fmt::format("{}:time", random_.between(0, 200)) : "(var \"pt\")");
    if (i >= gone_to_) {
      text_ += fmt::format("case {} return\n", guard);
      return;
    }
    const double most = variables_[3].highest;
    text_ += fmt::format("case (ge (var \"n\") {}) exit\n", most);
    // A state that enters itself swaps its own parameters.
    const uint32_t next = random_.chance(0.4) ? i : (i + 1) % gone_to_;
    const std::string called = random_.chance(0.5) ? transition(Transition::Call, i) : "stay";
    text_ += called == "stay" ? "" : fmt::format("case {} {}\n", expressions_.guard(), called);
    text_ += fmt::format("case {} do set \"n\" (min (add (var \"n\") 1) {}) end goto s{}{}\n",
                         guard, most, next, arguments(next));
  }

  static constexpr double kTops[] = {0, 3, 10};
  static constexpr const char* kPumps[] = {"-0.000233:volume", "-5e-05:volume", "0:volume",
                                           "0.000233:volume"};
  static constexpr const char* kBatteries[] = {"-0.02:length", "0:length", "0.02:length"};
  static constexpr double kDeeps[] = {10, 30, 90.5};

  random_missions::Random random_;
  HardExpressions expressions_;
  bool simple_;
  bool only_waypoints_ = random_.chance(0.4);
  uint32_t states_ = 1, gone_to_ = 1;
  std::string text_;
  std::vector<Variable> variables_;
  std::optional<uint32_t> state_;
};

}  // namespace

ir::Mission hardMission(uint64_t seed) {
  constexpr uint64_t kTries = 60;
  for (uint64_t attempt = 0; attempt < kTries; ++attempt) {
    const std::string text = Maker(seed * kTries + attempt, attempt > kTries / 2).text();
    support::SourceManager sources;
    support::DiagnosticEngine diagnostics;
    auto mission = ir::read(sources, sources.add("hard", text), diagnostics);
    if (!mission) {
      fmt::print(stderr, "{}\n{}", support::render(diagnostics, sources, false), text);
    }
    CHECK(mission.has_value(), "a hard mission cannot be read");
    ir::verify(*mission, diagnostics);
    if (!diagnostics.hasErrors()) {
      return *mission;
    }
  }
  CHECK(false, "no hard mission without errors");
}

}  // namespace glider::containment
