// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Every check of log/checks.def, by a flipped bit in what it checks: the log says once which check
// failed, the runtime falls silent, and hookbeh ends its control. Those of missions in C are in
// c_program_test.cpp.

#include "runtime/core/runtime.h"
#include "runtime/library/library.h"
#include "runtime/log/check_text.h"
#include "tests/unit/runtime/bench_mission.h"
#include "tests/unit/runtime/log_csv.h"
#include "tests/unit/runtime/power_cut_store.h"
#include "tests/unit/runtime/reveal.h"
#include "tests/unit/runtime/vehicle_bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <gmock/gmock.h>
#include <iterator>
#include <set>
#include <string>
#include <vector>

REVEAL(RuntimeContext, GliderRuntime, GliderContext*, context_);
REVEAL(RuntimeClient, GliderRuntime, glider::hooks::Client, client_);
REVEAL(RuntimeControl, GliderRuntime, glider::runtime::Control, control_);
REVEAL(RuntimeLog, GliderRuntime, glider::runtime::MissionLog, log_);
REVEAL(ClientQueue, glider::hooks::Client, glider::hooks::SendQueue, out_);
REVEAL(ClientReader, glider::hooks::Client, glider::hooks::FrameReader, reader_);
REVEAL(ClientSubscription, glider::hooks::Client, glider::hooks::Subscribe, subscription_);
REVEAL(ClientTick, glider::hooks::Client, glider::hooks::VehicleTick, tick_);
REVEAL(ClientNotices, glider::hooks::Client, uint32_t, notice_count_);
REVEAL(ClientNotes, glider::hooks::Client, uint32_t, note_count_);
REVEAL(ClientPending, glider::hooks::Client, glider::hooks::Instruction, pending_);
REVEAL(QueueState, glider::hooks::SendQueue, HookSendQueue, queue_);
REVEAL(ReaderState, glider::hooks::FrameReader, HookFrameReader, reader_);
REVEAL(ControlState, glider::runtime::Control, glider::hooks::HookState, state_);
REVEAL(ControlPending, glider::runtime::Control, glider::hooks::HookControl, pending_);
REVEAL(ControlUnconfirmed, glider::runtime::Control, uint32_t, unconfirmed_);
REVEAL(ControlReleasing, glider::runtime::Control, uint32_t, releasing_ticks_);
REVEAL(ControlInstructed, glider::runtime::Control, glider::hooks::Instruction, instructed_);
REVEAL(ControlAccepted, glider::runtime::Control, glider::hooks::Instruction, accepted_);
REVEAL(LogSize, glider::runtime::MissionLog, uint32_t, size_);

namespace glider::runtime::testing {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

/// Flips bit `bit` of a number, of an enumeration or of a pointer.
template <typename Number>
void flip(Number& number, unsigned bit) {
  auto* bytes = reinterpret_cast<uint8_t*>(&number);
  bytes[bit / 8] = static_cast<uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
}

/// A mission with one of everything that is checked: `first` calls `second` at 20 s, which returns
/// at 200 s; `always` has a case that never fires by itself; the guards of `second` also ask a
/// table.
class CheckBench : public ::testing::Test {
 public:
  CheckBench() {
    mission_.sensors = {depthSensor(), temperatureSensor()};
    mission_.states = {benchState("first", &call_, 1, log_, 1), benchState("second", &back_, 1)};
    mission_.always = {{kGliderCall, 0}};
    mission_.mission.interval_count = gliderGuardMemory(1, 1);
    mission_.guards = [this](const GliderContext& c) {
      return guards(const_cast<GliderContext&>(c));
    };
    mission_.fly = [this](GliderContext& c, uint32_t phase) {
      if (tracks) {
        gliderProfileThermotrackyo(&c, &c.memory[1], phase, 5, 12, .454, .454, 1, 4);
      } else {
        gliderProfileYo(&c, &c.memory[0], phase, 5, 12, .454, .454);
      }
      gliderRouteNoheading(&c, &c.memory[2], phase);
    };
    mission_.mission.resume_within = 300;
    mission_.finish(1);
  }

  uint32_t guards(GliderContext& c) {
    (void)gliderFirstTrue(&c, &table, 0);
    if (guard_answer != 0) {
      return guard_answer;
    }
    return c.mission_time >= (c.state == 0 ? 20 : back_at) ? 0U : GLIDER_NO_CASE;
  }

