// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/graph_of.h"

#include "analysis/as_written.h"
#include "ir/verify/structure.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>
#include <set>

namespace glider::analysis {
namespace {

using report::GraphTransition;

GraphTransition transitionOf(ir::Transition transition) {
  switch (transition) {
    case ir::Transition::Goto:
      return GraphTransition::Goto;
    case ir::Transition::Call:
      return GraphTransition::Call;
    case ir::Transition::Return:
      return GraphTransition::Return;
    case ir::Transition::Exit:
      return GraphTransition::Exit;
    case ir::Transition::Stay:
    case ir::Transition::Done:
      break;
  }
  return GraphTransition::Stay;
}

/// Makes the drawing's data of a mission: states and transitions with the pilot's own text, those
/// that are proved never to fire or to be reached marked.
class GraphMaker {
 public:
  GraphMaker(const compiler::Lowered& lowered, const std::map<ir::CasePlace, bool>& dead)
      : sources_(*lowered.sources),
        in_the_language_(!lowered.standard_library.empty()),
        mission_(lowered.mission),
        dead_(dead),
        led_(mission_),
        structure_(mission_, placesOf(dead)) {}

  report::Graph run(const std::vector<ir::StateId>& deepest_path) {
    report::Graph graph;
    graph.mission = mission_.name;
    graph.platform = mission_.platform;
    for (uint32_t s = 0; s < mission_.states.size(); ++s) {
      graph.states.push_back(state(s));
    }
    graph.always = cases(ir::StateId(), mission_.always, structure_.always, "`always`");
    for (const ir::StateId id : deepest_path) {
      graph.deepest_path.push_back(id.index);
    }
    return graph;
  }

 private:
  static std::set<ir::CasePlace> placesOf(const std::map<ir::CasePlace, bool>& dead) {
    const auto places = std::views::keys(dead);
    return {places.begin(), places.end()};
  }
  [[nodiscard]] std::string text(support::SourceRange range) const {
    return range.valid() ? std::string(sources_.text(range)) : "";
  }
  [[nodiscard]] std::string line(support::SourceRange range) const {
    return support::onOneLine(text(range));
  }

  report::GraphState state(uint32_t number) const {
    const ir::State& of = mission_.states[number];
    report::GraphState state;
    state.name = of.name;
    state.parameters = parameters(of);
    state.profile = use(of.profile);
    state.route = use(of.route);
    state.source = source(of);
    state.reached = structure_.reached(number);
    state.dead_end = state.reached && structure_.deadEnd(number);
    state.led_to_in_vain = !state.reached && led_.reached(number);
    state.cases = cases({number}, of.cases, structure_.moves[number], "the state");
    return state;
  }

  /// "to: position, limit: time"; for the IR's text form only the names.
  [[nodiscard]] std::string parameters(const ir::State& state) const {
    if (state.formals.valid()) {
      return line(state.formals);
    }
    std::string list;
    for (const ir::VariableId id : state.parameters) {
      const std::string& name = mission_[id].name;
      list += (list.empty() ? "" : ", ") +
              (name.starts_with(state.name + ".") ? name.substr(state.name.size() + 1) : name);
    }
    return list;
  }

  /// A profile or route with its arguments, or by its name if its source is not written down.
  [[nodiscard]] std::string use(const ir::Activity& activity) const {
    const std::string& name = mission_[activity.behaviour].name;
    const std::string written = in_the_language_ ? line(activity.range) : "";
    return written.starts_with(name) ? written : name;
  }

  /// The source of the state before its events.
  [[nodiscard]] std::string source(const ir::State& state) const {
    if (!state.head.valid()) {
      return "state " + state.name;
    }
    std::string head = text(state.head);
    head.erase(head.find_last_not_of(" \t\r\n") + 1);
    return head;
  }

  [[nodiscard]] std::vector<report::GraphCase> cases(ir::StateId state,
                                                     const std::vector<ir::Case>& cases,
                                                     const ir::Moves& moves,
                                                     const char* list) const {
    std::vector<report::GraphCase> result;
    for (size_t i = 0; i < cases.size() && !cases[i].implied; ++i) {
      const ir::Case& c = cases[i];
      report::GraphCase& told = result.emplace_back();
      told.guard = line(mission_[c.guard].range);
      told.action = c.action.valid() ? action(mission_[c.action]) : "";
      told.source = text(c.range);
      told.transition = transitionOf(c.transition);
      told.target = c.target.valid() ? c.target.index : 0;
      if (moves.dead[i] == ir::Dead::Hidden) {
        told.never = fmt::format("never fires: an earlier case of {} always fires first", list);
      } else if (moves.dead[i] == ir::Dead::AlwaysFalse) {
        told.never = "never fires: its guard is always false";
      } else if (moves.dead[i] == ir::Dead::Proved) {
        told.never = dead_.at({state, static_cast<uint32_t>(i)})
                         ? "never fires: whenever its condition is true, an earlier case fires"
                         : "never fires: its condition cannot be true";
      }
    }
    return result;
  }

  /// The statements, shortened to what they act on.
  [[nodiscard]] std::string action(const ir::Block& block) const {
    std::string list;
    std::set<std::pair<uint32_t, uint32_t>> told;  // the passes of a loop are reported once
    for (const ir::Statement& statement : block.statements) {
      const support::SourceRange& range = statement.range;
      if (!range.valid() || told.emplace(range.begin, range.end).second) {
        list += (list.empty() ? "" : ", ") + shortened(statement);
      }
    }
    return list;
  }

  [[nodiscard]] std::string shortened(const ir::Statement& statement) const {
    const std::string written = line(statement.range);
    if (isPush(written)) {
      return "push";
    }
    if (const auto set = in_the_language_ ? asSet(written) : std::nullopt) {
      return "set " + set->target;
    }
    return statement.kind == ir::StatementKind::Set   ? "set " + mission_[statement.variable].name
           : statement.kind == ir::StatementKind::If  ? "if …"
           : statement.kind == ir::StatementKind::Log ? "log"
                                                      : written;
  }

  const support::SourceManager& sources_;
  const bool in_the_language_;  ///< and not in the IR's text form
  const ir::Mission& mission_;
  const std::map<ir::CasePlace, bool>& dead_;
  const ir::Structure led_;  ///< with the cases that are proved never to fire
  const ir::Structure structure_;
};

}  // namespace

report::Graph graphOf(const compiler::Lowered& mission,
                      const std::vector<ir::StateId>& deepest_path,
                      const std::map<ir::CasePlace, bool>& dead) {
  return GraphMaker(mission, dead).run(deepest_path);
}

}  // namespace glider::analysis
