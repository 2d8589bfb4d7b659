// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/difference/compare_missions.h"

#include "analysis/difference/canonical_text.h"
#include "analysis/difference/compare_cases.h"
#include "analysis/difference/match_states.h"
#include "ir/verify/value_text.h"
#include "support/one_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace glider::analysis {
namespace {

using ir::StateId;

/// One of the two versions.
struct Version {
  Version(const compiler::Checked& checked, std::vector<std::string> names)
      : m(checked.mission()), sources(checked.sources()), text(m, std::move(names)) {}

  /// As the pilot wrote it; for the text form of the IR there may be nothing.
  [[nodiscard]] std::string written(const support::SourceRange& range) const {
    return range.valid() ? support::onOneLine(sources.text(range))
                         : std::string("(not in the text)");
  }

  const ir::Mission& m;
  const support::SourceManager& sources;
  CanonicalText text;
};

std::string valueText(const ir::Mission& m, const ir::Variable& v) {
  std::string text = "no initial value";
  if (v.initial.valid()) {
    const ir::Expr& e = m[v.initial];
    text = e.op == ir::Op::Constant ? ir::withUnit(e.number, e.type)
           : e.op == ir::Op::True   ? "true"
           : e.op == ir::Op::False  ? "false"
                                    : "computed";
  }
  const bool ranged = v.lowest > -ir::Variable::kEndless || v.highest < ir::Variable::kEndless;
  return ranged ? fmt::format("{} in {}", text, ir::rangeText(v)) : text;
}

/// Compares the matched states and their parts as canonical text, so that only what a flight can
/// show is a difference. What it finds equal behaves the same; what differs in text may still
/// behave the same.
class Comparison {
 public:
  Comparison(const compiler::Checked& before, const compiler::Checked& after)
      : matched_(matchStates(before.mission(), after.mission())),
        old_(before, matched_.old_names),
        new_(after, matched_.new_names) {}

  MissionDifference run() {
    compareSettings();
    compareVariables();
    compareShares();
    compareStates();
    part("`always`", casesOf(old_.m.always, new_.m.always));
    for (const auto& [before, after] : matched_.pairs) {
      compareState(before, after);
    }
    for (const auto& [before, after] : matched_.renamed) {
      found_.renamed.push_back(
          fmt::format("`{}` is now `{}`", old_.m[before].name, new_.m[after].name));
    }
    found_.old_names = matched_.old_names;
    found_.new_names = matched_.new_names;
    return std::move(found_);
  }

 private:
  void part(std::string title, std::vector<std::string> lines) {
    if (!lines.empty()) {
      found_.parts.push_back({std::move(title), std::move(lines)});
    }
  }

  static std::string change(const std::string& what, const std::string& before,
                            const std::string& after) {
    return fmt::format("{}: {} → {}", what, before, after);
  }

  void compareSettings() {
    std::vector<std::string> lines;
    if (old_.m.platform != new_.m.platform) {
      lines.push_back(change("platform", old_.m.platform, new_.m.platform));
    }
    if (old_.m.resume_within_s != new_.m.resume_within_s) {
      lines.push_back(change("resume within", fmt::format("{:.6g} s", old_.m.resume_within_s),
                             fmt::format("{:.6g} s", new_.m.resume_within_s)));
    }
    if (old_.m.new_after_restart != new_.m.new_after_restart) {
      lines.push_back(change("after a restart of the vehicle",
                             old_.m.new_after_restart ? "is over" : "continues",
                             new_.m.new_after_restart ? "is over" : "continues"));
    }
    if (old_.m.nap_s != new_.m.nap_s) {
      lines.push_back(change("nap at most", napText(old_.m), napText(new_.m)));
    }
    if (old_.m.pack != new_.m.pack) {
      lines.push_back(change("pack", packText(old_.m), packText(new_.m)));
    }
    if (declination(old_.m) != declination(new_.m)) {
      lines.emplace_back("the declination of the compass differs");
    }
    const std::string& first = old_.text.names().front();
    if (first != new_.text.names().front()) {
      lines.push_back(
          change("first state", "`" + first + "`", "`" + new_.m.states.front().name + "`"));
    }
    part("mission", std::move(lines));
    part("conditions of parameters", conditions());
  }

