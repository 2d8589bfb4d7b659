// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/written.h"

#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace glider::analysis {
namespace {

using report::BriefValue;
using support::SourceRange;

/// A longer value is left to the table of names.
constexpr size_t kLongestValue = 40;

template <typename Item>
const Item* as(const ast::Item& item) {
  return std::get_if<Item>(&item);
}

/// The profile or route of a state; null if it has none.
const ast::Use* useIn(const ast::State& state, ir::BehaviourKind kind) {
  for (const ast::Member& member : state.members) {
    if (const auto* route = std::get_if<ast::RouteMember>(&member.node);
        route != nullptr && kind == ir::BehaviourKind::Route) {
      return &route->use;
    }
    if (const auto* profile = std::get_if<ast::ProfileMember>(&member.node);
        profile != nullptr && kind == ir::BehaviourKind::Profile) {
      return &profile->use;
    }
  }
  return nullptr;
}

/// The unit of a number that is written without one, after a space; empty for other types.
std::string_view usualUnit(std::string_view type) {
  constexpr std::pair<std::string_view, std::string_view> kUnits[] = {
      {"length", " m"}, {"angle", " rad"}, {"time", " s"}, {"temperature", " degC"}};
  const auto* const found =
      std::ranges::find(kUnits, type, &std::pair<std::string_view, std::string_view>::first);
  return found == std::end(kUnits) ? std::string_view() : found->second;
}

}  // namespace

std::string inCode(std::string_view text) {
  std::string code(text);
  std::ranges::replace(code, '`', '\'');  // it would end the code too early
  return "`" + code + "`";
}

Written::Written(const compiler::Compilation& compilation)
    : sources_(*compilation.sources), parsed_(compilation.parsed.get()) {
  if (parsed_ == nullptr) {
    return;
  }
  for (const ast::File& library : parsed_->libraries) {
    read(library);
  }
  read(parsed_->mission);
}

void Written::read(const ast::File& file) {
  for (const ast::Item& item : file.items) {
    if (const auto* behaviour = as<ast::Behaviour>(item)) {
      behaviours_[behaviour->name.text] = {&behaviour->formals, above(behaviour->where)};
    } else if (const auto* in_c = as<ast::ExternBehaviour>(item)) {
      behaviours_[in_c->name.text] = {&in_c->formals, above(in_c->where)};
    } else if (const auto* constant = as<ast::Const>(item)) {
      constants_[constant->name.text] = constant->value.where;
    } else if (const auto* state = as<ast::State>(item)) {
      states_[state->name.text] = state;
    }
  }
}

std::span<const ast::Item> Written::items() const {
  return parsed_ == nullptr ? std::span<const ast::Item>() : parsed_->mission.items;
}

std::string_view Written::textOf(SourceRange range) const {
  return range.valid() ? sources_.text(range) : std::string_view();
}

std::string Written::line(SourceRange range) const {
  return support::onOneLine(textOf(range));
}

std::string Written::above(SourceRange range) const {
  return range.valid() ? commentAbove(sources_.text(range.file), range.begin) : "";
}

std::string Written::about(SourceRange range) const {
  const std::string comment = above(range);
  const std::string beside = commentBeside(sources_.text(range.file), range.end);
  return comment + (comment.empty() || beside.empty() ? "" : " ") + beside;
}

std::string Written::head() const {
  return parsed_ == nullptr ? "" : commentAtHead(sources_.text(parsed_->mission.file));
}

std::string Written::commentOf(const std::string& state) const {
  const auto found = states_.find(state);
  return found == states_.end() ? "" : above(found->second->where);
}

std::string Written::argument(const ast::Argument& argument, std::string_view type) const {
  const ast::Expr& value = *argument.value;
  if (const auto* number = std::get_if<ast::Literal>(&value.node);
      number != nullptr && number->unit.empty()) {
    return inCode(line(value.where) + std::string(usualUnit(type)));
  }
  std::string text = inCode(line(value.where));
  if (const auto* name = std::get_if<ast::NameUse>(&value.node)) {
    const auto constant = constants_.find(name->name);
    const std::string is = constant == constants_.end() ? "" : line(constant->second);
    if (!is.empty() && is.size() <= kLongestValue) {
      text += fmt::format(" ({})", inCode(is));
    }
  }
  return text;
}

