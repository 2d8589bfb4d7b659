// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The process that writes for the mission: what is on the card when it says so, and that a card
// which stands still costs a bounded wait and nothing else.

#include "runtime/board/card.h"

#include "runtime/board/checkpoints.h"
#include "runtime/board/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <signal.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace glider::runtime::testing {
namespace {

/// A card in memory that both processes see through pipes: what is written comes out of one, and a
/// write waits for a byte in the other while it is told to.
struct Gate {
  int taken[2];  ///< what was written, byte by byte
  int open[2];   ///< a write with the first byte 'S' waits for a byte here

  Gate() { EXPECT_TRUE(pipe(taken) == 0 && pipe(open) == 0); }
  Gate(const Gate&) = delete;
  Gate& operator=(const Gate&) = delete;
  ~Gate() {
    for (const int end : {taken[0], taken[1], open[0], open[1]}) {
      close(end);
    }
  }
  static int32_t write(Gate& gate, const uint8_t* bytes, uint32_t count) {
    uint8_t byte = 0;
    if (count > 0 && bytes[0] == 'S' && read(gate.open[0], &byte, 1) != 1) {
      return -1;
    }
    return static_cast<int32_t>(::write(gate.taken[1], bytes, count));
  }
  void letGo() const { EXPECT_EQ(::write(open[1], "x", 1), 1); }
  /// The next `count` bytes that came to the card; waits for them.
  [[nodiscard]] std::string next(size_t count) const {
    std::string got(count, ' ');
    EXPECT_EQ(read(taken[0], got.data(), count), static_cast<ssize_t>(count));
    return got;
  }
  CardWork work() {
    CardWork work;
    work.log = {this,
                [](void* self, const uint8_t* bytes, uint32_t count) {
                  return write(*static_cast<Gate*>(self), bytes, count);
                },
                [](void*) { return 0; }, [](void*) { return 0; }};
    return work;
  }
};

int32_t say(const GliderLogSink& log, const std::string& words) {
  return log.write(log.self, reinterpret_cast<const uint8_t*>(words.data()),
                   static_cast<uint32_t>(words.size()));
}

double secondsOf(const std::function<void()>& what) {
  const auto began = std::chrono::steady_clock::now();
  what();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

TEST(CardTest, WhatItHasTakenIsOnTheCard) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0));
  const GliderLogSink log = card.log();
  EXPECT_EQ(say(log, "abc"), 3);
  fcntl(gate.taken[0], F_SETFL, O_NONBLOCK);
  EXPECT_EQ(gate.next(3), "abc") << "it is there when the call returns, not later";
  EXPECT_EQ(log.sync(log.self), 0);
  EXPECT_EQ(log.renew(log.self), 0);
}

TEST(CardTest, OneThatStandsStillCostsABoundedWaitOnce) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 0.05, 0));
  const GliderLogSink log = card.log();
  const double first = secondsOf([&] { EXPECT_LT(say(log, "S1"), 0); });
  EXPECT_GE(first, 0.04);
  card.rested(false);
  EXPECT_LT(say(log, "b"), 0) << "nothing is asked of a card that has not done what it was asked";
  EXPECT_LT(log.sync(log.self), 0);
  EXPECT_EQ(log.renew(log.self), 0) << "no new log has begun";
  gate.letGo();
  EXPECT_EQ(gate.next(2), "S1") << "what was given up is written all the same";
  int32_t taken = -1;
  for (int tries = 0; tries < 500 && taken < 0; ++tries) {
    card.rested(false);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    taken = say(log, "c");
  }
  EXPECT_EQ(taken, 1) << "a card that moves again is written again";
  EXPECT_EQ(gate.next(1), "c");
}

TEST(CardTest, PatienceIsForAllThatATickAsks) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 0, 0));
  const GliderLogSink log = card.log();
  EXPECT_LT(say(log, "S1"), 0);
  gate.letGo();
  EXPECT_EQ(gate.next(2), "S1");
  card.rested(true);
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    gate.letGo();
  });
  EXPECT_EQ(say(log, "S2"), 2) << "in virtual time the vehicle waits, and so does the SBC";
  later.join();
}

