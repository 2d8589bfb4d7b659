// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/workers/serve.h"

#include "campaign/campaign_csv.h"
#include "campaign/workers/fields.h"
#include "campaign/workers/host.h"
#include "campaign/workers/landing.h"
#include "campaign/workers/threads.h"

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <sstream>
#include <thread>

namespace glider::campaign {
namespace {

/// Sends the results of flights to rank 0.
void report(const CampaignPlan& plan, Ranks& ranks, const std::vector<EndedFlight>& flights) {
  for (const EndedFlight& one : flights) {
    if (!one.verdict) {
      const support::Failure& failure = one.verdict.error();
      ranks.send(0, MessageKind::Failed,
                 joinFields({hostName(), fmt::to_string(static_cast<unsigned>(failure.id)),
                             failure.message, failure.hint}));
      continue;
    }
    std::string row = csvRow(plan, flightOf(plan, one.number), *one.verdict);
    row.pop_back();
    ranks.send(0, one.hung ? MessageKind::HungRow : MessageKind::Row, row);
  }
}

std::vector<uint64_t> numbersIn(const std::string& text) {
  std::istringstream in(text);
  std::vector<uint64_t> numbers;
  for (uint64_t number = 0; in >> number;) {
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace

bool serveRank(const CampaignPlan& plan, Ranks& ranks, const std::function<bool()>& stop) {
  Threads threads(plan, stop);
  for (bool interrupted = false;;) {
    while (const auto message = ranks.receive()) {
      if (message->kind == MessageKind::Fly) {
        threads.add(numbersIn(message->text));
        continue;
      }
      if (message->kind == MessageKind::Stop) {
        threads.abandon();
      }
      report(plan, ranks, threads.land(message->kind == MessageKind::Land ? kToLand : kToStop));
      ranks.send(0, MessageKind::Bye);
      return threads.isRunning();
    }
    report(plan, ranks, threads.wait(kRanksPause));
    if (!interrupted && stop()) {
      interrupted = true;
      ranks.send(0, MessageKind::Interrupted);
    }
  }
}

void awaitEnd(Ranks& ranks) {
  while (!ranks.receive()) {
    std::this_thread::sleep_for(kRanksPause);
  }
  ranks.send(0, MessageKind::Bye);
}

bool dismissRanks(Ranks& ranks) {
  for (size_t rank = 1; rank < ranks.size(); ++rank) {
    ranks.send(rank, MessageKind::Stop);
  }
  const auto deadline = std::chrono::steady_clock::now() + kToStop;
  for (size_t gone = 1; gone < ranks.size();) {
    const auto message = ranks.receive();
    if (message) {
      gone += message->kind == MessageKind::Bye ? 1U : 0U;
      continue;
    }
    if (std::chrono::steady_clock::now() > deadline) {
      return false;
    }
    std::this_thread::sleep_for(kRanksPause);
  }
  return true;
}

}  // namespace glider::campaign
