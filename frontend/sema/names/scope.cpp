// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/scope.h"

#include "frontend/sema/names/functions.h"
#include "frontend/sema/names/values.h"
#include "frontend/sema/names/wished.h"
#include "frontend/spelling.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/one_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>

namespace glider::frontend {

namespace {

constexpr std::string_view kClocks[] = {"missiontime", "statetime", "resumetime"};

}  // namespace

std::optional<Clock> findClock(std::string_view name) {
  for (size_t i = 0; i < std::size(kClocks); ++i) {
    if (name == kClocks[i]) {
      return static_cast<Clock>(i);
    }
  }
  return std::nullopt;
}

std::span<const std::string_view> clockNames() {
  return kClocks;
}

std::string Scope::wholeText(const support::SourceRange& range) const {
  return support::onOneLine(inputs_.sources.text(range));
}

std::string Scope::wordAfter(const support::SourceRange& range) const {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
  std::string_view rest = inputs_.sources.text(range.file);
  rest.remove_prefix(std::min<size_t>(range.end, rest.size()));
  rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
  return std::string(rest.substr(0, rest.find_first_not_of(kLetters)));
}

std::string Scope::text(const support::SourceRange& range) const {
  constexpr size_t kLongest = 60;
  const std::string whole = wholeText(range);
  return whole.size() > kLongest ? whole.substr(0, kLongest) + "…" : whole;
}

const platforms::PlatformSensor* Scope::findSensor(std::string_view name) {
  if (findNamed(name) != nullptr) {
    return nullptr;
  }
  if (const auto own = own_sensors.find(name); own != own_sensors.end()) {
    return own->second.usable ? &own->second.sensor : nullptr;
  }
  if (const auto heard = heard_sensors.find(name); heard != heard_sensors.end()) {
    return &heard->second.sensor;
  }
  return name.contains('.') ? findNamedSensor(name) : platform().find(name);
}

const platforms::PlatformSensor* Scope::findNamedSensor(std::string_view name) {
  if (const auto known = named_sensors.find(name); known != named_sensors.end()) {
    return &known->second.sensor;
  }
  const size_t dot = name.find('.');
  const auto vehicle = std::ranges::find(vehicles, name.substr(0, dot));
  const std::string share(name.substr(dot + 1));
  const std::string peer = std::string(kPeerPrefix) + share;
  if (vehicle == vehicles.end()) {
    return nullptr;
  }
  const auto heard = heard_sensors.find(peer);
  if (heard == heard_sensors.end()) {
    if (refused_names.contains(peer) || heard_sensors.empty()) {
      refused_names.emplace(name);
    }
    return nullptr;
  }
  NamedSensor named{heard->second.sensor, share,
                    static_cast<uint32_t>(vehicle - vehicles.begin()) + 1,
                    heard->second.name->where};
  const size_t number = std::min(named_sensors.size(), kMostNamedSensors - 1);  // finishVehicles
  named.sensor.id = static_cast<uint16_t>(ir::kFirstHeardSensor + ir::kMostShares + number);
  named.sensor.name = name;
  return &named_sensors.emplace(name, std::move(named)).first->second.sensor;
}

namespace {

/// The clocks, then the sensors by the names that missions use, then by the vehicle's.
std::vector<std::string_view> readableNames(
    const std::map<std::string, OwnSensor, std::less<>>& own,
    const std::vector<platforms::PlatformSensor>& sensors) {
  std::vector<std::string_view> known(std::begin(kClocks), std::end(kClocks));
  for (const auto& [name, sensor] : own) {
    known.push_back(name);
  }
  for (const platforms::PlatformSensor& sensor : sensors) {
    known.push_back(sensor.alias.empty() ? sensor.name : sensor.alias);
  }
  for (const platforms::PlatformSensor& sensor : sensors) {
    known.push_back(sensor.name);
  }
  return known;
}

}  // namespace

Suggestion Scope::suggestSensor(std::string_view wrong) const {
  if (const size_t dot = wrong.find('.'); dot != std::string_view::npos) {
    std::vector<std::string> told;
    for (const auto& [peer, heard] : heard_sensors) {
      told.push_back(std::string(wrong.substr(0, dot + 1)) + peer.substr(kPeerPrefix.size()));
    }
    return didYouMean(wrong, {told.begin(), told.end()},
                      fmt::format("no vehicle tells it: the mission has no line `share {}`",
                                  wrong.substr(dot + 1)));
  }
  if (auto wished = insteadOf(wrong, platform())) {
    return std::move(*wished);
  }
  return didYouMean(wrong, readableNames(own_sensors, platform().sensors),
                    "`glidercc platform " + platform().name + "` lists its sensors");
}

Suggestion Scope::suggestName(std::string_view wrong) const {
  const std::string lower = inLowerCase(wrong);
  if (lower != wrong && (isValueName(lower) || findSensorState(platform(), lower))) {
    return {fmt::format("write `{}`", lower), lower};
  }
  std::vector<std::string_view> known;
  for (const Names* list : visibleNames()) {
    for (const auto& [name, named] : *list) {
      known.push_back(name);
    }
  }
  for (const auto& [name, constant] : constants) {
    if (!context.isolated) {
      known.push_back(name);
    }
  }
  Suggestion near = didYouMean(wrong, known, "");
  return near.hint.empty() ? suggestSensor(wrong) : std::move(near);
}

std::string Scope::takenBy(std::string_view name) const {
  if (findClock(name)) {
    return "a clock";
  }
  if (platform().find(name) != nullptr) {
    return "a sensor of platform `" + platform().name + "`";
  }
  if (isReservedFunction(name)) {
    return "a function";
  }
  return name == "profiledone" || name == "routedone" ? "a keyword" : "";
}

bool Scope::refuseUnseen(std::string_view name, const support::SourceRange& range) {
  if (context.isolated) {
    const auto constant = constants.find(name);
    const auto named = names.find(name);
    const ast::Name* there = constant != constants.end() ? constant->second.name
                             : named != names.end()      ? named->second.name
                                                         : nullptr;
    if (there != nullptr) {
      report(support::diagnostics::ofTheMission, range, name)
          .note(there->where, "it is defined here");
    }
    return there != nullptr;
  }
  for (const StateDeclaration& state : state_declarations) {
    if (const auto found = state.names.find(name); found != state.names.end()) {
      report(support::diagnostics::ofAnotherState, range, name, state.node->name.text)
          .note(found->second.name->where, "it is defined here");
      return true;
    }
  }
  return false;
}

bool Scope::refuseVehicle(std::string_view name, const support::SourceRange& range) {
  const size_t dot = name.find('.');
  const std::string_view vehicle = name.substr(0, dot);
  if (dot == std::string_view::npos || name.starts_with(kPeerPrefix) ||
      std::ranges::find(vehicles, vehicle) != vehicles.end()) {
    return false;
  }
  const std::string hint =
      vehicles.empty()
          ? fmt::format("write `peer{}`, or name the vehicles in a line `vehicles {}, …`",
                        name.substr(dot), vehicle)
          : didYouMean(vehicle, {vehicles.begin(), vehicles.end()},
                       fmt::format("the line `vehicles` has {}", fmt::join(vehicles, ", ")))
                .hint;
  report(support::diagnostics::unknownVehicle, range, vehicle, hint);
  return true;
}

bool Scope::refuseName(const ast::Name& name, std::string_view owner) {
  if (isUnitName(name.text)) {
    report(support::diagnostics::unitAsName, name.where, name.text, owner);
    refused_names.insert(name.text);
    return true;
  }
  const std::string what = takenBy(name.text);
  if (!what.empty()) {
    report(support::diagnostics::nameTaken, name.where, name.text, what);
    refused_names.insert(name.text);
  }
  return !what.empty();
}

bool Scope::refuseSecond(const ast::Name& name) {
  const Named* named = findNamed(name.text);
  const Constant* constant = findConstant(name.text);
  const ast::Name* first = named != nullptr      ? named->name
                           : constant != nullptr ? constant->name
                                                 : findExternal(name.text);
  if (first == nullptr) {
    return false;
  }
  report(support::diagnostics::duplicateName, name.where, name.text)
      .note(first->where, "the first is here");
  return true;
}

Named* Scope::findNamed(std::string_view name) {
  if (context.names != nullptr) {
    if (const auto own = context.names->find(name); own != context.names->end()) {
      return &own->second;
    }
  }
  const auto found = context.isolated ? names.end() : names.find(name);
  return found == names.end() ? nullptr : &found->second;
}

const LoopPass* Scope::findPass(std::string_view name) const {
  const LoopPass* pass = context.pass;
  while (pass != nullptr && pass->index.name->text != name) {
    pass = pass->outer;
  }
  return pass;
}

const Constant* Scope::findConstant(std::string_view name) const {
  if (const LoopPass* pass = findPass(name)) {
    return &pass->index;
  }
  const auto found = context.isolated ? constants.end() : constants.find(name);
  if (found == constants.end()) {
    return nullptr;
  }
  open_reads += found->second.open ? 1U : 0U;
  return &found->second;
}

void Scope::notePass(support::DiagnosticBuilder& report) const {
  for (const LoopPass* pass = context.pass; pass != nullptr; pass = pass->outer) {
    report.note(pass->index.name->where,
                fmt::format("where `{}` is {}", pass->index.name->text, pass->index.number));
  }
}

bool Scope::inStandardLibrary(const support::SourceRange& range) const {
  const size_t count = std::min(inputs_.standard, inputs_.library.size());
  return std::ranges::any_of(std::span(inputs_.library).first(count),
                             [&](const ast::File* file) { return file->file == range.file; });
}

BehaviourDeclaration* Scope::findBehaviour(const ast::Name& name) {
  if (inStandardLibrary(name.where)) {
    if (const auto own = replaced_behaviours.find(name.text); own != replaced_behaviours.end()) {
      return &own->second;
    }
  }
  const auto found = behaviours.find(name.text);
  return found == behaviours.end() ? nullptr : &found->second;
}

bool Scope::declares(std::string_view name, const support::SourceRange& where) {
  if (findPass(name) != nullptr) {
    return true;
  }
  if (inStandardLibrary(where)) {
    return context.names != nullptr && context.names->contains(name);
  }
  const auto ofState = [&](const StateDeclaration& state) { return state.names.contains(name); };
  return findNamed(name) != nullptr || names.contains(name) || constants.contains(name) ||
         functions.contains(name) || own_sensors.contains(name) || refused_names.contains(name) ||
         std::ranges::any_of(state_declarations, ofState);
}

const ast::Name* Scope::findExternal(std::string_view name) const {
  const auto sensor = own_sensors.find(name);
  const auto function = functions.find(name);
  // A behaviour has its own names: an `extern` elsewhere does not reserve a name in it.
  if (context.isolated) {
    return nullptr;
  }
  return sensor != own_sensors.end()   ? sensor->second.name
         : function != functions.end() ? function->second.name
                                       : nullptr;
}

std::vector<const Names*> Scope::visibleNames() const {
  std::vector<const Names*> lists;
  if (context.names != nullptr) {
    lists.push_back(context.names);
  }
  if (!context.isolated) {
    lists.push_back(&names);
  }
  return lists;
}

std::string Scope::freshName(std::string wish) {
  while (!variable_names_.insert(wish).second) {
    wish += '_';
  }
  return wish;
}

std::optional<DeclaredType> Scope::declaredType(const ast::TypeName& name,
                                                std::string_view holder) {
  if (const auto found = findType(name.text)) {
    if (!found->path || holder.empty()) {
      return found;
    }
    report(support::diagnostics::pathElsewhere, name.where, holder);
    return std::nullopt;
  }
  static const std::vector<std::string_view> kTypes = {
      "bool", "latitude", "longitude", "position", "path",
#define DIMENSION(name, m, kg, s, a, k, rad, unit) #name,
#include "support/units/dimensions.def"
#undef DIMENSION
  };
  std::string all;
  for (std::string_view type : kTypes) {
    all += (all.empty() ? "types: " : ", ") + std::string(type);
  }
  reportUnknown(support::diagnostics::unknownType, name.where, didYouMean(name.text, kTypes, all),
                name.text);
  return std::nullopt;
}

Signature Scope::signatureOf(const ast::Name& name, std::span<const ast::Formal> formals,
                             std::string_view holder) {
  Signature result;
  for (const ast::Formal& formal : formals) {
    result.text += fmt::format("{}{}: {}", result.text.empty() ? "" : ", ", formal.name.text,
                               formal.type.text);
    result.text += formal.usual ? fmt::format(" = {}", text(formal.usual->where)) : "";
  }
  result.text = name.text + (result.text.empty() ? "" : "(" + result.text + ")");
  for (const ast::Formal& formal : formals) {
    const auto type = declaredType(formal.type, holder);
    result.valid = result.valid && type.has_value();
    const DeclaredType known = type.value_or(DeclaredType{plainNumber(), false});
    result.formals.push_back({&formal.name, known, formal.usual ? &*formal.usual : nullptr,
                              formal.range ? &*formal.range : nullptr});
    if (formal.usual && !holder.empty()) {
      report(support::diagnostics::usualNotHere, formal.usual->where, holder);
      result.valid = false;
    }
    if (known.path) {
      continue;
    }
    if (known.position) {
      result.slots.push_back({formal.name.text + ".latitude", latitude()});
      result.slots.push_back({formal.name.text + ".longitude", longitude()});
    } else {
      result.slots.push_back({formal.name.text, known.type});
    }
  }
  return result;
}

}  // namespace glider::frontend
