// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/plan/plan_json.h"

#include <utility>

namespace glider::driver {
namespace {

/// The members of an option: each choice by its name, then the scores.
Json optionJson(const report::Plan& plan, const report::PlanOption& option) {
  Json values = Json::object();
  for (size_t i = 0; i < plan.choices.size(); ++i) {
    values[plan.choices[i].name] = option.values[i];
  }
  Json scores = Json::array();
  for (size_t i = 0; i < plan.objectives.size(); ++i) {
    scores.push_back({{"prefers", plan.objectives[i].text},
                      {"value", option.scores[i]},
                      {"unit", plan.objectives[i].unit}});
  }
  return {{"values", std::move(values)}, {"scores", std::move(scores)}};
}

}  // namespace

void putPlan(Json& document, const report::Plan& plan) {
  document["mission"] = plan.mission;
  document["ways"] = plan.ways;
  document["chosen"] = plan.chosen ? optionJson(plan, *plan.chosen) : Json();
  document["warnings"] = plan.warnings;
  document["front"] = Json::array();
  for (const report::PlanOption& one : plan.front) {
    document["front"].push_back(optionJson(plan, one));
  }
  document["whole_front"] = plan.whole_front;
  document["refused"] = Json::array();
  for (const report::PlanRefusal& one : plan.refused) {
    document["refused"].push_back(
        {{"ways", one.ways}, {"reason", one.reason}, {"example", one.example}});
  }
}

}  // namespace glider::driver
