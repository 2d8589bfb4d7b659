// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/campaign/on_ranks.h"

#include "driver/campaign/fly.h"
#include "driver/campaign/plan.h"
#include "driver/exit_code.h"
#include "driver/interruption.h"
#include "driver/terminal.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <optional>
#include <string>
#include <thread>

namespace glider::driver {
namespace {

/// Waits until all other ranks are ready to fly the same campaign; reports the first that is not.
int awaitSame(const campaign::CampaignPlan& plan, const std::string& identity,
              campaign::Ranks& ranks) {
  const auto others = campaign::awaitReadiness(ranks);
  for (const campaign::Readiness& other : others) {
    if (other.status != kFine) {
      tell(fmt::format("glidercc: rank {} on `{}` cannot fly:\n{}", other.rank, other.host,
                       other.reported));
      return other.status;
    }
  }
  const auto same = campaign::requireSame(campaign::readinessOf(plan, identity), others);
  return same ? kFine : reportFailure(same.error());
}

int lead(const campaign::CampaignOptions& options, unsigned jobs, campaign::Ranks& ranks) {
  std::optional<campaign::CampaignPlan> plan(std::in_place);
  Flown flown;
  flown.status = makePlan(options, jobs, *plan);
  support::Result<std::string> identity;
  if (flown.status == kFine) {
    identity = campaign::identityOf(*plan, options);
    flown.status = identity ? awaitSame(*plan, *identity, ranks) : reportFailure(identity.error());
  }
  if (flown.status == kFine) {
    flown = flyThem(*plan, options, *identity, &ranks, nullptr);
  }
  plan.reset();  // with it go the folders of the boards' binaries
  const bool ended = flown.begun ? !flown.left_ranks : campaign::dismissRanks(ranks);
  if (!ended) {
    ranks.abort(flown.status);
  }
  ranks.leave();
  if (flown.running) {
    std::_Exit(flown.status);  // its threads would not let the program end
  }
  return flown.status;
}

int follow(const campaign::CampaignOptions& options, unsigned jobs, campaign::Ranks& ranks) {
  bool running = false;
  {
    const KeptMessages messages;
    campaign::CampaignPlan plan;
    int status = makePlan(options, jobs, plan);
    support::Result<std::string> identity;
    if (status == kFine) {
      identity = campaign::identityOf(plan, options);
      status = identity ? kFine : reportFailure(identity.error());
    }
    if (status == kFine) {
      const Interruption interruption;
      campaign::sendReadiness(ranks, campaign::readinessOf(plan, *identity));
      running = campaign::serveRank(plan, ranks, [] { return Interruption::signal() != 0; });
    } else {
      campaign::sendReadiness(ranks, campaign::unreadiness(status, messages.text()));
      campaign::awaitEnd(ranks);
    }
  }
  ranks.leave();
  if (running) {
    std::_Exit(kFine);
  }
  return kFine;
}

}  // namespace

int campaignOnRanks(const campaign::CampaignOptions& options, unsigned jobs,
                    const campaign::Launch& launch) {
  const auto ranks = campaign::joinRanks(launch);
  if (ranks) {
    return (*ranks)->rank() == 0 ? lead(options, jobs, **ranks) : follow(options, jobs, **ranks);
  }
  if (launch.rank == 0) {
    return reportFailure(ranks.error());
  }
  // mpirun ends all ranks when one fails: rank 0 must have reported why.
  std::this_thread::sleep_for(std::chrono::seconds(1));
  return kWorldFailed;
}

}  // namespace glider::driver