report::BriefUse Written::use(const std::string& state, ir::BehaviourKind kind,
                              const std::string& name) const {
  report::BriefUse told{name, "", ""};
  const auto declared = behaviours_.find(name);
  if (declared == behaviours_.end()) {
    return told;
  }
  told.comment = declared->second.comment;
  const auto owner = states_.find(state);
  const ast::Use* use = owner == states_.end() ? nullptr : useIn(*owner->second, kind);
  if (use == nullptr || use->name.text != name) {
    return told;
  }
  const auto formals = ast::listOf(*declared->second.formals);
  const auto& arguments = use->arguments;
  size_t at = 0;
  for (const ast::Formal& formal : formals) {
    // A position may be given as two numbers.
    const bool two = formal.type.text == "position" && arguments.size() - at > 1 &&
                     arguments.size() > formals.size();
    for (size_t i = 0; i < (two ? 2 : 1) && at < arguments.size(); ++i, ++at) {
      told.with += (told.with.empty() ? "" : ", ") + (i == 0 ? formal.name.text + " " : "") +
                   argument(arguments[at], formal.type.text);
    }
  }
  return told;
}

namespace {

/// Whether `name` is the parameter, or an element of it: "depths[0]".
bool isOf(const std::string& name, const ast::Param& param) {
  const std::string& whole = param.name.text;
  return param.size ? name.starts_with(whole + "[") && name.ends_with("]") : name == whole;
}

}  // namespace

void Written::describe(std::vector<BriefValue>& parameters) const {
  for (const ast::Item& item : items()) {
    const auto* param = as<ast::Param>(item);
    size_t element = 0;
    for (BriefValue& row : parameters) {
      if (param == nullptr || !isOf(row.name, *param)) {
        continue;
      }
      const auto* list = std::get_if<ast::List>(&param->value.node);
      row.value =
          line(param->size && list != nullptr ? list->items.at(element).where : param->value.where);
      row.range = param->range ? fmt::format("{} to {}", line(param->range->lowest.where),
                                             line(param->range->highest.where))
                               : row.range;
      row.meaning = about(param->where);
      ++element;
    }
  }
}

std::vector<std::string> Written::conditions() const {
  std::vector<std::string> all;
  for (const ast::Item& item : items()) {
    if (const auto* param = as<ast::Param>(item); param != nullptr && param->condition) {
      all.push_back(line(param->condition->where));
    }
  }
  return all;
}

std::vector<BriefValue> Written::values() const {
  std::vector<BriefValue> all;
  for (const ast::Item& item : items()) {
    if (const auto* constant = as<ast::Const>(item)) {
      all.push_back({.name = constant->name.text,
                     .kind = "fixed value",
                     .value = line(constant->value.where),
                     .range = "",
                     .set_to = "",
                     .meaning = about(constant->where)});
    } else if (const auto* var = as<ast::Var>(item)) {
      const std::string range = var->range ? fmt::format("{} to {}", line(var->range->lowest.where),
                                                         line(var->range->highest.where))
                                           : "";
      const std::string size = var->size ? "[" + line(var->size->where) + "]" : "";
      all.push_back({.name = var->name.text + size,
                     .kind = "variable",
                     .value = line(var->value.where),
                     .range = range,
                     .set_to = "",
                     .meaning = about(var->where)});
    } else if (const auto* place = as<ast::PlaceDeclaration>(item)) {
      all.push_back({.name = place->name.text,
                     .kind = "condition",
                     .value = line(place->condition.where),
                     .range = "",
                     .set_to = "",
                     .meaning = about(place->where)});
    }
  }
  return all;
}

std::vector<uint32_t> Written::files() const {
  if (parsed_ == nullptr) {
    return {0};
  }
  std::vector<uint32_t> all = {parsed_->mission.file};
  for (const ast::File& library : parsed_->libraries) {
    all.push_back(library.file);
  }
  return all;
}

}  // namespace glider::analysis
