// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// What is proved about an example mission survives random flights: all of its properties observe
// each of them. scripts/soak/proofs flies more of the same.

#include "ir/prove/context/proof_context.h"
#include "ir/prove/falsification/random_flight.h"
#include "ir/verify/verify.h"
#include "tests/proofs/properties.h"
#include "tests/unit/frontend/compile.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <map>
#include <mutex>
#include <thread>

namespace glider::tests {
namespace {

using Clock = std::chrono::steady_clock;

/// The environment's number `name`, or `standard`.
uint64_t wanted(const char* name, uint64_t standard) {
  const char* text = std::getenv(name);
  return text == nullptr ? standard : std::stoull(text);
}

/// What is proved about a mission.
struct Proved {
  std::string mission;
  std::vector<std::string> requirements;
  friend void PrintTo(const Proved& proved, std::ostream* out) { *out << proved.mission; }
};

/// Flights can break nothing of `reach`: one that goes elsewhere proves nothing.
std::vector<Proved> provedMissions() {
  std::map<std::string, std::vector<std::string>> found;
  for (const Property& property : properties()) {
    if (property.verdict == "proved" && !property.requirement.starts_with("reach ")) {
      found[property.mission].push_back(property.requirement);
    }
  }
  std::vector<Proved> all;
  for (const auto& [mission, requirements] : found) {
    all.push_back({mission, requirements});
  }
  return all;
}

std::string textOf(const Proved& proved) {
  std::string text =
      frontend::testing_support::readWithoutPromises("missions/" + proved.mission + ".mission");
  for (const std::string& requirement : proved.requirements) {
    text += "require " + requirement + "\n";
  }
  return text;
}

/// Flights of one mission, as many at a time as there are processors.
class Flights {
 public:
  Flights(const ir::Mission& mission, const ir::MissionFacts& facts)
      : ground_(mission, slocum()), stack_depth_(facts.stack_depth) {}

  /// What was broken first, in words; empty: nothing was.
  std::string fly(uint64_t first_seed, uint64_t count) {
    next_ = first_seed;
    end_ = first_seed + count;
    std::vector<std::thread> threads;
    const uint64_t jobs = std::clamp<uint64_t>(count / 100, 1, std::thread::hardware_concurrency());
    for (uint64_t i = 0; i < jobs; ++i) {
      threads.emplace_back([this] { work(); });
    }
    std::ranges::for_each(threads, &std::thread::join);
    return broken_;
  }

 private:
  void work() {
    constexpr size_t kTicks = 4000;
    for (uint64_t seed = next_++; seed < end_; seed = next_++) {
      const auto run =
          ir::prove::flyAtRandom(ground_, stack_depth_, ground_.mission.requirements, seed, kTicks);
      if (run) {
        const std::lock_guard lock(mutex_);
        broken_ = fmt::format("requirement {}, seed {}, at {} s in state {}", run->requirement,
                              seed, run->when, run->state);
        next_ = end_;
      }
    }
  }

  ir::prove::ProofContext ground_;
  uint32_t stack_depth_;
  std::atomic<uint64_t> next_ = 0;
  uint64_t end_ = 0;
  std::mutex mutex_;
  std::string broken_;
};

class ProvedProperties : public testing::TestWithParam<Proved> {};

TEST_P(ProvedProperties, SurviveRandomFlights) {
  constexpr uint64_t kFew = 3;
  const uint64_t count = wanted("GLIDER_PROOF_FLIGHTS", kFew);
  const uint64_t seed = wanted("GLIDER_PROOF_SEED", 1);
  frontend::testing_support::FrontendRun run(textOf(GetParam()));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  ASSERT_EQ(mission->requirements.size(), GetParam().requirements.size());
  const auto begin = Clock::now();
  const std::string broken =
      Flights(*mission, ir::verify(*mission, run.diagnostics)).fly(seed, count);
  EXPECT_EQ(broken, "");
  const std::chrono::duration<double> took = Clock::now() - begin;
  if (count > kFew) {
    fmt::print("{}: {} flights, proved and looking on: {}, {:.1f} s\n", GetParam().mission, count,
               GetParam().requirements.size(), took.count());
    std::fflush(stdout);
  }
}

std::string nameOf(const testing::TestParamInfo<Proved>& info) {
  std::string name = info.param.mission;
  std::ranges::replace(name, '/', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Missions, ProvedProperties, testing::ValuesIn(provedMissions()), nameOf);

/// A property that is not so is seen to be broken: else what survives would say nothing.
TEST(RandomFlights, SeeAPropertyThatIsBroken) {
  const Proved wrong{"figure2", {"stack <= 1", "always depth <= 15 m"}};
  frontend::testing_support::FrontendRun run(textOf(wrong));
  const auto mission = run.compile();
  ASSERT_TRUE(mission.has_value()) << run.said();
  const std::string broken = Flights(*mission, ir::verify(*mission, run.diagnostics)).fly(1, 200);
  EXPECT_TRUE(broken.starts_with("requirement 1, ")) << broken;
}

}  // namespace
}  // namespace glider::tests
