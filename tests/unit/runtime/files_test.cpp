// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The log's file on the board, and what a program is started with.

#include "runtime/board/files.h"

#include "runtime/board/checkpoints.h"
#include "runtime/checkpoint/checkpoint.h"

#include <gtest/gtest.h>

#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <pthread.h>
#include <signal.h>
#include <string>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace glider::runtime::testing {
namespace {

class LogFiles : public ::testing::Test {
 protected:
  LogFiles() {
    char name[] = "/tmp/glider-log-XXXXXX";
    folder_ = mkdtemp(name);
    path_ = folder_ + "/log";
  }
  ~LogFiles() override { std::filesystem::remove_all(folder_); }

  /// Ten bytes more, as a tick ends; true if a new log has begun.
  static bool write(const GliderLogSink& sink, char letter) {
    const std::string words(10, letter);
    EXPECT_EQ(sink.write(sink.self, reinterpret_cast<const uint8_t*>(words.data()), 10), 10);
    return sink.renew(sink.self) == 1;
  }
  [[nodiscard]] std::string content(const std::string& suffix = "") const {
    std::ifstream in(path_ + suffix);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::string folder_, path_;
};

TEST_F(LogFiles, AFullOneBecomesTheOlder) {
  const GliderLogSink sink = openLog(path_.c_str(), 15);
  EXPECT_FALSE(write(sink, 'a'));
  EXPECT_TRUE(write(sink, 'b'));
  EXPECT_FALSE(write(sink, 'c'));
  EXPECT_EQ(content(".old"), std::string(10, 'a') + std::string(10, 'b'));
  EXPECT_EQ(content(), std::string(10, 'c'));
}

TEST_F(LogFiles, OneThatCannotBecomeTheOlderIsKeptAsLongAsBothWouldBe) {
  std::filesystem::create_directory(path_ + ".old");
  const GliderLogSink sink = openLog(path_.c_str(), 15);
  EXPECT_FALSE(write(sink, 'a'));
  EXPECT_FALSE(write(sink, 'b'));
  EXPECT_EQ(content(), std::string(10, 'a') + std::string(10, 'b'));
  EXPECT_TRUE(write(sink, 'c')) << "twice the limit";
  EXPECT_FALSE(write(sink, 'd'));
  EXPECT_EQ(content(), std::string(10, 'd'));
}

TEST_F(LogFiles, OneThatCouldNotBeMadeIsTriedAgain) {
  const GliderLogSink sink = openLog(path_.c_str(), 5);
  std::filesystem::remove(path_);
  std::filesystem::rename(folder_, folder_ + ".away");
  const std::string words(10, 'a');
  EXPECT_EQ(sink.write(sink.self, reinterpret_cast<const uint8_t*>(words.data()), 10), 10)
      << "into the file that no longer has a name";
  EXPECT_EQ(sink.renew(sink.self), 1) << "and there is no folder for a new one";
  EXPECT_LT(sink.write(sink.self, reinterpret_cast<const uint8_t*>(words.data()), 10), 0);
  std::filesystem::rename(folder_ + ".away", folder_);
  EXPECT_EQ(sink.write(sink.self, reinterpret_cast<const uint8_t*>(words.data()), 10), 10);
  EXPECT_EQ(content(), words);
}

TEST_F(LogFiles, AWriteThatASignalInterruptsGoesOn) {
  ASSERT_EQ(mkfifo(path_.c_str(), 0600), 0);
  const int reader = open(path_.c_str(), O_RDWR);
  const GliderLogSink sink = openLog(path_.c_str(), 1000);
  std::string words;
  while (words.size() < 200000) {  // more than a pipe holds
    words += std::to_string(words.size()) + ' ';
  }
  struct sigaction nothing{};
  nothing.sa_handler = [](int) {};
  sigaction(SIGUSR1, &nothing, nullptr);
  std::string got;
  std::thread later([&, writer = pthread_self()] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    pthread_kill(writer, SIGUSR1);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    char piece[4096];
    while (got.size() < words.size()) {
      got.append(piece, static_cast<size_t>(read(reader, piece, sizeof piece)));
    }
  });
  const auto count = static_cast<int32_t>(words.size());
  EXPECT_EQ(sink.write(sink.self, reinterpret_cast<const uint8_t*>(words.data()),
                       static_cast<uint32_t>(count)),
            count);
  later.join();
  EXPECT_TRUE(got == words);
  close(reader);
  signal(SIGUSR1, SIG_DFL);
}

TEST_F(LogFiles, OneThatCannotBeOpenedFailsUntilItCan) {
  const std::string path = folder_ + "/later/log";
  const GliderLogSink sink = openLog(path.c_str(), 1000);
  const auto* word = reinterpret_cast<const uint8_t*>("word");
  EXPECT_LT(sink.write(sink.self, word, 4), 0);
  std::filesystem::create_directory(folder_ + "/later");
  EXPECT_EQ(sink.write(sink.self, word, 4), 4);
  EXPECT_EQ(std::filesystem::file_size(path), 4U);
}

TEST_F(LogFiles, CheckpointsThatCannotBeOpenedFailUntilTheyCan) {
  const std::string path = folder_ + "/later/checkpoints";
  const GliderStore store = openCheckpoints(path.c_str(), 0);
  uint8_t word[4] = {1, 2, 3, 4};
  EXPECT_LT(store.read(store.self, 0, word, 4), 0);
  EXPECT_LT(store.write(store.self, 0, word, 4), 0);
  std::filesystem::create_directory(folder_ + "/later");
  EXPECT_EQ(store.write(store.self, 0, word, 4), 4);
  EXPECT_EQ(store.sync(store.self), 0);
  EXPECT_EQ(std::filesystem::file_size(path), Checkpoint::storeBytes(0));
}

TEST_F(LogFiles, CheckpointsTakeTheirRoomOnceAndNeverGrow) {
  constexpr uint32_t kContext = 3000;
  const std::string path = folder_ + "/checkpoints";
  const GliderStore store = openCheckpoints(path.c_str(), kContext);
  holdCheckpoints(store);
  struct stat before{};
  ASSERT_EQ(stat(path.c_str(), &before), 0);
  const uint32_t whole = Checkpoint::storeBytes(kContext);
  EXPECT_EQ(static_cast<uint32_t>(before.st_size), whole);
  EXPECT_GE(before.st_blocks * 512, before.st_size) << "no holes: each slot has its own place";
  const std::vector<uint8_t> slot(Checkpoint::slotBytes(kContext), 1);
  for (uint32_t i = 0; i < Checkpoint::kSlots; ++i) {
    const uint32_t at = Checkpoint::offsetOf(i, kContext);
    EXPECT_EQ(store.write(store.self, at, slot.data(), static_cast<uint32_t>(slot.size())),
              static_cast<int32_t>(slot.size()));
    EXPECT_LE(at + slot.size(), whole);
  }
  EXPECT_EQ(store.sync(store.self), 0);
  struct stat after{};
  ASSERT_EQ(stat(path.c_str(), &after), 0);
  EXPECT_EQ(after.st_size, before.st_size);
  EXPECT_EQ(after.st_blocks, before.st_blocks);
}

TEST(StandardFiles, ThatAreClosedAreHeld) {
  const pid_t child = fork();
  if (child == 0) {
    close(0);
    close(1);
    holdStandardFiles();
    const int next = open("/dev/null", O_RDONLY);
    const bool open0 = fcntl(0, F_GETFD) >= 0;
    const bool open1 = fcntl(1, F_GETFD) >= 0;
    _exit(open0 && open1 && next > 2 ? 0 : 1);
  }
  int status = -1;
  waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
}

}  // namespace
}  // namespace glider::runtime::testing
