// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign/result_json.h"

#include <algorithm>
#include <cstdint>
#include <string>

namespace glider::driver {
namespace {

using campaign::CampaignFlight;
using campaign::CampaignPlan;
using campaign::CampaignResult;
using simulator::Verdict;

/// Calls `take(flight, verdict)` for each flight that was flown.
template <typename Take>
void eachFlown(const CampaignPlan& plan, const CampaignResult& result, Take take) {
  for (uint64_t number = 0; number < result.verdicts.size(); ++number) {
    if (const auto& verdict = result.verdicts[number]) {
      take(campaign::flightOf(plan, number), *verdict);
    }
  }
}

Json faultsOf(const CampaignPlan& plan, const CampaignResult& result) {
  Json faults = Json::object();
  eachFlown(plan, result, [&](const CampaignFlight& flight, const Verdict& verdict) {
    Json& row = faults[std::string(simulator::nameOf(flight.kind))];
    if (row.is_null()) {
      row = {{"flights", 0}, {"deepest_m", 0.0}, {"outcomes", Json::object()}};
    }
    row["flights"] = row["flights"].get<uint64_t>() + 1;
    row["deepest_m"] = std::max(row["deepest_m"].get<double>(), verdict.deepest_m);
    Json& count = row["outcomes"][campaign::outcomeName(verdict)];
    count = count.is_null() ? uint64_t{1} : count.get<uint64_t>() + 1;
  });
  return faults;
}

Json requirementsOf(const CampaignPlan& plan, const CampaignResult& result) {
  Json requirements = Json::array();
  for (size_t mission = 0; mission < plan.missions.size(); ++mission) {
    const campaign::CampaignMission& flown = plan.missions[mission];
    for (size_t i = 0; i < flown.requirements.size(); ++i) {
      uint64_t flights = 0;
      uint64_t violated = 0;
      eachFlown(plan, result, [&](const CampaignFlight& flight, const Verdict& verdict) {
        if (flight.mission == mission && !flight.board) {
          ++flights;
          violated += std::ranges::find(verdict.requirements, i) != verdict.requirements.end();
        }
      });
      requirements.push_back({{"mission", flown.file},
                              {"text", flown.requirements[i]},
                              {"flights", flights},
                              {"violated", violated}});
    }
  }
  return requirements;
}

}  // namespace

Json flightOf(const CampaignPlan& plan, const CampaignFlight& flight, const Verdict& verdict) {
  Json one = {{"number", flight.number},
              {"mission", plan.missions[flight.mission].file},
              {"fault", simulator::nameOf(flight.kind)},
              {"when", simulator::nameOf(flight.manner)},
              {"board", flight.board ? Json(plan.boards[*flight.board]) : Json()},
              {"seed", flight.seed},
              {"outcome", campaign::outcomeName(verdict)},
              {"deepest_m", numberOrNull(verdict.deepest_m)}};
  if (verdict.outcome == Verdict::Outcome::Violation) {
    one["violation"] = verdict.violation;
    one["violation_s"] = verdict.violation_s;
  }
  return one;
}

void putResult(Json& document, const CampaignPlan& plan, const CampaignResult& result) {
  document["flights"] = plan.flights;
  document["flown"] = std::ranges::count_if(
      result.verdicts, [](const auto& verdict) { return verdict.has_value(); });
  document["part"] = {{"number", plan.part}, {"of", plan.parts}};
  document["seed"] = plan.seed;
  document["interrupted"] = result.interrupted;
  document["faults"] = faultsOf(plan, result);
  document["requirements"] = requirementsOf(plan, result);
  document["violations"] = Json::array();
  eachFlown(plan, result, [&](const CampaignFlight& flight, const Verdict& verdict) {
    if (verdict.outcome == Verdict::Outcome::Violation) {
      document["violations"].push_back(flightOf(plan, flight, verdict));
    }
  });
}

}  // namespace glider::driver