  void boot() {
    runtime_memory_.assign(gliderRuntimeSize() / sizeof(double) + 1, 0.0);
    const GliderRuntimeOptions options{
        {this, &CheckBench::writeLog, nullptr, nullptr}, nullptr, store_.store(), 7};
    runtime_ = gliderRuntimeInit(runtime_memory_.data(), mission_.memory.data(), &mission_.mission,
                                 &options);
    ASSERT_NE(runtime_, nullptr);
    status_ = kGliderRuntimeIdle;
    vehicle.sbc = [this] { poll(); };
  }

  void poll() {
    const GliderByteStream stream = vehicle.sbcEnd();
    double now = vehicle.now();
    const GliderClock clock{&now, [](void* t) { return *static_cast<double*>(t); }};
    for (int i = 0; i < 100 && status_ != kGliderRuntimeFinished; ++i) {
      status_ = gliderRuntimePoll(runtime_, &stream, &clock);
      if (status_ != kGliderRuntimeProgressed) {
        return;
      }
    }
    EXPECT_EQ(status_, kGliderRuntimeFinished) << "the runtime never comes to rest";
  }

  static int32_t writeLog(void* self, const uint8_t* bytes, uint32_t count) {
    static_cast<CheckBench*>(self)->log_text_.append(reinterpret_cast<const char*>(bytes), count);
    return static_cast<int32_t>(count);
  }

  [[nodiscard]] std::string logCsv() const { return csvOf(log_text_); }
  /// The records of failed checks.
  [[nodiscard]] size_t records() const {
    size_t count = 0;
    const std::string csv = logCsv();
    for (size_t at = 0; (at = csv.find("internal check failed", at)) != std::string::npos; ++at) {
      ++count;
    }
    return count;
  }

  /// The vehicle after the failure: control has ended, and nothing came from the SBC.
  void expectSilence(Check check) {
    EXPECT_EQ(status_, kGliderRuntimeFailed);
    EXPECT_EQ(gliderRuntimeFailedCheck(runtime_), static_cast<uint32_t>(check));
    EXPECT_EQ(gliderRuntimeContext(runtime_), nullptr);
    EXPECT_EQ(records(), 1U) << logCsv();
    // What breaks within a tick may fail a second check before the next poll.
    EXPECT_THAT(logCsv(), ContainsRegex(std::string(",event,internal check failed,[12],") +
                                        checkText(static_cast<uint32_t>(check)) + ",\n"));
    const double heartbeat = vehicle.array(GLIDER_SCI_HOOK_HEARTBEAT);
    vehicle.run(vehicle.now() + 120);
    EXPECT_EQ(vehicle.array(GLIDER_SCI_HOOK_HEARTBEAT), heartbeat) << "a Done was sent";
    EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
    EXPECT_FALSE(vehicle.hookbeh().commanding);
    EXPECT_EQ(records(), 1U) << "the record is written once";
  }

  GliderContext& context() { return *(runtime_->*memberOf(RuntimeContext{})); }
  hooks::Client& client() { return runtime_->*memberOf(RuntimeClient{}); }
  Control& control() { return runtime_->*memberOf(RuntimeControl{}); }
  MissionLog& log() { return runtime_->*memberOf(RuntimeLog{}); }

  VehicleBench vehicle{{}, true};
  uint32_t guard_answer = 0;  ///< what the guards answer, unless 0
  double back_at = 1e6;
  bool tracks = false;  ///< flies thermotrackyo instead of yo
  GliderCaseInfo call_{kGliderCall, 1};
  GliderCaseInfo back_{kGliderReturn, 0};
  GliderLogInfo log_[1] = {{"depth", 0, kGliderSensor, 0}};
  BenchMission mission_;

  // A table of one row: depth >= 1000 m.
  const int64_t keys_[2] = {0x408F400000000000, 0x7FF8000000000000};
  const uint32_t rows_[3] = {0, 0, 0};
  const uint16_t turns_[2] = {0, 0};
  const uint16_t first_turn_[3] = {0, 1, 2};
  const uint16_t cases_[32] = {};
  const uint32_t exact_[1] = {1};
  GliderGuardColumn column_{keys_, rows_, turns_, first_turn_, 2, kGliderSensor, 0, 0};
  GliderGuardTable table{&column_, cases_, exact_, nullptr, 1, 1, 0, 0};

