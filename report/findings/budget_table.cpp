// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "report/findings/findings.h"
#include "support/grouped.h"

#include <fmt/format.h>

#include <algorithm>

namespace glider::report {
std::string amount(const Quantity& quantity) {
  if (!quantity.value) {
    return "no bound is known";
  }
  std::string text = support::grouped(*quantity.value);
  if (quantity.limit) {
    text += " of " + support::grouped(*quantity.limit);
  }
  return text + " " + quantity.unit;
}

std::string spoken(std::string name) {
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string budgetTable(const CheckedMission& mission) {
  std::string table;
  for (const Budget& budget : mission.budgets) {
    table += fmt::format("{}: upper bounds, {}\n", mission.path, budget.of);
    for (const Quantity& quantity : budget.quantities) {
      table += fmt::format("  {:<22}  {:<36}  {}\n", spoken(quantity.name), amount(quantity),
                           quantity.remark);
    }
  }
  return table;
}

}  // namespace glider::report
