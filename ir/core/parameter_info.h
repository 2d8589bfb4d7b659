// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"

#include <string>
#include <vector>

namespace glider::ir {

/// What a program must know of a parameter in order to read its value at launch. SI units;
/// positions in degrees; a truth value is 0 or 1.
struct ParameterInfo {
  std::string name;
  double initial = 0;
  double lowest = 0;
  double highest = 0;
  std::string units;  ///< unitFactors
  bool date = false;  ///< a time of the calendar, seconds since 1970
};

/// Of each parameter of `mission`, in the order of its variables.
std::vector<ParameterInfo> parameterInfos(const Mission& mission);

/// The units in which a parameter of `type` may be given at launch, in the form of
/// GliderParameterInfo::units.
std::string unitFactors(const Type& type);

}  // namespace glider::ir
