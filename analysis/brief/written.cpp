// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/written.h"

#include "compiler/written_position.h"
#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace glider::analysis {
namespace {

using report::BriefValue;
using support::SourceRange;

constexpr std::string_view kPosition = "position";
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
      constants_[constant->name.text] = constant;
    } else if (const auto* choice = as<ast::Choice>(item)) {
      constants_[choice->constant.name.text] = &choice->constant;
    } else if (const auto* state = as<ast::State>(item)) {
      states_[state->name.text] = state;
      notePositions(*state);
    }
    notePositions(item);
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

void Written::notePositions(const ast::Item& item) {
  if (const auto* constant = as<ast::Const>(item); constant != nullptr) {
    if (isPosition(constant->value)) {
      positions_.insert(constant->name.text);
    }
  } else if (const auto* param = as<ast::Param>(item); param != nullptr) {
    if (param->type.text == kPosition) {
      positions_.insert(param->name.text);
    }
  } else if (const auto* var = as<ast::Var>(item); var != nullptr && var->type.text == kPosition) {
    positions_.insert(var->name.text);
  }
}

void Written::notePositions(const ast::State& state) {
  for (const ast::Formal& formal : ast::listOf(state.formals)) {
    if (formal.type.text == kPosition) {
      positions_.insert(formal.name.text);
    }
  }
  for (const ast::Member& member : state.members) {
    const auto* var = std::get_if<ast::Var>(&member.node);
    if (var != nullptr && var->type.text == kPosition) {
      positions_.insert(var->name.text);
    }
  }
}

bool Written::isPosition(const ast::Expr& value) const {
  if (const auto* name = std::get_if<ast::NameUse>(&value.node)) {
    return name->name == "here" || positions_.contains(name->name);
  }
  if (const auto* element = std::get_if<ast::Index>(&value.node)) {
    return constants_.contains(element->list.text) || positions_.contains(element->list.text);
  }
  const auto* call = std::get_if<ast::Invocation>(&value.node);
  return std::holds_alternative<ast::Position>(value.node) ||
         (call != nullptr && (call->function.text == kPosition || call->function.text == "offset"));
}

/// As it is written, but a position, also as an element of a list, in the one form.
std::string Written::value(const ast::Expr& value) const {
  const auto* list = std::get_if<ast::List>(&value.node);
  if (list != nullptr && std::ranges::any_of(list->items, [](const auto& item) {
        return compiler::positionText(item).has_value();
      })) {
    std::string all;
    for (const ast::Expr& item : list->items) {
      all += (all.empty() ? "[" : ", ") + this->value(item);
    }
    return all + "]";
  }
  return compiler::positionText(value).value_or(line(value.where));
}

std::string Written::argument(const ast::Expr& value, std::string_view type) const {
  if (const auto* number = std::get_if<ast::Literal>(&value.node);
      number != nullptr && number->unit.empty()) {
    return inCode(line(value.where) + std::string(usualUnit(type)));
  }
  std::string text = inCode(this->value(value));
  if (const auto* name = std::get_if<ast::NameUse>(&value.node)) {
    const auto constant = constants_.find(name->name);
    const std::string is = constant == constants_.end() ? "" : this->value(constant->second->value);
    if (!is.empty() && is.size() <= kLongestValue) {
      text += fmt::format(" ({})", inCode(is));
    }
  }
  return text;
}

/// "top = `5 m`", as it may be written; "lat and lon `here`"
std::string Written::given(const Given& given) const {
  std::string text;
  for (const ast::Formal* formal : given.formals) {
    text += (text.empty() ? "" : " and ") + formal->name.text;
  }
  text += given.formals.size() == 1 ? " =" : "";
  if (given.values.size() == 2) {
    const auto position = compiler::positionText(*given.values[0], *given.values[1]);
    if (position) {
      return text + " " + inCode(*position);
    }
  }
  for (const ast::Expr* value : given.values) {
    text += (value == given.values.front() ? " " : ", ") +
            argument(*value, given.formals.front()->type.text);
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
  const auto is_position = [this](const ast::Expr& value) { return isPosition(value); };
  for (const Given& one :
       givenTo(ast::listOf(*declared->second.formals), use->arguments, is_position)) {
    told.with += (told.with.empty() ? "" : ", ") + given(one);
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
      row.value = value(param->size && list != nullptr ? list->items.at(element) : param->value);
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

std::vector<BriefValue> Written::waypointLists() const {
  std::vector<BriefValue> all;
  for (const ast::Item& item : items()) {
    const auto* import = as<ast::Import>(item);
    const auto list =
        import != nullptr && import->as ? constants_.find(import->as->text) : constants_.end();
    if (list != constants_.end()) {
      const std::string about = this->about(import->where);
      const std::string file = import->path.substr(1, import->path.size() - 2);
      all.push_back({.name = import->as->text,
                     .kind = "list of waypoints",
                     .value = value(list->second->value),
                     .range = "",
                     .set_to = "",
                     .meaning = about + (about.empty() ? "from " : "; from ") + inCode(file)});
    }
  }
  return all;
}

std::vector<BriefValue> Written::values() const {
  std::vector<BriefValue> all = waypointLists();
  for (const ast::Item& item : items()) {
    if (const auto* constant = as<ast::Const>(item)) {
      all.push_back({.name = constant->name.text,
                     .kind = "fixed value",
                     .value = value(constant->value),
                     .range = "",
                     .set_to = "",
                     .meaning = about(constant->where)});
    } else if (const auto* choice = as<ast::Choice>(item)) {
      all.push_back({.name = choice->constant.name.text,
                     .kind = choice->chosen ? "chosen value" : "not chosen yet",
                     .value = value(choice->constant.value),
                     .range = fmt::format("{} to {}", line(choice->range.lowest.where),
                                          line(choice->range.highest.where)),
                     .set_to = "",
                     .meaning = about(choice->where)});
    } else if (const auto* var = as<ast::Var>(item)) {
      const std::string range = var->range ? fmt::format("{} to {}", line(var->range->lowest.where),
                                                         line(var->range->highest.where))
                                           : "";
      const std::string size = var->size ? "[" + line(var->size->where) + "]" : "";
      all.push_back({.name = var->name.text + size,
                     .kind = "variable",
                     .value = value(var->value),
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
