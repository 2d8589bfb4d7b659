// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The SBC loses its power in flight: from whatever that leaves of the checkpoints the mission goes
// on as if it had only been deaf meanwhile.

#include "runtime/abi/window.h"
#include "runtime/checkpoint/checkpoint.h"
#include "runtime/core/lay_out.h"
#include "runtime/library/library.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/power_cut_store.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <map>
#include <optional>

namespace glider::runtime::testing {
namespace {

using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::Not;

/// What of a context outlives a power cut.
Bytes bodyOf(const GliderContext& context) {
  const auto* from = reinterpret_cast<const uint8_t*>(&context.mission_time);
  return {from, reinterpret_cast<const uint8_t*>(context.calls)};
}

/// A tick as it went into the mission, and what it made of it.
struct Tick {
  double time;
  std::vector<GliderUpdate> updates;
  Bytes body;
};

/// A yo that calls another one for a while: it has a stack, variables (ticks counted, and the mean
/// of depth copied), a window, and memory of its profile.
class ResumeTest : public ::testing::Test {
 protected:
  ResumeTest() {
    mission_.sensors = {depthSensor(), temperatureSensor()};
    mission_.states = {benchState("first", to_second_, 2), benchState("second", &back_, 1)};
    mission_.variable_count = 2;
    mission_.mission.temporal_slots = GLIDER_WINDOW_HEADER + GLIDER_WINDOW_SLOT * window_.bins;
    mission_.guards = [this](const GliderContext& c) {
      const bool over = c.mission_time >= end;
      const bool leaves = c.mission_time >= 100 && c.mission_time < 160;
      return c.state == 1 ? (leaves ? GLIDER_NO_CASE : 0U)
             : over       ? 1U
                          : (leaves ? 0U : GLIDER_NO_CASE);
    };
    mission_.begin = [this](GliderContext& c) {
      gliderWindowStart(c.temporals, &window_, c.mission_time);
      c.variables[0] = 0;
    };
    mission_.advance = [this](GliderContext& c) {
      gliderWindowAdvance(c.temporals, &window_, c.mission_time, c.mission_time,
                          c.readings[0].value, 1);
      c.variables[0] += counts ? 1 : 0;
      c.variables[1] = counts ? c.temporals[0] : 0;
    };
    mission_.fly = [](GliderContext& c, uint32_t phase) {
      gliderProfileYo(&c, &c.memory[0], phase, 5, c.state == 0 ? 12 : 15, .454, .454);
    };
    mission_.mission.resume_within = 120;
    mission_.finish(1);
    mission_.mission.memory_count = 1;
    mission_.mission.context_bytes =
        static_cast<uint32_t>(gliderContextLayout(&mission_.mission).bytes);
    mission_.memory.assign(mission_.mission.context_bytes / sizeof(double), 0.0);
  }

  /// Power comes: the program starts, and remembers nothing but its checkpoints.
  void boot(VehicleBench& vehicle, uint32_t program = 7) {
    runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, -1.0);
    std::ranges::fill(mission_.memory, -1.0);
    const GliderRuntimeOptions options{{this, &ResumeTest::writeLog, nullptr, nullptr},
                                       nullptr,
                                       keeps ? store_.store() : GliderStore{},
                                       program};
    runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                                 &options);
    ASSERT_NE(runtime_, nullptr);
    finished_ = false;
    last_time_.reset();
    vehicle.sbc = [this, &vehicle] { poll(vehicle); };
  }
  static void cutPower(VehicleBench& vehicle) {
    vehicle.sbc = [] {};
  }

  void poll(VehicleBench& vehicle) {
    const GliderByteStream stream = vehicle.sbcEnd();
    double now = vehicle.now();
    const GliderClock clock{&now, [](void* t) { return *static_cast<double*>(t); }};
    for (int i = 0; i < 100 && !finished_; ++i) {
      const auto status = gliderRuntimePoll(runtime_, &stream, &clock);
      finished_ = status == kGliderRuntimeFinished;
      noteTick();
      if (status == kGliderRuntimeIdle) {
        return;
      }
    }
  }

