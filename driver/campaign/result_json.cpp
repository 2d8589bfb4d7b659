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

Json faultsOf(const CampaignPlan& plan, const CampaignResult& result) {
  Json faults = Json::object();
  campaign::eachFlown(plan, result, [&](const CampaignFlight& flight, const Verdict& verdict) {
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
  for (const campaign::RequirementCount& count : campaign::requirementCounts(plan, result)) {
    const campaign::CampaignMission& flown = plan.missions[count.mission];
    requirements.push_back({{"mission", flown.file},
                            {"text", flown.requirements[count.requirement]},
                            {"flights", count.flights},
                            {"violated", count.violated}});
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
  campaign::eachFlown(plan, result, [&](const CampaignFlight& flight, const Verdict& verdict) {
    if (verdict.outcome == Verdict::Outcome::Violation) {
      document["violations"].push_back(flightOf(plan, flight, verdict));
    }
  });
}

}  // namespace glider::driver
