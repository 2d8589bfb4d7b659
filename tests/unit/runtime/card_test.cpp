// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The process that writes for the mission: what it confirms is on the storage card, and a card that
// stops responding costs a bounded wait and nothing else.

#include "runtime/board/card.h"

#include "runtime/board/checkpoints.h"
#include "runtime/board/files.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <errno.h>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <iterator>
#include <signal.h>
#include <string>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

namespace glider::runtime::testing {
namespace {

/// A card in memory that both processes see through pipes: what is written comes out of one, and a
/// write waits for a byte in the other if the test requests that.
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
    const auto put = static_cast<int32_t>(::write(gate.taken[1], bytes, count));
    errno = EINTR;  // an errno of before says nothing of what comes after
    return put;
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

/// What `ask` returns once the card is free again, in virtual time or not; -1 if it never is.
int32_t onceFree(Card& card, bool virtual_time, const std::function<int32_t()>& ask) {
  int32_t answer = -1;
  for (int tries = 0; tries < 500 && answer < 0; ++tries) {
    card.rested(virtual_time);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    answer = ask();
  }
  return answer;
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

/// What the other process says it has read does not decide how much is copied.
TEST(CardTest, MoreReadThanWasAskedForIsNothingRead) {
  for (const auto& [says, gets] : {std::pair{4, 4}, {3, 3}, {0, 0}, {5, -1}, {1 << 20, -1}}) {
    static int32_t answer;
    answer = says;
    CardWork work;
    work.checkpoints = {nullptr, [](void*, uint32_t, uint8_t*, uint32_t) { return answer; },
                        [](void*, uint32_t, const uint8_t*, uint32_t) { return 0; },
                        [](void*) { return 0; }};
    Card card;
    ASSERT_TRUE(card.start(work, 4));
    const GliderStore store = card.checkpoints();
    std::array<uint8_t, 8> bytes;
    bytes.fill(0xAA);
    EXPECT_EQ(store.read(store.self, 0, bytes.data(), 4), gets);
    EXPECT_TRUE(std::all_of(bytes.begin() + 4, bytes.end(), [](uint8_t b) { return b == 0xAA; }));
  }
}

TEST(CardTest, OneThatStopsRespondingCostsABoundedWaitOnce) {
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
  EXPECT_EQ(gate.next(2), "S1") << "what was given up is still written";
  EXPECT_EQ(onceFree(card, false, [&] { return say(log, "c"); }), 1)
      << "a card that moves again is written again";
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
  std::thread later([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(1200));
    gate.letGo();
  });
  EXPECT_EQ(onceFree(card, true, [&] { return say(log, "S2"); }), 2)
      << "in virtual time the vehicle waits, and so does the SBC";
  later.join();
}

TEST(CardTest, OneThatStoppedRespondingIsLeftAloneForAWhile) {
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

/// A rest, s, that a slow machine (or valgrind) does not sleep through between two statements.
constexpr double kRest = 0.4;
constexpr std::chrono::milliseconds kAfterRest{450};

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

TEST(CardTest, AProcessThatEndsIsRestartedAfterAPause) {
  signal(SIGPIPE, SIG_IGN);
  Gate gate;
  const std::vector<pid_t> before = children();
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 5, kRest));
  const GliderLogSink log = card.log();
  EXPECT_EQ(say(log, "a"), 1);
  killChildrenBut(before);
  EXPECT_LT(say(log, "b"), 0) << "what was asked of it is lost";
  card.rested(false);
  EXPECT_LT(say(log, "c"), 0) << "not at once";
  std::this_thread::sleep_for(kAfterRest);
  card.rested(false);
  EXPECT_EQ(say(log, "d"), 1);
  EXPECT_EQ(gate.next(2), "ad");
}

TEST(CardTest, AnErrnoOfBeforeSaysNothing) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0));
  const GliderLogSink log = card.log();
  for (int i = 0; i < 3; ++i) {
    errno = EINTR;
    EXPECT_EQ(say(log, "a"), 1);
  }
  EXPECT_EQ(gate.next(3), "aaa");
}

/// A signal every 2 ms, which interrupts what waits.
struct Interruptions {
  Interruptions() {
    struct sigaction action{};
    action.sa_handler = [](int) { count = count + 1; };
    sigaction(SIGALRM, &action, nullptr);
    const itimerval often{{0, 2000}, {0, 2000}};
    setitimer(ITIMER_REAL, &often, nullptr);
  }
  Interruptions(const Interruptions&) = delete;
  Interruptions& operator=(const Interruptions&) = delete;
  ~Interruptions() {
    const itimerval never{};
    setitimer(ITIMER_REAL, &never, nullptr);
    signal(SIGALRM, SIG_IGN);  // not the default: one may be on its way, and would end the process
  }
  static inline volatile sig_atomic_t count = 0;
};