  void noteTick() {
    const GliderContext* c = gliderRuntimeContext(runtime_);
    if (c == nullptr || (last_time_ && *last_time_ == c->mission_time)) {
      return;
    }
    last_time_ = c->mission_time;
    Tick tick{c->mission_time, {}, bodyOf(*c)};
    for (uint32_t i = 0; i < 2; ++i) {
      if (c->readings[i].seen != 0 && c->readings[i].updated == c->mission_time) {
        tick.updates.push_back(update(mission_.sensors[i].id, c->readings[i].raw));
      }
    }
    ticks_.push_back(tick);
  }

  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<ResumeTest*>(self)->log_text_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }

  /// The ticks of an undisturbed mission that is fed with those.
  std::vector<Bytes> undisturbed(const std::vector<Tick>& fed) {
    std::vector<double> memory(mission_.memory.size(), -2.0);
    GliderContext* context = nullptr;
    std::vector<Bytes> bodies;
    for (const Tick& tick : fed) {
      const auto count = static_cast<uint32_t>(tick.updates.size());
      if (context == nullptr) {
        context =
            gliderStart(memory.data(), &mission_.mission, nullptr, tick.updates.data(), count);
      } else {
        gliderStep(context, tick.time, tick.updates.data(), count);
      }
      bodies.push_back(bodyOf(*context));
    }
    return bodies;
  }

  [[nodiscard]] std::string logCsv() const { return csvOf(log_text_); }

  GliderWindowShape window_{60, 4, 17, kGliderMean, 0, 0};
  GliderCaseInfo to_second_[2] = {{kGliderCall, 1}, {kGliderExit, 0}};
  GliderCaseInfo back_{kGliderReturn, 0};
  double end = 400;
  bool counts = true;  ///< a variable changes in every tick
  bool keeps = true;
  BenchMission mission_;
  RecordingStore store_;
  std::vector<double> runtime_memory_;
  GliderRuntime* runtime_ = nullptr;
  bool finished_ = false;
  std::optional<double> last_time_;
  std::vector<Tick> ticks_;
  std::string log_text_;
};

class Counting : public ResumeTest, public ::testing::WithParamInterface<bool> {};

TEST_P(Counting, WhateverAPowerCutLeavesOfTheFileTheLastCommittedTickStandsInIt) {
  counts = GetParam();
  std::vector<Bytes> kept;  // of each commit, in order
  VehicleBench vehicle({.silence_secs = 24});
  store_.mark = [this, &kept] {
    const Bytes body = bodyOf(*reinterpret_cast<const GliderContext*>(mission_.memory.data()));
    if (kept.empty() || kept.back() != body) {
      kept.push_back(body);
    }
    return kept.size();
  };
  boot(vehicle);
  vehicle.run(counts ? 220 : 420);
  ASSERT_GT(kept.size(), 20U);

  std::vector<double> memory(mission_.memory.size());
  size_t files = 0;
  for (size_t made = 0; made <= store_.log.size(); ++made) {
    const bool is_synced = made > 0 && store_.log[made - 1].bytes.empty();
    const size_t newest = made == 0 ? 0 : store_.log[made - 1].answered;
    const size_t whole = is_synced ? newest : newest - (made == 0 ? 0 : 1);
    eachFileAfterCut(store_.log, made, [&](const Bytes& file) {
      ++files;
      RecordingStore left;
      left.content = file;
      GliderContext* context = layOut(memory.data(), mission_.mission);
      LinkFacts facts;
      const auto found = Checkpoint(left.store(), 7).find(*context, facts);
      if (found != Checkpoint::Found::Good) {
        ASSERT_EQ(whole, 0U) << "one was whole after " << made << " writes";
        return;
      }
      const Bytes body = bodyOf(*context);
      const bool of_last = whole > 0 && body == kept[whole - 1];
      const bool of_newest = newest > 0 && body == kept[newest - 1];
      ASSERT_TRUE(of_last || of_newest) << "after " << made << " writes";
      ASSERT_TRUE(!is_synced || of_newest) << "what was synced is what is found";
    });
    if (HasFatalFailure()) {
      return;
    }
  }
  EXPECT_GT(files, 3000U);
}

INSTANTIATE_TEST_SUITE_P(, Counting, ::testing::Bool());

TEST_F(ResumeTest, WearIsBoundedAndTheFileDoesNotGrow) {
  counts = false;
  end = 1000;
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(900);
  const auto syncs =
      std::ranges::count_if(store_.log, [](const auto& w) { return w.bytes.empty(); });
  EXPECT_LE(syncs, 900 / 20 + 6) << "each 20 s, two transitions and their commands";
  EXPECT_GE(syncs, 900 / 20 - 3);
  EXPECT_LE(store_.content.size(), Checkpoint::kSlots * 4 * Checkpoint::kBlock);
  std::map<uint32_t, int> writes;
  for (const auto& write : store_.log) {
    writes[write.offset] += write.bytes.empty() ? 0 : 1;
  }
  for (const auto& [offset, count] : writes) {
    EXPECT_LE(count, syncs / static_cast<int>(Checkpoint::kSlots) + 1) << "at " << offset;
  }
}

