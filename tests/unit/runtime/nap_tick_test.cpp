// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// After which ticks the SBC orders a sleep, and for how long.

#include "runtime/core/nap_tick.h"

#include "hooks/protocol/nap_times.h"
#include "tests/unit/hooks/client_bench.h"
#include "tests/unit/runtime/log_csv.h"

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

extern "C" void gliderNapAfterTick(void* memory, const void* tick);

namespace glider::runtime {
namespace {

/// What the mission's code says of the next ticks.
struct Said {
  double until_s = std::numeric_limits<double>::quiet_NaN();
  bool awake = false;
} said;

void foreseeSaid(GliderContext* /*context*/, GliderNap* nap) {
  gliderNapUntil(nap, said.until_s);
  nap->awake = said.awake ? 1 : 0;
}

int32_t keepBytes(void* self, const uint8_t* bytes, uint32_t count) {
  static_cast<std::string*>(self)->append(reinterpret_cast<const char*>(bytes), count);
  return static_cast<int32_t>(count);
}

class NapTicks : public hooks::ClientTest {
 protected:
  NapTicks() {
    said = {};
    hooks::ClientOptions naps = options();
    naps.features.needs = hooks::kFeatureNaps;
    client_ = hooks::Client(gliderDictionary, naps);
    say(hooks::Beacon{hooks::kProtocolVersion,
                      {.offers = hooks::kFeatureNaps, .needs = 0},
                      gliderDictionary.hash,
                      hooks::HookState::Ready});
    (void)poll();
    hooks::Hello hello;
    EXPECT_TRUE(hooks::decode(answers().at(0), hello));
    head_.link = hello.link;
    head_.subscription = hooks::subscriptionCheck(subscription());
    state_.name = "fly";
    state_.foresee = foreseeSaid;
    naps_ = {240, 0, GLIDER_NO_SENSOR, 10, 2, 0, gliderNapAfterTick};
    mission_.name = "m";
    mission_.state_count = 1;
    mission_.states = states_;
    mission_.naps = &naps_;
    mission_.dictionary = &gliderDictionary;
    context_.mission = &mission_;
    context_.variables = variables_;
    context_.moved_list = GLIDER_NO_LIST;
    tick_.readings[0] = {GLIDER_X_HOOK_NAP_SECS, 280};
    tick_.reading_count = 1;
  }

  /// A tick whose answer is sent, with the nap in it, if there is one.
  std::optional<hooks::Nap> afterTick(bool commands = false, bool settled = true) {
    ++head_.cycle;
    sayTick();
    EXPECT_EQ(poll(), hooks::ClientEvent::Tick);
    context_.mission_time += 4;
    const NapTick now{context_, tick_, client_, link_log_, commands, settled};
    gliderNapAfterTick(&memory_, &now);
    client_.done({}, sbc_);
    hooks::Nap nap;
    for (const hooks::Frame& frame : answers()) {
      if (frame.type == hooks::MessageType::Nap) {
        EXPECT_TRUE(hooks::decode(frame, subscription(), nap));
        EXPECT_TRUE(memory_.asleep);
        return nap;
      }
    }
    EXPECT_FALSE(memory_.asleep);
    return std::nullopt;
  }
  /// After a tick that changes nothing.
  void rest() { (void)afterTick(); }

  std::vector<std::string> late() {
    log_.flush();
    return testing::eventsIn(testing::csvOf(bytes_), "woken late");
  }

