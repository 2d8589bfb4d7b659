// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/lower_expr.h"
#include "frontend/sema/names/functions.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

// What functions make of the known elements of an array, as windows do of readings: `mean(temps)`,
// `lowest(temps)`, `highest(temps)`, `spread(temps)`. Without a known element they are unknown.

namespace glider::frontend {
namespace {

class ArrayFunction {
 public:
  ArrayFunction(std::vector<Value> elements, ir::Mission& mission,
                const support::SourceRange& range)
      : elements_(std::move(elements)), type_(elements_.front().type), write_(mission, range) {
    for (const Value& element : elements_) {
      known_.push_back(write_.operation(ir::Op::Known, boolean(), {element.id}));
    }
    first_ = elements_.back().id;
    for (size_t i = elements_.size() - 1; i-- > 0;) {
      first_ = select(i, elements_[i].id, first_);
    }
  }

  /// In place of an unknown element the first known one is compared.
  ir::ExprId extreme(ir::Op op) {
    ir::ExprId most = first_;
    for (size_t i = 0; i < elements_.size(); ++i) {
      most = write_.operation(op, type_, {most, select(i, elements_[i].id, first_)});
    }
    return most;
  }

  ir::ExprId spread() {
    const ir::ExprId highest = extreme(ir::Op::Max);
    return write_.operation(ir::Op::Subtract, type_, {highest, extreme(ir::Op::Min)});
  }

  /// first + (sum of (x - first)) / n, within the range of the elements in spite of rounding.
  ir::ExprId mean() {
    const ir::ExprId none = write_.number(0, type_);
    ir::ExprId sum = none;
    ir::ExprId count = write_.number(0, plainNumber());
    for (size_t i = 0; i < elements_.size(); ++i) {
      const ir::ExprId more = write_.operation(ir::Op::Subtract, type_, {elements_[i].id, first_});
      sum = write_.operation(ir::Op::Add, type_, {sum, select(i, more, none)});
      const ir::ExprId one = write_.operation(
          ir::Op::Select, plainNumber(),
          {known_[i], write_.number(1, plainNumber()), write_.number(0, plainNumber())});
      count = write_.operation(ir::Op::Add, plainNumber(), {count, one});
    }
    const ir::ExprId share = write_.operation(ir::Op::Divide, type_, {sum, count});
    const ir::ExprId mean = write_.operation(ir::Op::Add, type_, {first_, share});
    const ir::ExprId lowest = extreme(ir::Op::Min);
    return write_.operation(ir::Op::Clamp, type_, {mean, lowest, extreme(ir::Op::Max)});
  }

 private:
  /// `a` where element `i` is known, otherwise `b`.
  ir::ExprId select(size_t i, ir::ExprId a, ir::ExprId b) {
    return write_.operation(ir::Op::Select, type_, {known_[i], a, b});
  }

  std::vector<Value> elements_;
  ir::Type type_;
  ir::MissionWriter write_;
  std::vector<ir::ExprId> known_;  ///< of each element
  ir::ExprId first_;               ///< the first known element
};

/// The name that is the only argument; null if there is none.
const ast::NameUse* onlyName(const ast::Invocation& node) {
  if (node.arguments.size() != 1 || node.arguments.front().of || node.arguments.front().parameter) {
    return nullptr;
  }
  return std::get_if<ast::NameUse>(&node.arguments.front().value->node);
}

}  // namespace

std::optional<Array> ExprLowering::onlyArray(const ast::Invocation& node) {
  const ast::NameUse* use = onlyName(node);
  return use == nullptr ? std::nullopt : findArray(use->name, scope_);
}

Named* ExprLowering::onlyRefusedArray(const ast::Invocation& node) {
  const ast::NameUse* use = onlyName(node);
  Named* named = use == nullptr ? nullptr : scope_.findNamed(use->name);
  return named != nullptr && named->array && named->elements.empty() ? named : nullptr;
}

ExprLowering::Result ExprLowering::ofArray(const Array& array, const ast::Invocation& node,
                                           const ast::Expr& expr) {
  const std::string& name = node.function.text;
  if (name != "mean" && name != "lowest" && name != "highest" && name != "spread") {
    const bool least = name == "min";
    auto report = scope_.report(
        support::diagnostics::arrayAsValue, node.arguments.front().value->where, array.name,
        describe(array), fmt::format("use one of its elements, such as `{}[0]`", array.name));
    if (least || name == "max") {
      report.hint(fmt::format("write `{}({})`", least ? "lowest" : "highest", array.name));
    }
    if (array.named != nullptr) {
      array.named->read = true;
    }
    return std::nullopt;
  }
  if (array.named != nullptr && !readable(*array.named, expr.where)) {
    return std::nullopt;
  }
  const Value model{{}, array.type.type, array.type.position ? ir::ExprId{0} : ir::ExprId()};
  if (!numeric(model, *node.arguments.front().value, name, false)) {
    return std::nullopt;
  }
  ArrayFunction function(elements(array, expr.where), scope_.mission, expr.where);
  Value result{{}, array.type.type, {}, array.scale};
  result.id = name == "mean"     ? function.mean()
              : name == "spread" ? function.spread()
              : name == "lowest" ? function.extreme(ir::Op::Min)
                                 : function.extreme(ir::Op::Max);
  return result;
}

}  // namespace glider::frontend
