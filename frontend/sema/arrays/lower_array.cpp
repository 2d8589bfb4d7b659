// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "ir/verify/intervals.h"
#include "support/diagnostics/ids/meaning.h"

#include <fmt/format.h>

#include <cmath>

// Arrays: their elements are variables or constants. An index that is not known when the mission is
// compiled chooses among all of them, so nothing after the frontend knows arrays.

namespace glider::frontend {

std::optional<Array> findArray(std::string_view name, Scope& scope) {
  Named* named = scope.findNamed(name);
  if (named != nullptr && named->array && !named->elements.empty()) {
    return Array{std::string(name),      named->type, named->scale,
                 named->elements.size(), named,       nullptr};
  }
  const Constant* constant = named == nullptr ? scope.findConstant(name) : nullptr;
  if (constant != nullptr && !constant->elements.empty()) {
    return Array{std::string(name),         {constant->type}, constant->scale,
                 constant->elements.size(), nullptr,          constant};
  }
  return std::nullopt;
}

std::string describe(const Array& array) {
  return fmt::format("an array of {} elements", array.size);
}

void ExprLowering::refuseArray(const Array& array, const support::SourceRange& range) {
  const bool number = !array.type.position && array.type.type != boolean();
  scope_.report(support::diagnostics::arrayAsValue, range, array.name, describe(array),
                number
                    ? fmt::format("use one of them, such as `{0}[0]`, or `mean({0})`", array.name)
                    : fmt::format("use one of them, such as `{}[0]`", array.name));
  if (array.named != nullptr) {
    array.named->read = true;
  }
}

void ExprLowering::refuseIndexed(const ast::Name& name) {
  Named* named = scope_.findNamed(name.text);
  if (named != nullptr && (named->array || !named->valid)) {
    (void)readable(*named, name.where);  // it is refused, or not defined yet
    return;
  }
  const Constant* constant = scope_.findConstant(name.text);
  if (constant != nullptr && !constant->worked_out) {
    scope_.report(support::diagnostics::usedBeforeDefined, name.where, name.text)
        .note(constant->name->where, "it is defined here");
    return;
  }
  const bool known = named != nullptr || constant != nullptr || findClock(name.text) ||
                     scope_.findSensor(name.text) != nullptr;
  if (known) {
    scope_.report(support::diagnostics::noElements, name.where, name.text);
  } else if (!scope_.refused_names.contains(name.text)) {
    (void)unknown({name.text}, name.where);
  }
}

/// Warns if the ranges of what an index reads let it leave the array.
void ExprLowering::warnOfIndex(ir::ExprId number, const ast::Expr& expr, const Array& array) {
  if (scope_.context.checkedAlone()) {
    return;  // parameters have no ranges yet
  }
  const auto last = static_cast<double>(array.size - 1);
  const ir::Interval range =
      ir::SubtreeIntervals(scope_.mission).of(number, [](uint32_t, const ir::Interval& x) {
        return x;
      });
  if (range.within(0, last)) {
    return;
  }
  constexpr double kNoBound = 1e300;
  const double end = range.highest > last ? range.highest : range.lowest;
  scope_.report(support::diagnostics::indexMayLeave, expr.where, array.name,
                std::fabs(end) > kNoBound ? "any number" : fmt::format("{:.10g}", end), last,
                scope_.text(expr.where));
}

std::optional<ElementIndex> ExprLowering::lowerIndex(const ast::Expr& expr, const Array& array) {
  const auto number = lowerAs(expr, plainNumber(), "the index of `" + array.name + "`");
  if (!number) {
    return std::nullopt;
  }
  const auto known = evaluate(scope_.mission, *number);
  if (!known) {
    warnOfIndex(*number, expr, array);
    ir::Table all{plainNumber(), {}};
    for (size_t i = 0; i < array.size; ++i) {
      all.values.push_back(static_cast<double>(i));
    }
    const ir::TableId table = scope_.table(std::move(all));
    return ElementIndex{
        {}, *number, ir::MissionWriter(scope_.mission, expr.where).element(table, *number)};
  }
  if (!(*known >= 0 && *known < static_cast<double>(array.size) && *known == std::floor(*known))) {
    scope_.report(support::diagnostics::outsidePath, expr.where, array.name,
                  fmt::format("{} elements", array.size), *known);
    return std::nullopt;
  }
  return ElementIndex{static_cast<size_t>(*known), *number, {}};
}

Value ExprLowering::elementAt(const Array& array, size_t i, const support::SourceRange& range) {
  ir::MissionWriter write(scope_.mission, range);
  Value value{{}, array.type.type, {}, array.scale};
  if (array.constant != nullptr) {
    const double number = array.constant->elements[i];
    value.id =
        value.type == boolean() ? write.truth(number != 0) : write.number(number, value.type);
    return value;
  }
  const Element& element = array.named->elements[i];
  value.id = write.read(element.variable);
  if (array.type.position) {
    value.longitude = write.read(element.longitude);
  }
  return value;
}

std::vector<Value> ExprLowering::elements(const Array& array, const support::SourceRange& range) {
  std::vector<Value> all;
  for (size_t i = 0; i < array.size; ++i) {
    all.push_back(elementAt(array, i, range));
  }
  return all;
}

Value ExprLowering::oneOf(const std::vector<Value>& all, ir::ExprId number,
                          const support::SourceRange& range) {
  ir::MissionWriter write(scope_.mission, range);
  const auto is = [&](size_t i) {
    return write.operation(ir::Op::Equal, boolean(),
                           {number, write.number(static_cast<double>(i), plainNumber())});
  };
  Value chosen = all.back();
  if (chosen.type == boolean()) {
    // True if the element is, and unknown where there is none.
    chosen.id = write.negation(
        write.operation(ir::Op::GreaterEqual, boolean(), {number, write.number(0, plainNumber())}));
    for (size_t i = 0; i < all.size(); ++i) {
      chosen.id = write.either(chosen.id, write.both(is(i), all[i].id));
    }
    return chosen;
  }
  // The last one needs no test: where the number is unknown, so is the result of each choice.
  for (size_t i = all.size() - 1; i-- > 0;) {
    const ir::ExprId here = is(i);
    chosen.id = write.operation(ir::Op::Select, chosen.type, {here, all[i].id, chosen.id});
    if (chosen.longitude.valid()) {
      chosen.longitude =
          write.operation(ir::Op::Select, longitude(), {here, all[i].longitude, chosen.longitude});
    }
  }
  return chosen;
}

ExprLowering::Result ExprLowering::element(const Array& array, const ast::Index& node,
                                           const ast::Expr& expr) {
  const bool readable_here = array.named == nullptr || readable(*array.named, expr.where);
  const auto index = lowerIndex(*node.position, array);
  if (!readable_here || !index) {
    return std::nullopt;
  }
  if (index->known) {
    return elementAt(array, *index->known, expr.where);
  }
  if (array.constant != nullptr && array.type.type != boolean()) {
    const ir::TableId values = scope_.table({array.type.type, array.constant->elements});
    Value value =
        valueOf(ir::MissionWriter(scope_.mission, expr.where).element(values, index->written));
    value.scale = array.scale;
    return value;
  }
  return oneOf(elements(array, expr.where), index->number, expr.where);
}

}  // namespace glider::frontend