  static std::string napText(const ir::Mission& m) {
    return m.nap_s ? fmt::format("{:.6g} s", *m.nap_s) : "none";
  }

  static std::string packText(const ir::Mission& m) {
    constexpr double kCoulombs = 3600;
    return m.pack ? fmt::format("{:.6g} Ah at {:.6g} V, reserve {:.6g} %",
                                m.pack->capacity_C / kCoulombs, m.pack->voltage_V,
                                m.pack->reserve * 100)
                  : "none";
  }

  static std::optional<double> declination(const ir::Mission& m) {
    return m.compass ? m.compass->declination : std::nullopt;
  }

  std::vector<std::string> conditions() {
    const auto of = [](Version& version) {
      std::map<std::string, std::string> all;
      for (const ir::ExprId id : version.m.conditions) {
        all.emplace(version.text.expression(id), version.written(version.m[id].range));
      }
      return all;
    };
    return addedAndRemoved(of(old_), of(new_));
  }

  /// `before`, `after`: how things are shown, by what they are.
  static std::vector<std::string> addedAndRemoved(const std::map<std::string, std::string>& before,
                                                  const std::map<std::string, std::string>& after) {
    std::vector<std::string> lines;
    for (const auto& [key, shown] : before) {
      if (!after.contains(key)) {
        lines.push_back("removed: " + shown);
      }
    }
    for (const auto& [key, shown] : after) {
      if (!before.contains(key)) {
        lines.push_back("added: " + shown);
      }
    }
    return lines;
  }

  /// Parameters and variables of the mission; those of states are compared with them.
  void compareVariables() {
    for (const auto& [kind, title] : {std::pair(ir::VariableKind::Parameter, "parameters"),
                                      std::pair(ir::VariableKind::Mission, "variables")}) {
      part(title, variables([kind](const ir::Variable& v) { return v.kind == kind; },
                            [kind](const ir::Variable& v) { return v.kind == kind; }));
    }
  }

  static std::map<std::string, std::string> sharesOf(const ir::Mission& m) {
    std::map<std::string, std::string> texts;
    for (const ir::Share& share : m.shares) {
      texts[share.name] = fmt::format("{} values from {:.9g} in steps of {:.9g}, every {:g} s",
                                      share.values, share.lowest, share.step, share.period_s);
    }
    return texts;
  }

  static std::string namesOf(const std::vector<std::string>& vehicles) {
    return vehicles.empty() ? "nowhere" : fmt::format("`{}`", fmt::join(vehicles, "`, `"));
  }

  /// Any of them changes what other vehicles understand.
  void compareShares() {
    const auto before = sharesOf(old_.m), after = sharesOf(new_.m);
    std::vector<std::string> lines;
    for (const auto& [name, text] : before) {
      const auto same = after.find(name);
      if (same == after.end()) {
        lines.push_back(fmt::format("removed: `{}`", name));
      } else if (same->second != text) {
        lines.push_back(fmt::format("changed: `{}`, {}; now {}", name, text, same->second));
      }
    }
    for (const auto& [name, text] : after) {
      if (!before.contains(name)) {
        lines.push_back(fmt::format("added: `{}`, {}", name, text));
      }
    }
    if (old_.m.vehicles != new_.m.vehicles) {
      lines.push_back(fmt::format("the vehicles are now named {}, before {}",
                                  namesOf(new_.m.vehicles), namesOf(old_.m.vehicles)));
    }
    part("shares", std::move(lines));
  }

  template <typename IsOld, typename IsNew>
  std::vector<std::string> variables(IsOld is_old, IsNew is_new) {
    std::map<std::string, const ir::Variable*> before;
    for (const ir::Variable& v : old_.m.variables) {
      if (is_old(v)) {
        before[old_.text.nameOf(v)] = &v;
      }
    }
    std::vector<std::string> lines;
    for (const ir::Variable& v : new_.m.variables) {
      if (!is_new(v)) {
        continue;
      }
      const auto same = before.find(new_.text.nameOf(v));
      if (same == before.end()) {
        lines.push_back(fmt::format("added: `{}`, {}", v.name, valueText(new_.m, v)));
        continue;
      }
      if (old_.text.variable(*same->second) != new_.text.variable(v)) {
        lines.push_back(
            change("`" + v.name + "`", valueText(old_.m, *same->second), valueText(new_.m, v)));
      }
      before.erase(same);
    }
    for (const auto& [name, v] : before) {
      lines.push_back(fmt::format("removed: `{}`, {}", v->name, valueText(old_.m, *v)));
    }
    return lines;
  }