/// When the power goes, and for how long.
struct Outage {
  double at, lasts;
  bool counts;
};

class Outages : public ResumeTest, public ::testing::WithParamInterface<Outage> {};

TEST_P(Outages, TheMissionGoesOnAsIfItHadOnlyBeenDeaf) {
  const auto [at, lasts, every_tick] = GetParam();
  counts = every_tick;
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(at);
  ASSERT_FALSE(ticks_.empty());
  // Ticks since the last that was kept are as if never heard.
  std::vector<double> memory(mission_.memory.size());
  GliderContext* kept = layOut(memory.data(), mission_.mission);
  LinkFacts facts;
  ASSERT_EQ(Checkpoint(store_.store(), 7).find(*kept, facts), Checkpoint::Found::Good);
  EXPECT_GE(kept->mission_time, ticks_.back().time - (counts ? 0 : Checkpoint::kMostApart));
  while (ticks_.back().time > kept->mission_time) {
    ticks_.pop_back();
  }
  EXPECT_EQ(ticks_.back().body, bodyOf(*kept));
  cutPower(vehicle);
  vehicle.run(at + lasts);
  const size_t before = ticks_.size();
  boot(vehicle);
  vehicle.run(at + lasts + 12);
  ASSERT_GT(ticks_.size(), before) << "within a cycle of the link";
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed"));
  vehicle.run(700);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Complete) << "given back by the mission";
  const auto expected = undisturbed(ticks_);
  for (size_t i = 0; i < ticks_.size(); ++i) {
    ASSERT_EQ(ticks_[i].body, expected[i]) << "tick of " << ticks_[i].time << " s";
  }
  EXPECT_THAT(vehicle.answers, Each(hooks::HookAnswer::Accepted));
  if (lasts < 16) {
    EXPECT_THAT(logCsv(), Not(HasSubstr("control lost")));
  }
}

INSTANTIATE_TEST_SUITE_P(, Outages,
                         ::testing::Values(Outage{30, 3, true}, Outage{50, 9, false},
                                           Outage{101, 5, true}, Outage{105, 14, false},
                                           Outage{130, 60, true}, Outage{150, 100, false},
                                           Outage{158, 8, false}, Outage{230, 90, true}));

TEST_F(ResumeTest, AShortOutageGoesOnInTheSameSessionAndHookbehNeverLetsGo) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  const uint32_t session = vehicle.hookbeh().session;
  cutPower(vehicle);
  vehicle.run(68);
  boot(vehicle);
  for (double t = 69; t < 300; ++t) {
    vehicle.run(t);
    ASSERT_EQ(vehicle.hookbeh().state, hooks::HookState::Active) << t;
    ASSERT_EQ(vehicle.hookbeh().session, session) << t;
  }
}

TEST_F(ResumeTest, AfterSilenceControlIsTakenOnlyByANewHandshake) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  const uint32_t session = vehicle.hookbeh().session;
  cutPower(vehicle);
  vehicle.run(120);
  ASSERT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  boot(vehicle);
  vehicle.run(150);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_GT(vehicle.hookbeh().session, session);
}

TEST_F(ResumeTest, AfterAnOutageLongerThanTheMissionAllowsControlStaysWithTheVehicle) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  cutPower(vehicle);
  vehicle.run(200);
  boot(vehicle);
  vehicle.run(300);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(gliderRuntimeContext(runtime_), nullptr);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  EXPECT_THAT(logCsv(), HasSubstr("control left to the vehicle"));
  boot(vehicle);  // and again: it stays so
  vehicle.run(400);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
}

TEST_F(ResumeTest, AMissionThatNeverResumesLetsGoEvenOfASessionThatIsStillObeyed) {
  mission_.mission.resume_within = 0;
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  cutPower(vehicle);
  vehicle.run(65);
  boot(vehicle);
  vehicle.run(140);
  EXPECT_TRUE(finished_);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
}

TEST_F(ResumeTest, AnotherFlightOfTheVehicleBeginsTheMissionAnew) {
  {
    VehicleBench first({.silence_secs = 24});
    boot(first);
    first.run(60);
  }
  VehicleBench second({.silence_secs = 24});
  boot(second);
  second.run(40);
  EXPECT_EQ(second.hookbeh().state, hooks::HookState::Active);
  EXPECT_LT(gliderRuntimeContext(runtime_)->mission_time, 40);
  EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is of an earlier flight"));
  cutPower(second);
  second.run(50);
  boot(second);
  second.run(70);
  EXPECT_THAT(logCsv(), HasSubstr("mission resumed")) << "the newest one is the second flight's";
}