  GliderStateInfo state_{};
  const GliderStateInfo* states_[1] = {&state_};
  GliderNaps naps_{};
  GliderMission mission_{};
  GliderContext context_{};
  double variables_[3] = {1, 2, 3};
  hooks::VehicleTick tick_;
  std::string bytes_;
  MissionLog log_{{&bytes_, keepBytes, nullptr, nullptr}, mission_};
  LinkLog link_log_{log_};
  NapMemory memory_;
};

TEST_F(NapTicks, AfterTheSecondTickOfAKindForTheWholeTime) {
  EXPECT_FALSE(afterTick()) << "nothing is known of the tick before";
  const auto nap = afterTick();
  ASSERT_TRUE(nap);
  EXPECT_EQ(nap->length_s, 240);
  EXPECT_EQ(nap->wake_s, 10);
  EXPECT_EQ(nap->count, 0);
}

TEST_F(NapTicks, NotAfterATickThatChangedAVariable) {
  rest();
  variables_[1] = 5;
  EXPECT_FALSE(afterTick());
  EXPECT_TRUE(afterTick());
}

TEST_F(NapTicks, VariablesOfWhatRunsInEveryTickDoNotCount) {
  rest();
  variables_[2] = 5;
  EXPECT_TRUE(afterTick());
}

TEST_F(NapTicks, NotAfterATransitionNorAfterTheTickBehindIt) {
  rest();
  context_.moved_list = kGliderListState;
  EXPECT_FALSE(afterTick());
  context_.moved_list = GLIDER_NO_LIST;
  EXPECT_FALSE(afterTick()) << "after a return its lists are tried in another order";
  EXPECT_TRUE(afterTick());
}

TEST_F(NapTicks, NotWithAnythingElseToDo) {
  rest();
  EXPECT_FALSE(afterTick(true)) << "a command";
  EXPECT_FALSE(afterTick(false, false)) << "an instruction waits";
  context_.note_count = 1;
  EXPECT_FALSE(afterTick());
  context_.note_count = 0;
  context_.finished = 1;
  EXPECT_FALSE(afterTick());
  context_.finished = 0;
  tick_.kept = true;
  EXPECT_FALSE(afterTick()) << "newer ticks follow";
  tick_.kept = false;
  EXPECT_TRUE(afterTick());
}

TEST_F(NapTicks, NotWhereNothingCanBeForeseen) {
  rest();
  said.awake = true;
  EXPECT_FALSE(afterTick());
  said.awake = false;
  state_.foresee = nullptr;
  EXPECT_FALSE(afterTick());
}

/// It has woken and read its line by then: 15 s, and a cycle of the vehicle.
TEST_F(NapTicks, ItIsAwakeBeforeATimeAndDoesNotSleepTooShortly) {
  rest();
  for (const auto& [seconds, length] :
       {std::pair(119.0, 99), {119.5, 100}, {40.0, 20}, {259.0, 239}, {260.0, 240}, {1e9, 240}}) {
    said.until_s = seconds;
    const auto nap = afterTick();
    ASSERT_TRUE(nap) << seconds;
    EXPECT_EQ(nap->length_s, length);
  }
  for (const double seconds : {39.0, 20.0, 4.0, 0.0}) {
    said.until_s = seconds;
    EXPECT_FALSE(afterTick()) << seconds;
  }
}

TEST_F(NapTicks, HookbehsLimitCountsLessTheTimeAroundANap) {
  rest();
  tick_.readings[0].value = 100 + kHookAroundNapSecs;
  EXPECT_EQ(afterTick().value().length_s, 100);
  tick_.reading_count = 0;
  EXPECT_EQ(afterTick().value().length_s, 100) << "the newest counts";
  tick_.reading_count = 1;
  for (const double limit : {0.0, 1.0, 59.0, -1.0, 1e9, std::nan("")}) {
    tick_.readings[0].value = limit;
    EXPECT_FALSE(afterTick()) << limit;
  }
}

TEST_F(NapTicks, AHeadingFollowsTheVariation) {
  GliderCompass compass{0, GLIDER_M_DEPTH, 0, nullptr};  // any sensor that is subscribed
  mission_.compass = &compass;
  context_.variation = 0.25;
  context_.lateral = kGliderHeading;
  rest();
  const auto nap = afterTick();
  ASSERT_TRUE(nap);
  ASSERT_EQ(nap->count, 2);
  EXPECT_EQ(nap->conditions[0].kind, hooks::NapKind::AtLeast);
  EXPECT_NEAR(nap->conditions[0].value, 0.25, 1e-6);
  EXPECT_GT(nap->conditions[0].value, 0.25);
  EXPECT_EQ(nap->conditions[1].kind, hooks::NapKind::AtMost);
  EXPECT_LT(nap->conditions[1].value, 0.25);
  context_.lateral = kGliderWaypoint;
  EXPECT_EQ(afterTick().value().count, 0);
}

/// The ticks while the SBC wakes are kept too.
TEST_F(NapTicks, OnlyACommandLongBeforeTheLastKeptTickIsLate) {
  rest();
  tick_.kept = true;
  for (int kept = 0; kept < 3; ++kept) {
    (void)afterTick(kept == 0);
  }
  tick_.kept = false;
  rest();
  EXPECT_TRUE(late().empty());
  tick_.kept = true;
  for (int kept = 0; kept < 6; ++kept) {
    (void)afterTick(kept == 0);
  }
  tick_.kept = false;
  rest();
  EXPECT_EQ(late().size(), 1U);
  rest();
  EXPECT_EQ(late().size(), 1U);
}

}  // namespace
}  // namespace glider::runtime