TEST(CardTest, ASignalNeitherEndsAWaitNorMakesItLonger) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 0.1, 0));
  const GliderLogSink log = card.log();
  std::this_thread::sleep_for(std::chrono::milliseconds(150));  // so that its clock is not 0
  const Interruptions interruptions;
  const double waited = secondsOf([&] { EXPECT_LT(say(log, "S1"), 0); });
  EXPECT_GE(waited, 0.09);
  EXPECT_LT(waited, 2);
  EXPECT_GT(Interruptions::count, 10);
  gate.letGo();  // its process would hang for ever
}

TEST(CardTest, AfterASignalOnlyTheRestIsWaited) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 1, 0));
  const GliderLogSink log = card.log();
  struct sigaction nothing{};
  nothing.sa_handler = [](int) {};
  sigaction(SIGALRM, &nothing, nullptr);
  const itimerval once{{0, 0}, {0, 950000}};
  setitimer(ITIMER_REAL, &once, nullptr);
  const double waited = secondsOf([&] { EXPECT_LT(say(log, "S1"), 0); });
  signal(SIGALRM, SIG_IGN);
  EXPECT_GE(waited, 0.99);
  EXPECT_LT(waited, 1.8) << "not all of it again";
  gate.letGo();
}

TEST(CardTest, ALogThatWasRenewedLateIsReportedOnce) {
  Gate gate;
  CardWork work = gate.work();
  work.log.renew = [](void* self) {
    static int times = 0;
    uint8_t byte = 0;
    return ++times == 1 && read(static_cast<Gate*>(self)->open[0], &byte, 1) == 1 ? 1 : 0;
  };
  Card card;
  ASSERT_TRUE(card.start(work, 0, 0.05, 0));
  const GliderLogSink log = card.log();
  EXPECT_EQ(log.renew(log.self), 0) << "nothing waits any more";
  gate.letGo();
  EXPECT_EQ(onceFree(card, false, [&] { return log.renew(log.self) == 1 ? 1 : -1; }), 1);
  for (int tries = 0; tries < 20; ++tries) {
    card.rested(false);
    EXPECT_EQ(log.renew(log.self), 0) << "once";
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

TEST(CardTest, AByteThatWasWrittenLateIsNotANewLog) {
  Gate gate;
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 0.05, 0));
  const GliderLogSink log = card.log();
  EXPECT_LT(say(log, "S"), 0);
  gate.letGo();
  EXPECT_EQ(gate.next(1), "S");
  for (int tries = 0; tries < 20; ++tries) {
    card.rested(false);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    EXPECT_EQ(log.renew(log.self), 0);
  }
}

TEST(CardTest, ACardOffersOnlyTheOperationsOfItsFiles) {
  Gate gate;
  CardWork work = gate.work();
  work.log.sync = nullptr;
  work.log.renew = nullptr;
  Card card;
  ASSERT_TRUE(card.start(work, 0));
  EXPECT_EQ(card.log().sync, nullptr);
  EXPECT_EQ(card.log().renew, nullptr);
  EXPECT_EQ(card.checkpoints().write, nullptr);
  Card none;
  EXPECT_FALSE(none.start({}, 100)) << "there is nothing to write";
  EXPECT_EQ(none.log().write, nullptr);
}

/// How many files this process has open, of the first 256.
int openFiles() {
  int count = 0;
  for (int descriptor = 0; descriptor < 256; ++descriptor) {
    count += fcntl(descriptor, F_GETFD) >= 0 ? 1 : 0;
  }
  return count;
}