TEST_F(ResumeTest, ACheckpointFromTheFutureLeavesControlToTheVehicle) {
  {
    VehicleBench first({.silence_secs = 24});
    boot(first);
    first.run(300);
  }
  VehicleBench second({.silence_secs = 24});
  keeps = false;
  boot(second);
  second.run(60);
  ASSERT_EQ(second.hookbeh().state, hooks::HookState::Active);
  keeps = true;
  boot(second);
  second.run(120);
  EXPECT_TRUE(finished_);
  EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is from the future"));
  EXPECT_EQ(second.hookbeh().state, hooks::HookState::Silent);
}

TEST_F(ResumeTest, ACheckpointOfAnotherProgramIsNotTaken) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle, 7);
  vehicle.run(60);
  boot(vehicle, 8);
  vehicle.run(140);
  EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is another program's"));
  EXPECT_THAT(logCsv(), Not(HasSubstr("mission resumed")));
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active) << "after the silence";
}

TEST_F(ResumeTest, WithOtherParametersItIsAnotherProgram) {
  double chosen[] = {12};
  mission_.parameters = {{"bottom", 12, 0, 100, "m=3ff0000000000000"}};
  mission_.finish(1);
  std::vector<double> memory(mission_.memory.size());
  const auto found = [&] {
    const GliderRuntimeOptions options{
        {this, &ResumeTest::writeLog, nullptr, nullptr}, chosen, store_.store(), 7};
    runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, 0.0);
    log_text_.clear();
    runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                                 &options);
    VehicleBench vehicle({.silence_secs = 24});
    vehicle.sbc = [&] { poll(vehicle); };
    vehicle.run(30);
    return logCsv();
  };
  EXPECT_THAT(found(), Not(HasSubstr("begins anew")));
  EXPECT_THAT(found(), HasSubstr("earlier flight"));
  chosen[0] = 13;
  EXPECT_THAT(found(), HasSubstr("another program's"));
}

TEST_F(ResumeTest, DamagedCheckpointsBeginTheMissionAnewAndSayso) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  cutPower(vehicle);
  for (size_t i = 0; i < store_.content.size(); i += 100) {
    store_.content[i + 60 < store_.content.size() ? i + 60 : i] ^= 0x10;
  }
  boot(vehicle);
  vehicle.run(140);
  EXPECT_THAT(logCsv(), HasSubstr("no checkpoint is whole"));
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
}

TEST_F(ResumeTest, NoFileOfAnyBytesAndNoLengthIsACrash) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(200);
  const Bytes whole = store_.content;
  uint64_t random = 1;
  const auto next = [&random] {
    random = random * 6364136223846793005U + 1442695040888963407U;
    return static_cast<size_t>(random >> 33U);
  };
  std::vector<double> memory(mission_.memory.size());
  for (int round = 0; round < 400; ++round) {
    RecordingStore damaged;
    damaged.content = whole;
    damaged.content.resize(next() % 3 == 0 ? next() % (whole.size() * 2) : whole.size());
    for (size_t i = next() % 200; i > 0 && !damaged.content.empty(); --i) {
      damaged.content[next() % damaged.content.size()] = static_cast<uint8_t>(next());
    }
    GliderContext* context = layOut(memory.data(), mission_.mission);
    LinkFacts facts;
    if (Checkpoint(damaged.store(), 7).find(*context, facts) == Checkpoint::Found::Good) {
      EXPECT_LT(context->state, 2U);
      EXPECT_LE(context->stack_depth, 1U);
    }
  }
}

TEST_F(ResumeTest, ACardThatFailsIsToldOnceAndTheMissionFliesOn) {
  VehicleBench vehicle({.silence_secs = 24});
  boot(vehicle);
  vehicle.run(60);
  store_.fails = true;
  vehicle.run(140);
  store_.fails = false;
  vehicle.run(200);
  store_.fails = true;
  vehicle.run(600);
  EXPECT_TRUE(finished_);
  const std::string log = logCsv(), told = "checkpoint not written";
  const size_t first = log.find(told);
  ASSERT_NE(first, std::string::npos);
  const size_t second = log.find(told, first + 1);
  ASSERT_NE(second, std::string::npos);
  EXPECT_EQ(log.find(told, second + 1), std::string::npos);
  const auto notes = std::ranges::count_if(vehicle.events, [](const hooks::HookprogEvent& e) {
    return e.kind == hooks::HookprogEvent::Kind::SbcNote &&
           std::string(e.text) == "the SBC's checkpoint is not written";
  });
  EXPECT_EQ(notes, 2) << "the vehicle's log has it too";
}

}  // namespace
}  // namespace glider::runtime::testing
