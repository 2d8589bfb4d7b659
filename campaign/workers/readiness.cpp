// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/workers/readiness.h"

#include "campaign/workers/fields.h"
#include "campaign/workers/host.h"
#include "support/diagnostics/ids/flights.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace glider::campaign {

Readiness readinessOf(const CampaignPlan& plan, const std::string& identity) {
  Readiness readiness;
  readiness.host = hostName();
  readiness.identity = identity;
  readiness.boards = fmt::format("{}", fmt::join(plan.boards, ", "));
  for (const CampaignMission& mission : plan.missions) {
    const simulator::FlightTimes& times = mission.times;
    readiness.measured +=
        fmt::format("{} {} {} {} {} {} {} ", times.flight_s, times.take_s, times.release_s,
                    times.deepest_m, times.hover.from_s, times.hover.to_s, mission.mean_W);
  }
  return readiness;
}

Readiness unreadiness(int status, const std::string& reported) {
  Readiness readiness;
  readiness.host = hostName();
  readiness.status = status;
  readiness.reported = reported;
  return readiness;
}

void sendReadiness(Ranks& ranks, const Readiness& readiness) {
  ranks.send(0, MessageKind::Ready,
             joinFields({readiness.host, fmt::to_string(readiness.status), readiness.reported,
                         readiness.identity, readiness.boards, readiness.measured}));
}

std::vector<Readiness> awaitReadiness(Ranks& ranks) {
  std::vector<Readiness> all;
  while (all.size() + 1 < ranks.size()) {
    const auto message = ranks.receive();
    if (!message) {
      std::this_thread::sleep_for(kRanksPause);
      continue;
    }
    const auto fields = splitFields(message->text, 6);
    all.push_back({message->from, fields[0], std::atoi(fields[1].c_str()), fields[2], fields[3],
                   fields[4], fields[5]});
  }
  return all;
}

support::Result<void> requireSame(const Readiness& own, const std::vector<Readiness>& others) {
  for (const Readiness& other : others) {
    const auto refuse = [&](const std::string& why, const std::string& hint) {
      return support::fail(support::diagnostics::rankDiffers, other.rank, other.host, why, hint);
    };
    if (other.boards != own.boards) {
      return refuse(
          fmt::format("it has emulators of the boards `{}`, not of `{}`", other.boards, own.boards),
          "install the same emulators on all machines, or fly with `--boards 0`");
    }
    if (other.identity != own.identity) {
      return refuse("its glidercc, files or options are not the same",
                    "give all ranks the same glidercc, missions, scenario and options");
    }
    if (other.measured != own.measured) {
      return refuse(
          "its processor or C library rounds differently: a flight without faults differs",
          "use machines of one kind");
    }
  }
  return {};
}

}  // namespace glider::campaign
