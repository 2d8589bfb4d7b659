// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "campaign/workers/fly_all.h"

#include "campaign/campaign_csv.h"
#include "campaign/workers/deal.h"
#include "campaign/workers/fields.h"
#include "campaign/workers/host.h"
#include "campaign/workers/landing.h"
#include "campaign/workers/threads.h"
#include "support/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <utility>

namespace glider::campaign {

using simulator::Verdict;
using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;

namespace {

constexpr milliseconds kGlance{200};

/// Deals the flights and collects their results. Worker 0 of the deal is this process, the
/// others are the other ranks.
class Leader {
 public:
  Leader(const CampaignPlan& plan, CampaignResult known, const CampaignListener& listener,
         Ranks* ranks)
      : plan_(plan),
        listener_(listener),
        ranks_(ranks),
        result_(std::move(known)),
        threads_(plan, listener.stop),
        deal_(plan, result_, ranks == nullptr ? 1 : ranks->size()) {}

  CampaignResult fly();

 private:
  [[nodiscard]] bool isOver() const {
    return deal_.isDone() || result_.failure || result_.hung || result_.interrupted;
  }
  void deal();
  void note(uint64_t number, support::Result<Verdict> verdict);
  void noteAll(std::vector<EndedFlight> flights);
  void hear(const Message& message);
  void hearRow(const Message& message);
  void hearRanks();
  void land();
  void awaitRanks(milliseconds limit);
  void showProgress();

  const CampaignPlan& plan_;
  const CampaignListener& listener_;
  Ranks* const ranks_;
  CampaignResult result_;
  Threads threads_;
  Deal deal_;
  uint64_t over_ = 0;
  size_t gone_ = 0;  ///< ranks that have sent their last message
  Clock::time_point shown_;
};

CampaignResult Leader::fly() {
  const FlightRange range = rangeOf(plan_);
  over_ = static_cast<uint64_t>(
      std::count_if(result_.verdicts.begin() + static_cast<std::ptrdiff_t>(range.begin),
                    result_.verdicts.begin() + static_cast<std::ptrdiff_t>(range.end),
                    [](const auto& verdict) { return verdict.has_value(); }));
  while (!isOver()) {
    deal();
    noteAll(threads_.wait(ranks_ == nullptr ? kGlance : kRanksPause));
    hearRanks();
    result_.interrupted = result_.interrupted || listener_.stop();
    if (Clock::now() - shown_ >= kGlance) {
      showProgress();
    }
  }
  land();
  showProgress();
  return std::move(result_);
}

void Leader::showProgress() {
  shown_ = Clock::now();
  listener_.progress(over_);
}

void Leader::deal() {
  threads_.add(deal_.next(0));
  for (size_t rank = 1; ranks_ != nullptr && rank < ranks_->size(); ++rank) {
    if (const auto numbers = deal_.next(rank); !numbers.empty()) {
      ranks_->send(rank, MessageKind::Fly, fmt::format("{}", fmt::join(numbers, " ")));
    }
  }
}

void Leader::note(uint64_t number, support::Result<Verdict> verdict) {
  if (result_.interrupted || result_.failure) {
    return;
  }
  if (!verdict) {
    result_.failure = verdict.error();
    return;
  }
  if (auto noted = listener_.over(flightOf(plan_, number), *verdict); !noted) {
    result_.failure = noted.error();
  }
  result_.verdicts[number] = std::move(*verdict);
  result_.interrupted = listener_.stop();
  ++over_;
}

void Leader::noteAll(std::vector<EndedFlight> flights) {
  for (EndedFlight& one : flights) {
    deal_.isOver(0);
    note(one.number, std::move(one.verdict));
    result_.hung = result_.hung || one.hung;
  }
}

void Leader::hearRow(const Message& message) {
  uint64_t number = 0;
  Verdict verdict;
  CHECK(parseRow(plan_, message.text, number, verdict), "a rank sent a row of another campaign");
  deal_.isOver(message.from);
  note(number, std::move(verdict));
  result_.hung = result_.hung || message.kind == MessageKind::HungRow;
}

void Leader::hear(const Message& message) {
  switch (message.kind) {
    case MessageKind::Row:
    case MessageKind::HungRow:
      hearRow(message);
      break;
    case MessageKind::Failed: {
      const auto fields = splitFields(message.text, 4);
      note(0, std::unexpected(support::Failure{
                  static_cast<support::DiagnosticId>(std::atoi(fields[1].c_str())),
                  fmt::format("on `{}` (rank {}): {}", fields[0], message.from, fields[2]),
                  fields[3]}));
      break;
    }
    case MessageKind::Interrupted:
      result_.interrupted = true;
      break;
    case MessageKind::Bye:
      ++gone_;
      break;
    case MessageKind::Ready:
    case MessageKind::Fly:
    case MessageKind::Land:
    case MessageKind::Stop:
      CHECK(false, "a rank sent what it sends only before, or what only rank 0 sends");
  }
}

void Leader::hearRanks() {
  while (ranks_ != nullptr) {
    const auto message = ranks_->receive();
    if (!message) {
      break;
    }
    hear(*message);
  }
}

void Leader::awaitRanks(milliseconds limit) {
  const auto deadline = Clock::now() + limit;
  while (gone_ + 1 < ranks_->size() && Clock::now() < deadline) {
    hearRanks();
    std::this_thread::sleep_for(kRanksPause);
  }
  result_.left_ranks = gone_ + 1 < ranks_->size();
}

void Leader::land() {
  const bool stops = result_.interrupted || result_.failure;
  for (size_t rank = 1; ranks_ != nullptr && rank < ranks_->size(); ++rank) {
    ranks_->send(rank, stops ? MessageKind::Stop : MessageKind::Land);
  }
  if (stops) {
    threads_.abandon();
  }
  noteAll(threads_.land(stops ? kToStop : kToLand));
  result_.running = threads_.isRunning();
  if (ranks_ != nullptr) {
    awaitRanks(result_.interrupted ? kToStopRanks : milliseconds(kToStop));
  }
}

}  // namespace

CampaignResult flyAll(const CampaignPlan& plan, CampaignResult known,
                      const CampaignListener& listener, Ranks* ranks) {
  known.verdicts.resize(plan.flights);
  return Leader(plan, std::move(known), listener, ranks).fly();
}

}  // namespace glider::campaign