  RecordingStore store_;
  std::vector<double> runtime_memory_;
  GliderRuntime* runtime_ = nullptr;
  GliderRuntimeStatus status_ = kGliderRuntimeIdle;
  std::string log_text_;
};

struct Flip {
  Check check;
  std::function<void(CheckBench&)> damage;       ///< between two polls
  std::function<void(CheckBench&)> before = {};  ///< before the mission starts
  friend void PrintTo(const Flip& of, std::ostream* out) {
    *out << static_cast<int>(of.check) << ": " << checkText(static_cast<uint32_t>(of.check));
  }
};

/// A flip in a pointer of the context.
Flip pointer(uint32_t index, unsigned bit) {
  return {static_cast<Check>(static_cast<uint32_t>(Check::ReadingsPointer) + index),
          [index, bit](CheckBench& b) {
            flip(reinterpret_cast<uint8_t*>(&b.context().readings)[index * sizeof(void*)], bit);
          }};
}
/// A flip in a number of the context.
Flip inContext(Check check, uint32_t GliderContext::* number, unsigned bit) {
  return {check, [=](CheckBench& b) { flip(b.context().*number, bit); }};
}
/// A flip that a case's block, or a callback of the mission, makes within a tick.
Flip within(Check check, std::function<void(CheckBench&)> damage) {
  return {check, std::move(damage)};
}
template <typename Member>
Flip inInstruction(Check check, hooks::Instruction Control::* (*of)(), Member member) {
  return {check, [=](CheckBench& b) { flip(b.control().*of().*member, 7); }};
}

/// Sets a member of the memory of thermotrackyo, by its place.
Flip inTrack(Check check, uint32_t place) {
  return {check, [place](CheckBench& b) { flip(b.context().memory[1].bytes[place], 4); },
          [](CheckBench& b) { b.tracks = true; }};
}

hooks::Instruction Control::* instructed() {
  return memberOf(ControlInstructed{});
}
hooks::Instruction Control::* accepted() {
  return memberOf(ControlAccepted{});
}

/// In the addresses of the context.
std::vector<Flip> ofPointers() {
  std::vector<Flip> all;
  for (uint32_t i = 0; i < 9; ++i) {
    all.push_back(pointer(i, 3 + i % 5));
  }
  return all;
}

/// In the numbers of the context.
std::vector<Flip> ofContext() {
  return {inContext(Check::CurrentState, &GliderContext::state, 31),
          inContext(Check::CurrentState, &GliderContext::state, 1),
          inContext(Check::StackDepth, &GliderContext::stack_depth, 1),
          inContext(Check::CaseLimit, &GliderContext::limit, 5),
          inContext(Check::FinishedFlag, &GliderContext::finished, 1),
          inContext(Check::ReturnedFlag, &GliderContext::just_returned, 9),
          inContext(Check::VerticalCommand, &GliderContext::vertical, 3),
          inContext(Check::LateralCommand, &GliderContext::lateral, 2),
          {Check::StackState, [](CheckBench& b) { flip(b.context().frames[0].state, 8); }},
          {Check::StackLimit, [](CheckBench& b) { flip(b.context().frames[0].limit, 8); }},
          {Check::MissionPointer, [](CheckBench& b) { flip(b.context().mission, 4); }},
          {Check::ContextPointer,
           [](CheckBench& b) { flip(b.runtime_->*memberOf(RuntimeContext{}), 4); }}};
}

/// Within a tick: cases, transitions, the call stack.
std::vector<Flip> ofTransitions() {
  return {within(Check::AlwaysCase,
                 [](CheckBench& b) {
                   b.mission_.always_guards = [](const GliderContext&, uint32_t) { return 16U; };
                 }),
          within(Check::StateCase, [](CheckBench& b) { b.guard_answer = 16; }),
          within(Check::TransitionTarget,
                 [](CheckBench& b) {
                   b.back_ = {kGliderGoto, 16};
                   b.back_at = 0;
                 }),
          within(Check::TransitionKind,
                 [](CheckBench& b) {
                   flip(b.back_.transition, 5);
                   b.back_at = 0;
                 }),
          within(Check::TransitionDepth,
                 [](CheckBench& b) {
                   b.back_at = 0;
                   b.mission_.act = [](GliderContext& c, uint32_t, uint32_t) {
                     flip(c.stack_depth, 8);
                   };
                 }),
          within(Check::ReturnState,
                 [](CheckBench& b) {
                   b.back_at = 0;
                   b.mission_.act = [](GliderContext& c, uint32_t, uint32_t) {
                     flip(c.frames[0].state, 4);
                   };
                 }),
          within(Check::InterruptDepth, [](CheckBench& b) {
            b.mission_.always_guards = [](const GliderContext& c, uint32_t) {
              flip(const_cast<GliderContext&>(c).stack_depth, 2);
              return 0U;
            };
          })};
}

/// Within a tick: notes, guard tables, behaviours.
std::vector<Flip> ofTables() {
  return {
      within(Check::NoteRoom,
             [](CheckBench& b) {
               b.mission_.route = [](GliderContext& c) {
                 flip(c.note_count, 5);
                 gliderNote(&c, kGliderNoteLog, "more", nullptr, 0);
                 c.note_count = 0;
                 return GLIDER_NO_CASE;
               };
             }),
      within(Check::NoteValueRoom,
             [](CheckBench& b) {
               b.mission_.route = [](GliderContext& c) {
                 flip(c.note_value_count, 7);
                 gliderNote(&c, kGliderNoteLog, "more", &c.depth, 1);
                 return GLIDER_NO_CASE;
               };
             }),
      within(Check::GuardMemory, [](CheckBench& b) { flip(b.table.memory, 6); }),
      within(Check::GuardInterval, [](CheckBench& b) { flip(b.context().intervals[1], 5); }),
      within(Check::ValueSensor, [](CheckBench& b) { flip(b.column_.sensor, 6); }),
      within(Check::YoDirection, [](CheckBench& b) { flip(b.context().memory[0].bytes[0], 3); }),
      inTrack(Check::TrackDirection, 40),
      inTrack(Check::TrackSide, 48),
      inTrack(Check::TrackSide, 52),
      inTrack(Check::TrackSide, 56),
      inTrack(Check::TrackSide, 60)};
}

/// In the link to the vehicle.
std::vector<Flip> ofLink() {
  return {{Check::SendQueue,
           [](CheckBench& b) {
             flip((b.client().*memberOf(ClientQueue{}).*memberOf(QueueState{})).end, 30);
           }},
          {Check::ReceivedBytes,
           [](CheckBench& b) {
             flip((b.client().*memberOf(ClientReader{}).*memberOf(ReaderState{})).count, 11);
           }},
          {Check::Subscription,
           [](CheckBench& b) { flip((b.client().*memberOf(ClientSubscription{})).count, 7); }},
          {Check::TickReadings,
           [](CheckBench& b) { flip((b.client().*memberOf(ClientTick{})).reading_count, 7); }},
          {Check::Notices, [](CheckBench& b) { flip(b.client().*memberOf(ClientNotices{}), 16); }},
          {Check::Notes, [](CheckBench& b) { flip(b.client().*memberOf(ClientNotes{}), 4); }},
          {Check::WaitingControl,
           [](CheckBench& b) { flip((b.client().*memberOf(ClientPending{})).control, 3); }},
          {Check::WaitingVertical,
           [](CheckBench& b) { flip((b.client().*memberOf(ClientPending{})).vertical, 3); }},
          {Check::WaitingLateral,
           [](CheckBench& b) { flip((b.client().*memberOf(ClientPending{})).lateral, 2); }}};
}

/// In the bookkeeping of control, and in the log.
std::vector<Flip> ofControl() {
  return {{Check::HookState, [](CheckBench& b) { flip(b.control().*memberOf(ControlState{}), 4); }},
          {Check::PendingControl,
           [](CheckBench& b) { flip(b.control().*memberOf(ControlPending{}), 2); }},
          {Check::ConfirmTicks,
           [](CheckBench& b) { flip(b.control().*memberOf(ControlUnconfirmed{}), 24); }},
          {Check::ReleaseTicks,
           [](CheckBench& b) { flip(b.control().*memberOf(ControlReleasing{}), 5); }},
          inInstruction(Check::LastControl, instructed, &hooks::Instruction::control),
          inInstruction(Check::LastVertical, instructed, &hooks::Instruction::vertical),
          inInstruction(Check::LastLateral, instructed, &hooks::Instruction::lateral),
          inInstruction(Check::AcceptedControl, accepted, &hooks::Instruction::control),
          inInstruction(Check::AcceptedVertical, accepted, &hooks::Instruction::vertical),
          inInstruction(Check::AcceptedLateral, accepted, &hooks::Instruction::lateral),
          {Check::LogBytes, [](CheckBench& b) { flip(b.log().*memberOf(LogSize{}), 15); }}};
}

std::vector<Flip> flips() {
  std::vector<Flip> all;
  for (auto* of : {ofPointers, ofContext, ofTransitions, ofTables, ofLink, ofControl}) {
    std::ranges::move(of(), std::back_inserter(all));
  }
  return all;
}

class EachCheck : public CheckBench, public ::testing::WithParamInterface<Flip> {};

TEST_P(EachCheck, FailsByAFlippedBitAndEndsControl) {
  if (GetParam().before) {
    GetParam().before(*this);
  }
  boot();
  vehicle.run(60);
  ASSERT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  ASSERT_EQ(context().stack_depth, 1U) << "in `second`";
  ASSERT_EQ(records(), 0U) << logCsv();
  GetParam().damage(*this);
  vehicle.run(64.5);
  expectSilence(GetParam().check);
}

INSTANTIATE_TEST_SUITE_P(Checks, EachCheck, ::testing::ValuesIn(flips()));

TEST(Checks, EachOneIsTried) {
  std::set<uint32_t> tried;
  for (const Flip& one : flips()) {
    tried.insert(static_cast<uint32_t>(one.check));
  }
  const std::set<Check> of_missions_in_c = {Check::KeptPieces, Check::EventCount};
  for (uint32_t number = 0; number <= UINT8_MAX; ++number) {
    const bool elsewhere = of_missions_in_c.contains(static_cast<Check>(number));
    EXPECT_EQ(tried.contains(number), checkText(number) != nullptr && !elsewhere) << number;
  }
}

/// The program ends, and the board starts it again, or loses its power.
TEST_F(CheckBench, ARestartedProgramLeavesControlToTheVehicle) {
  boot();
  vehicle.run(60);
  flip(context().state, 20);
  vehicle.run(62);
  ASSERT_EQ(status_, kGliderRuntimeFailed);
  boot();
  vehicle.run(200);
  EXPECT_EQ(status_, kGliderRuntimeFinished);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Silent);
  EXPECT_EQ(gliderRuntimeFailedCheck(runtime_), 0U);
  EXPECT_THAT(logCsv(), HasSubstr(",control left to the vehicle,"));
  EXPECT_THAT(logCsv(), HasSubstr(",an internal check had failed,"));
  EXPECT_EQ(records(), 1U);
}

