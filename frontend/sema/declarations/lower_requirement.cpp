// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/declarations/lower_requirement.h"

#include "frontend/sema/declarations/disc_of_distance.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/promises/lower_promise.h"
#include "frontend/sema/promises/places.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace glider::frontend {

namespace {

/// Lowers one requirement; empty, and reported, if it is wrong.
class RequirementLowering {
 public:
  RequirementLowering(const ast::Requirement& node, Scope& scope) : node_(node), scope_(scope) {}

  std::optional<ir::Requirement> run() {
    result_.range = node_.where;
    Context context = scope_.context;
    context.requirement = true;
    const Scope::Within within(scope_, context);
    const bool right = std::visit([&](const auto& promise) { return lower(promise); }, node_.node);
    return right ? std::optional(result_) : std::nullopt;
  }

 private:
  bool lower(const ast::AlwaysPromise& promise) {
    result_.kind = ir::RequirementKind::Always;
    const auto* name = std::get_if<ast::NameUse>(&promise.condition.node);
    const bool place = name != nullptr && scope_.places.contains(name->name);
    if (place || combinesPlaces(promise.condition, scope_)) {
      return PromiseLowering(node_, scope_, result_).lower(promise);
    }
    const size_t uses = scope_.mission.uses.size();
    const auto condition = ExprLowering(scope_).lowerCondition(promise.condition);
    result_.condition = condition.value_or(ir::ExprId());
    if (scope_.mission.uses.size() > uses) {
      const ir::FunctionUse& use = scope_.mission.uses[uses];
      scope_.report(support::diagnostics::requirementCalls, use.range,
                    scope_.mission.functions[use.function.index].name);
      return false;
    }
    if (condition && !gatherFences(*condition, true)) {
      result_.geofences.clear();
    }
    return condition.has_value();
  }

  /// False if the condition requires more than areas to stay in or out of.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  bool gatherFences(ir::ExprId id, bool wanted) {
    const ir::Expr& e = scope_.mission[id];
    if (e.op == ir::Op::Not) {
      return gatherFences(e.operands[0], !wanted);
    }
    if (e.op == (wanted ? ir::Op::And : ir::Op::Or)) {
      return gatherFences(e.operands[0], wanted) && gatherFences(e.operands[1], wanted);
    }
    if (auto disc = discOf(id, wanted, scope_)) {
      result_.geofences.push_back(std::move(*disc));
      return true;
    }
    const auto known = scope_.areas.find(id.index);
    if (known == scope_.areas.end() || known->second.range != e.range) {
      return false;
    }
    result_.geofences.push_back(known->second.area);
    result_.geofences.back().keep_in = wanted;
    return true;
  }

  bool lower(const ast::ExitPromise& promise) {
    result_.kind = ir::RequirementKind::ExitWithin;
    return seconds(promise.within, "exit within");
  }

  bool lower(const ast::SurfacesPromise& promise) {
    result_.kind = ir::RequirementKind::SurfacesEvery;
    return seconds(promise.every, "surfaces every");
  }

  bool lower(const ast::StackPromise& promise) {
    result_.kind = ir::RequirementKind::StackAtMost;
    const auto depth =
        promisedNumber(promise.depth, plainNumber(), "the depth of the stack", scope_);
    if (depth && !(*depth >= 0 && *depth <= kDeepest && std::floor(*depth) == *depth)) {
      scope_.report(support::diagnostics::stackNotWhole, promise.depth.where,
                    scope_.text(promise.depth.where));
      return false;
    }
    result_.depth = static_cast<uint32_t>(depth.value_or(0));
    return depth.has_value();
  }

  bool lower(const ast::ReachPromise& promise) {
    result_.kind = ir::RequirementKind::Reach;
    return state(promise.state, result_.state);
  }

  /// A pattern.
  template <typename Promise>
  bool lower(const Promise& promise) {
    return PromiseLowering(node_, scope_, result_).lower(promise);
  }

  bool seconds(const ast::Expr& expr, std::string_view what) {
    const auto time = promisedTime(expr, what, scope_);
    result_.seconds = time ? time->seconds : 0;
    return time.has_value();
  }

  bool state(const ast::Name& name, ir::StateId& id) {
    const auto found = scope_.states.find(name.text);
    if (found != scope_.states.end()) {
      id = found->second;
      return true;
    }
    std::vector<std::string_view> names;
    for (const auto& [known, number] : scope_.states) {
      names.push_back(known);
    }
    scope_.reportUnknown(support::diagnostics::unknownState, name.where,
                         didYouMean(name.text, names, scope_.listedStates()), name.text);
    return false;
  }

  static constexpr double kDeepest = 1e6;

  const ast::Requirement& node_;
  Scope& scope_;
  ir::Requirement result_;
};

}  // namespace

void lowerRequirements(const ast::File& file, Scope& scope) {
  for (const ast::Item& item : file.items) {
    if (const auto* node = std::get_if<ast::Requirement>(&item)) {
      if (auto requirement = RequirementLowering(*node, scope).run()) {
        scope.mission.requirements.push_back(*requirement);
      }
    }
  }
  checkUnusedPlaces(scope);
}

}  // namespace glider::frontend