TEST(CardTest, OneThatHasStoodStillIsLeftAloneForAWhile) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 0.02, 1000));
  const GliderLogSink log = card.log();
  EXPECT_LT(say(log, "S1"), 0);
  gate.letGo();
  EXPECT_EQ(gate.next(2), "S1");
  for (int tries = 0; tries < 20; ++tries) {
    card.rested(false);
    EXPECT_LT(say(log, "b"), 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

/// The processes that this one has started.
std::vector<pid_t> children() {
  const std::string me = std::to_string(getpid());
  std::ifstream list("/proc/" + me + "/task/" + me + "/children");
  return {std::istream_iterator<pid_t>(list), {}};
}

void killChildrenBut(const std::vector<pid_t>& these) {
  for (const pid_t child : children()) {
    if (std::ranges::find(these, child) == these.end()) {
      kill(child, SIGKILL);
    }
  }
}

TEST(CardTest, AProcessThatEndsIsStartedAnewAfterARest) {
  signal(SIGPIPE, SIG_IGN);
  Gate gate;
  const std::vector<pid_t> before = children();
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 5, 0.05));
  const GliderLogSink log = card.log();
  EXPECT_EQ(say(log, "a"), 1);
  killChildrenBut(before);
  EXPECT_LT(say(log, "b"), 0) << "what was asked of it is lost";
  card.rested(false);
  EXPECT_LT(say(log, "c"), 0) << "not at once";
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  card.rested(false);
  EXPECT_EQ(say(log, "d"), 1);
  EXPECT_EQ(gate.next(2), "ad");
}

/// A file of checkpoints, and its path.
class Store : public ::testing::Test {
 protected:
  Store() {
    char name[] = "/tmp/glider-card-XXXXXX";
    close(mkstemp(name));
    path_ = name;
  }
  ~Store() override { unlink(path_.c_str()); }
  std::string path_;
};

TEST_F(Store, CheckpointsAreReadAndWrittenThere) {
  Card card;
  ASSERT_TRUE(card.start({{}, openCheckpoints(path_.c_str(), 0), holdCheckpoints}, 100));
  const GliderStore store = card.checkpoints();
  const std::string words = "checkpoint";
  EXPECT_EQ(store.write(store.self, 7, reinterpret_cast<const uint8_t*>(words.data()), 10), 10);
  EXPECT_EQ(store.sync(store.self), 0);
  uint8_t back[20] = {};
  EXPECT_EQ(store.read(store.self, 7, back, 20), 20)
      << "the file has its whole size from the start";
  EXPECT_EQ(std::string(back, back + 10), words);
  EXPECT_EQ(std::string(back + 10, back + 20), std::string(10, '\0'));
  EXPECT_LT(store.write(store.self, 0, back, 5000), 0) << "more than was said";
}

TEST_F(Store, AProcessThatIsStartedAnewWritesTheNewestLog) {
  signal(SIGPIPE, SIG_IGN);
  const std::vector<pid_t> before = children();
  Card card;
  ASSERT_TRUE(card.start({openLog(path_.c_str(), 5), {}, nullptr, reopenLog}, 0, 5, 0));
  const GliderLogSink log = card.log();
  EXPECT_EQ(say(log, "older."), 6);
  EXPECT_EQ(log.renew(log.self), 1);
  killChildrenBut(before);
  EXPECT_LT(say(log, "lost"), 0);
  card.rested(false);
  EXPECT_EQ(say(log, "new"), 3);
  std::string content;
  std::ifstream(path_) >> content;
  EXPECT_EQ(content, "new");
  unlink((path_ + ".old").c_str());
}

TEST_F(Store, AProgramWaitsForTheProcessOfTheOneBefore) {
  const GliderStore file = openCheckpoints(path_.c_str(), 0);
  int held[2];
  ASSERT_EQ(pipe(held), 0);
  const pid_t before = fork();
  if (before == 0) {
    holdCheckpoints(file);
    (void)!write(held[1], "x", 1);
    usleep(100000);
    (void)file.write(file.self, 0, reinterpret_cast<const uint8_t*>("last"), 4);
    _exit(0);
  }
  char byte = 0;
  ASSERT_EQ(read(held[0], &byte, 1), 1);
  Card card;
  ASSERT_TRUE(card.start({{}, file, holdCheckpoints}, 100, 0.08));
  const GliderStore store = card.checkpoints();
  uint8_t back[4] = {};
  EXPECT_EQ(store.read(store.self, 0, back, 4), 4) << "it has read before the other was done";
  EXPECT_EQ(std::string(back, back + 4), "last");
  waitpid(before, nullptr, 0);
  // Waiting for it costs the first tick none of its patience.
  EXPECT_EQ(store.write(store.self, 0, back, 4), 4);
}

}  // namespace
}  // namespace glider::runtime::testing