TEST_F(CheckBench, ARestartedProgramLeavesARestartedVehicleAlone) {
  vehicle.clock_at_start = 1e9;
  boot();
  vehicle.run(60);
  flip(context().state, 20);
  vehicle.run(62);
  ASSERT_EQ(status_, kGliderRuntimeFailed);
  vehicle.restartMission();
  boot();
  vehicle.run(200);
  EXPECT_EQ(status_, kGliderRuntimeFinished);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Ready);
  EXPECT_THAT(logCsv(), HasSubstr(",an internal check had failed,"));
}

TEST_F(CheckBench, ALaterFlightBeginsAgain) {
  vehicle.clock_at_start = 1e9;
  vehicle.depth = [](double) { return 0.0; };
  boot();
  vehicle.run(60);
  flip(context().state, 20);
  vehicle.run(62);
  ASSERT_EQ(status_, kGliderRuntimeFailed);
  vehicle.clock_at_start += 13 * 3600;
  vehicle.restartMission();
  boot();
  vehicle.run(200);
  EXPECT_EQ(vehicle.hookbeh().state, hooks::HookState::Active);
  EXPECT_THAT(logCsv(), HasSubstr("the checkpoint is of an earlier flight"));
}

}  // namespace
}  // namespace glider::runtime::testing
