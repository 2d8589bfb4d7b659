// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/names/names.h"

namespace glider::frontend {

std::string_view describe(NamedKind kind) {
  switch (kind) {
    case NamedKind::Parameter:
      return "a parameter of the mission";
    case NamedKind::StateParameter:
      return "a parameter of the state";
    case NamedKind::BehaviourParameter:
      return "a parameter";
    case NamedKind::MissionVariable:
    case NamedKind::StateVariable:
    case NamedKind::BehaviourVariable:
      break;
  }
  return "a variable";
}

bool isVariable(NamedKind kind) {
  return kind == NamedKind::MissionVariable || kind == NamedKind::StateVariable ||
         kind == NamedKind::BehaviourVariable;
}

}  // namespace glider::frontend
