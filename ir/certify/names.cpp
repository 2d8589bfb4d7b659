// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/certify/names.h"

#include "ir/core/ops.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::ir::certify {
namespace {

/// `name` without what a quoted symbol must not contain.
std::string escaped(const std::string& name) {
  std::string text;
  for (const char c : name) {
    const bool plain = c >= ' ' && c <= '~' && c != '|' && c != '\\' && c != '%';
    text += plain ? std::string(1, c)
                  : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return text;
}

void addClocks(std::vector<Name>& names, const Configuration& at) {
  names.push_back({"|time|", false});
  for (size_t k = 0; k <= at.stack.size(); ++k) {
    names.push_back({enteredName(k), false});
  }
  names.push_back({"|resumed|", false});
}

void addVariable(std::vector<Name>& names, const Variable& v) {
  if (v.type.kind == TypeKind::Bool) {
    names.push_back({variableName(v, " true"), true});
    names.push_back({variableName(v, " false"), true});
  } else {
    names.push_back({variableName(v, ""), false});
    names.push_back({variableName(v, " known"), true});
  }
}

}  // namespace

std::string enteredName(size_t k) {
  return fmt::format("|entered {}|", k);
}

std::string variableName(const Variable& v, const char* what) {
  return fmt::format("|var {}{}|", escaped(v.name), what);
}

std::string temporalName(const char* what, uint32_t temporal) {
  return fmt::format("|{} {}|", what, temporal);
}

bool hasStarted(const Variable& v, const Configuration& at) {
  if (v.kind == VariableKind::Momentary) {
    return false;  // nothing of it is left between two ticks
  }
  return !v.owner.valid() || v.owner == at.state ||
         std::ranges::find(at.stack, v.owner, &Waiting::state) != at.stack.end();
}

bool isRemembered(const Temporal& t, StateId state) {
  return !isWindow(t.kind) && (t.list == ListKind::Always || t.state == state);
}

std::vector<Name> namesIn(const Mission& mission, const Requirement& requirement,
                          const Configuration& at) {
  std::vector<Name> names;
  addClocks(names, at);
  for (const Variable& v : mission.variables) {
    if (hasStarted(v, at)) {
      addVariable(names, v);
    }
  }
  for (uint32_t i = 0; i < mission.temporals.size(); ++i) {
    if (isRemembered(mission.temporals[i], at.state)) {
      names.push_back({temporalName("was", i), true});
      names.push_back({temporalName("since", i), false});
    }
  }
  for (const char* name : {"|depth|", "|deepest|", "|climbing since|", "|top|"}) {
    names.push_back({name, false});
  }
  names.push_back({"|climbing|", true});
  if (requirement.kind == RequirementKind::NeverAfter) {
    names.push_back({"|after seen|", true});
  } else if (requirement.kind == RequirementKind::SurfacesEvery) {
    names.push_back({"|surfaced|", false});
  }
  return names;
}

}  // namespace glider::ir::certify