/// Does `what` in a process of its own, and fails as it does.
void alone(const std::function<void()>& what) {
  const pid_t child = fork();
  if (child == 0) {
    what();
    _exit(::testing::Test::HasFailure() ? 1 : 0);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
}

/// From now on this process may open `more` files.
void allowFiles(uint32_t more) {
  int next = 0;
  std::vector<int> filled;
  while ((next = dup(STDERR_FILENO)) <= 64) {  // no gaps below the limit
    filled.push_back(next);
  }
  close(next);
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = static_cast<rlim_t>(next) + more;
  setrlimit(RLIMIT_NOFILE, &limit);
}

TEST(CardTest, WithoutPipesTheMissionWritesItself) {
  for (const uint32_t more : {0U, 1U, 2U, 3U, 4U}) {
    alone([&] {
      Gate gate;
      allowFiles(more);
      const int before = openFiles();
      Card card;
      EXPECT_EQ(card.start(gate.work(), 0), more == 4) << more;
      EXPECT_EQ(openFiles(), before + (more == 4 ? 2 : 0)) << more;
      EXPECT_EQ(say(card.log(), "abc"), 3);
      EXPECT_EQ(gate.next(3), "abc");
    });
  }
}

TEST(CardTest, AProcessThatCannotBeRestartedIsTriedAgain) {
  alone([] {
    signal(SIGPIPE, SIG_IGN);
    Gate gate;
    Card card;
    ASSERT_TRUE(card.start(gate.work(), 0, 5, kRest));
    const GliderLogSink log = card.log();
    EXPECT_EQ(say(log, "a"), 1);
    const int before = openFiles();
    killChildrenBut({});
    EXPECT_LT(say(log, "b"), 0);
    EXPECT_EQ(openFiles(), before - 2) << "both its pipes are closed";
    const int fillers[2] = {dup(STDERR_FILENO), dup(STDERR_FILENO)};
    allowFiles(0);
    std::this_thread::sleep_for(kAfterRest);
    card.rested(false);
    EXPECT_LT(say(log, "c"), 0);
    close(fillers[0]);
    close(fillers[1]);
    rlimit limit{};
    getrlimit(RLIMIT_NOFILE, &limit);
    limit.rlim_cur += 4;
    setrlimit(RLIMIT_NOFILE, &limit);
    card.rested(false);
    EXPECT_LT(say(log, "d"), 0) << "it rests again";
    std::this_thread::sleep_for(kAfterRest);
    card.rested(false);
    EXPECT_EQ(say(log, "e"), 1);
    EXPECT_EQ(gate.next(2), "ae");
  });
}

TEST(CardTest, WithoutAProcessTheMissionWritesItself) {
  alone([] {
    Gate gate;
    constexpr uid_t kNobody = 65534;
    if (getuid() == 0) {  // whom no limit holds
      ASSERT_EQ(setuid(kNobody), 0);
    }
    const rlimit none{};
    ASSERT_EQ(setrlimit(RLIMIT_NPROC, &none), 0);
    const int before = openFiles();
    Card card;
    EXPECT_FALSE(card.start(gate.work(), 0));
    EXPECT_EQ(openFiles(), before);
    EXPECT_EQ(say(card.log(), "abc"), 3);
    EXPECT_EQ(gate.next(3), "abc");
  });
}

TEST(CardTest, ItsProcessHoldsNothingOfTheMissions) {
  signal(SIGPIPE, SIG_IGN);
  Gate gate;
  const std::vector<pid_t> before = children();
  Card card;
  ASSERT_TRUE(card.start(gate.work(), 0, 5, 0));
  const GliderLogSink log = card.log();
  int line[2];
  ASSERT_EQ(pipe(line), 0);
  card.setLine(line[1]);
  EXPECT_EQ(say(log, "a"), 1);
  const std::vector<pid_t> earlier = children();
  killChildrenBut(before);
  EXPECT_LT(say(log, "b"), 0);
  card.rested(false);
  EXPECT_EQ(say(log, "c"), 1);
  close(line[1]);
  fcntl(line[0], F_SETFL, O_NONBLOCK);
  char byte = 0;
  EXPECT_EQ(read(line[0], &byte, 1), 0) << "no other process has the line open";
  close(line[0]);
  for (const pid_t child : children()) {
    if (std::ranges::find(earlier, child) == earlier.end()) {
      const std::string files = "/proc/" + std::to_string(child) + "/fd/";
      EXPECT_NE(access((files + "0").c_str(), F_OK), 0);
      EXPECT_NE(access((files + "1").c_str(), F_OK), 0);
      EXPECT_EQ(access((files + "2").c_str(), F_OK), 0);
      kill(child, SIGINT);
    }
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(say(log, "d"), 1) << "a key at the terminal does not end it";
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
  EXPECT_LT(store.read(store.self, 0, back, 5000), 0);
}

TEST_F(Store, AProcessThatHasEndedReadsNothing) {
  signal(SIGPIPE, SIG_IGN);
  const std::vector<pid_t> before = children();
  Card card;
  ASSERT_TRUE(card.start({{}, openCheckpoints(path_.c_str(), 0), holdCheckpoints}, 100));
  const GliderStore store = card.checkpoints();
  uint8_t back[1] = {};
  ASSERT_EQ(store.read(store.self, 0, back, 1), 1);
  killChildrenBut(before);
  EXPECT_LT(store.read(store.self, 0, back, 1), 0);
}

TEST_F(Store, OnlyARestartedProcessOpensTheLogAgain) {
  signal(SIGPIPE, SIG_IGN);
  const std::vector<pid_t> before = children();
  Card card;
  ASSERT_TRUE(card.start({openLog(path_.c_str(), 1000), {}, nullptr, reopenLog}, 0, 5, 0));
  unlink(path_.c_str());
  EXPECT_EQ(say(card.log(), "into the open file"), 18);
  EXPECT_NE(access(path_.c_str(), F_OK), 0);
}

TEST_F(Store, ARestartedProcessWritesTheNewestLog) {
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
    usleep(600000);
    (void)file.write(file.self, 0, reinterpret_cast<const uint8_t*>("last"), 4);
    _exit(0);
  }
  char byte = 0;
  ASSERT_EQ(read(held[0], &byte, 1), 1);
  Card card;
  ASSERT_TRUE(card.start({{}, file, holdCheckpoints}, 100, 0.4));
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