  void compareStates() {
    std::vector<std::string> lines;
    for (const StateId id : matched_.removed) {
      lines.push_back("removed: `" + old_.m[id].name + "`");
    }
    for (const StateId id : matched_.added) {
      lines.push_back("added: `" + new_.m[id].name + "`");
    }
    part("states", std::move(lines));
  }

  std::vector<std::string> casesOf(const std::vector<ir::Case>& before,
                                   const std::vector<ir::Case>& after) {
    return compareCases(listOf(old_, before), listOf(new_, after));
  }

  static std::vector<ListedCase> listOf(Version& version, const std::vector<ir::Case>& cases) {
    std::vector<ListedCase> all;
    for (const ir::Case& c : cases) {
      all.push_back(
          {version.text.oneCase(c), version.text.expression(c.guard), version.written(c.range)});
    }
    return all;
  }

  void compareActivities(StateId before, StateId after, std::vector<std::string>& lines) {
    for (const auto& [what, of, kind] :
         {std::tuple("flightprofile", &ir::State::profile, ir::VariableKind::Profile),
          std::tuple("flightroute", &ir::State::route, ir::VariableKind::Route)}) {
      const ir::Activity& old_one = old_.m[before].*of;
      const ir::Activity& new_one = new_.m[after].*of;
      if (old_.text.activity(old_one, before, kind) == new_.text.activity(new_one, after, kind)) {
        continue;
      }
      const std::string was = old_.written(old_one.range);
      const std::string is = new_.written(new_one.range);
      lines.push_back(was == is ? fmt::format("{} `{}` is defined differently", what, is)
                                : change(what, was, is));
    }
  }

  void compareState(StateId before, StateId after) {
    const ir::State& was = old_.m[before];
    const ir::State& is = new_.m[after];
    std::vector<std::string> lines;
    if (old_.text.parameters(was) != new_.text.parameters(is)) {
      lines.push_back(change("parameters", "(" + old_.written(was.formals) + ")",
                             "(" + new_.written(is.formals) + ")"));
    }
    compareActivities(before, after, lines);
    if (old_.text.logged(was) != new_.text.logged(is)) {
      lines.push_back(change("logged", logged(was), logged(is)));
    }
    if (old_.text.sampled(was) != new_.text.sampled(is)) {
      lines.push_back(change("instruments", sampled(was), sampled(is)));
    }
    if (old_.text.block(was.entry) != new_.text.block(is.entry)) {
      lines.emplace_back("`entry` differs");
    }
    for (std::string& line : casesOf(was.cases, is.cases)) {
      lines.push_back(std::move(line));
    }
    const auto own = [](StateId owner) {
      return [owner](const ir::Variable& v) {
        return v.owner == owner && v.kind == ir::VariableKind::State;
      };
    };
    for (std::string& line : variables(own(before), own(after))) {
      lines.push_back("variable " + std::move(line));
    }
    part("state `" + is.name + "`", std::move(lines));
  }

  static std::string logged(const ir::State& state) {
    std::string text;
    for (const ir::LogItem& item : state.log) {
      text += (text.empty() ? "" : ", ") + item.name +
              (item.period_s > 0 ? fmt::format(" every {:.6g} s", item.period_s) : "");
    }
    return text.empty() ? "nothing" : text;
  }

  static std::string sampled(const ir::State& state) {
    std::string text;
    for (const ir::Sampling& one : state.sampling) {
      text +=
          (text.empty() ? "" : ", ") + one.instrument + (one.words.empty() ? "" : " ") + one.words;
    }
    return text.empty() ? "as the vehicle's mission says" : text;
  }

  MatchedStates matched_;
  Version old_;
  Version new_;
  MissionDifference found_;
};

}  // namespace

MissionDifference compareMissions(const compiler::Checked& before, const compiler::Checked& after) {
  return Comparison(before, after).run();
}

}  // namespace glider::analysis
