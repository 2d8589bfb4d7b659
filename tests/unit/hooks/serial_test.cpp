// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/descriptor.h"
#include "hooks/transport/host/pty.h"
#include "hooks/transport/host/serial_port.h"
#include "hooks/transport/termios.h"
#include "support/diagnostics/diagnostic.h"

#include <gtest/gtest.h>

#include <array>
#include <cerrno>
#include <cstdarg>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <poll.h>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <termios.h>
#include <unistd.h>

/// What `open` answers with while the test plays a device that fails; 0: nothing.
static int open_fails_with = 0;

extern "C" {
int __real_open(const char* path, int flags, ...);
int __wrap_open(const char* path, int flags, ...);
int __wrap_open(const char* path, int flags, ...) {
  if (open_fails_with != 0) {
    errno = open_fails_with;
    return -1;
  }
  va_list more;
  va_start(more, flags);
  const unsigned mode = (flags & O_CREAT) != 0 ? va_arg(more, unsigned) : 0;
  va_end(more);
  return __real_open(path, flags, mode);
}
}

namespace glider::hooks {
namespace {

/// Writes all byte values one way and reads them at the other end.
void expectEveryByteCrosses(const GliderByteStream& from, const GliderByteStream& to,
                            int to_descriptor) {
  std::array<uint8_t, 256> sent{};
  for (size_t i = 0; i < sent.size(); ++i) {
    sent[i] = static_cast<uint8_t>(i);
  }
  ASSERT_EQ(from.write(from.self, sent.data(), 256), 256);
  std::string got;
  while (got.size() < sent.size()) {
    pollfd ready{to_descriptor, POLLIN, 0};
    ASSERT_EQ(::poll(&ready, 1, 2000), 1);
    std::array<uint8_t, 64> some{};
    const int32_t count = to.read(to.self, some.data(), 64);
    ASSERT_GT(count, 0);
    got.append(reinterpret_cast<const char*>(some.data()), static_cast<size_t>(count));
  }
  EXPECT_EQ(got, std::string(reinterpret_cast<const char*>(sent.data()), sent.size()));
}

std::string codeOf(const support::Result<SerialPort>& result) {
  return result ? "opened" : support::code(result.error().id);
}

TEST(Descriptor, IsHungUpWhenItsFarEndHasGone) {
  auto pty = std::make_unique<support::Result<Pty>>(Pty::open());
  ASSERT_TRUE(*pty);
  SerialDevice device;
  ASSERT_EQ(device.open((*pty)->name().c_str(), 115200), 0);
  EXPECT_FALSE(isHungUp(device.descriptor()));
  pty.reset();
  EXPECT_TRUE(isHungUp(device.descriptor()));
  EXPECT_TRUE(isHungUp(1 << 20)) << "no descriptor at all";
}

TEST(SerialDevice, CarriesEveryByteOverAPtyBothWays) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  SerialDevice device;
  ASSERT_EQ(device.open(pty->name().c_str(), 115200), 0);
  expectEveryByteCrosses(pty->stream(), device.stream(), device.descriptor());
  expectEveryByteCrosses(device.stream(), pty->stream(), pty->descriptor());
  uint8_t byte = 0;
  EXPECT_EQ(device.stream().read(&device, &byte, 1), 0) << "nothing yet is not the end";
  EXPECT_EQ(pty->stream().read(&*pty, &byte, 1), 0);
}

TEST(SerialDevice, SetsEverySpeedThatALineHas) {
  const std::pair<uint32_t, speed_t> speeds[] = {
      {1200, B1200},   {2400, B2400},   {4800, B4800},     {9600, B9600},    {19200, B19200},
      {38400, B38400}, {57600, B57600}, {115200, B115200}, {230400, B230400}};
  for (const auto& [baud, code] : speeds) {
    auto pty = Pty::open();
    ASSERT_TRUE(pty);
    SerialDevice device;
    ASSERT_EQ(device.open(pty->name().c_str(), baud), 0) << baud;
    EXPECT_TRUE(device.isOpen());
    termios made{};
    ASSERT_EQ(::tcgetattr(device.descriptor(), &made), 0);
    EXPECT_EQ(::cfgetospeed(&made), code) << baud;
    EXPECT_EQ(::cfgetispeed(&made), code) << baud;
    EXPECT_EQ(made.c_lflag & (ICANON | ECHO | ISIG), 0U);
    EXPECT_EQ(made.c_oflag & OPOST, 0U);
    EXPECT_EQ(made.c_iflag & (IXON | IXOFF | ICRNL | INLCR | ISTRIP), 0U);
    EXPECT_EQ(made.c_cflag & CSIZE, static_cast<tcflag_t>(CS8));
    EXPECT_EQ(made.c_cflag & (PARENB | CSTOPB), 0U);
    device.close();
    EXPECT_FALSE(device.isOpen());
    EXPECT_EQ(device.descriptor(), -1);
  }
  SerialDevice device;
  auto pty = Pty::open();
  EXPECT_EQ(device.open(pty->name().c_str(), 1201), EINVAL);
  EXPECT_FALSE(device.isOpen());
}

/// Checks that the program's input or output was not closed; opens it again for the tests that
/// follow.
class KeepsOpen {
 public:
  explicit KeepsOpen(int descriptor) : descriptor_(descriptor), kept_(::dup(descriptor)) {
    EXPECT_GE(kept_, 0);
  }
  KeepsOpen(const KeepsOpen&) = delete;
  KeepsOpen& operator=(const KeepsOpen&) = delete;
  ~KeepsOpen() {
    const bool open = ::fcntl(descriptor_, F_GETFD) >= 0;
    EXPECT_EQ(::dup2(kept_, descriptor_), descriptor_);
    ::close(kept_);
    EXPECT_TRUE(open) << descriptor_;
  }

 private:
  int descriptor_;
  int kept_;
};

TEST(Pty, WhatHasMovedOrReleasedClosesNothingOfOthers) {
  const KeepsOpen input(STDIN_FILENO), output(STDOUT_FILENO);
  auto one = Pty::open();
  auto two = Pty::open();
  auto three = Pty::open();
  ASSERT_TRUE(one && two && three);
  one->releaseUserSide();
  *two = std::move(*one);
  const Pty four = std::move(*three);
}

TEST(Pty, TheSideThatWasReleasedIsNotClosedAgain) {
  int other = -1;
  {
    auto pty = Pty::open();
    ASSERT_TRUE(pty);
    pty->releaseUserSide();
    other = ::dup(STDIN_FILENO);  // gets the number that has become free
  }
  EXPECT_GE(::fcntl(other, F_GETFD), 0);
  ::close(other);
}

TEST(Pty, MovesWithItsLine) {
  auto one = Pty::open();
  auto two = Pty::open();
  ASSERT_TRUE(one && two);
  const std::string name = one->name();
  *two = std::move(*one);
  EXPECT_EQ(two->name(), name);
  SerialDevice device;
  ASSERT_EQ(device.open(name.c_str(), 115200), 0);
  expectEveryByteCrosses(two->stream(), device.stream(), device.descriptor());
  Pty& same = *two;
  *two = std::move(same);
  expectEveryByteCrosses(device.stream(), two->stream(), two->descriptor());
  EXPECT_FALSE(isHungUp(two->descriptor()));
}

TEST(Pty, ClosesBothOfItsSides) {
  const auto descriptors = [] {
    const std::filesystem::directory_iterator open("/proc/self/fd");
    return std::distance(begin(open), end(open));
  };
  const auto before = descriptors();
  {
    const auto pty = Pty::open();
    ASSERT_TRUE(pty);
    EXPECT_EQ(descriptors(), before + 2);
  }
  EXPECT_EQ(descriptors(), before);
}

TEST(Pty, HoldsTheUserSideThatCameWithTheMove) {
  auto kept = Pty::open();
  ASSERT_TRUE(kept);
  {
    auto gone = Pty::open();
    ASSERT_TRUE(gone);
    *kept = std::move(*gone);
  }
  EXPECT_FALSE(isHungUp(kept->descriptor()));
  kept->releaseUserSide();
  EXPECT_TRUE(isHungUp(kept->descriptor()));
}

TEST(SerialDevice, KeepsWhatThePeerSaidBeforeItWasOpened) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  const uint8_t word[] = {1, 2, 0};
  ASSERT_EQ(pty->stream().write(&*pty, word, 3), 3);
  SerialDevice device;
  ASSERT_EQ(device.open(pty->name().c_str(), 115200), 0);
  uint8_t got[3] = {};
  EXPECT_EQ(device.stream().read(&device, got, 3), 3);
}

TEST(SerialDevice, TheOtherEndsDeathIsClosed) {
  SerialDevice device;
  {
    auto pty = Pty::open();
    ASSERT_TRUE(pty);
    ASSERT_EQ(device.open(pty->name().c_str(), 9600), 0);
  }
  uint8_t byte = 0;
  EXPECT_EQ(device.stream().read(&device, &byte, 1), kGliderStreamClosed);
  EXPECT_EQ(device.stream().write(&device, &byte, 1), kGliderStreamClosed);

  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  ASSERT_EQ(device.open(pty->name().c_str(), 9600), 0);
  pty->releaseUserSide();
  EXPECT_EQ(pty->stream().read(&*pty, &byte, 1), 0);
  device.close();
  EXPECT_EQ(pty->stream().read(&*pty, &byte, 1), kGliderStreamClosed);
}

TEST(SerialDevice, SaysWhatFailed) {
  SerialDevice device;
  EXPECT_EQ(device.open("/dev/there-is-none", 9600), ENOENT);
  EXPECT_EQ(device.open("/dev/null", 9600), ENOTTY);
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  EXPECT_EQ(device.open(pty->name().c_str(), 12345), EINVAL);
  EXPECT_FALSE(device.isOpen());
}

// accepts: GL9100 GL9101 GL9102 GL9103 GL9104 GL9105 GL9106
TEST(SerialPort, OpensAPtyByNameAndByLink) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  const std::string link = testing::TempDir() + "glider-port-" + std::to_string(getpid());
  std::filesystem::create_symlink(pty->name(), link);
  {
    auto port = SerialPort::open(link, 115200);
    ASSERT_EQ(codeOf(port), "opened");
    const SerialPort moved = std::move(*port);
    expectEveryByteCrosses(moved.stream(), pty->stream(), pty->descriptor());
  }
  EXPECT_EQ(codeOf(SerialPort::open(pty->name(), 9600)), "opened") << "free again";
  std::filesystem::remove(link);
}

TEST(SerialPort, MissingIsGL9100) {
  EXPECT_EQ(codeOf(SerialPort::open("/dev/there-is-none", 115200)), "GL9100");
  EXPECT_EQ(codeOf(SerialPort::open("/dev/null/below", 115200)), "GL9100");
  EXPECT_EQ(codeOf(SerialPort::open("", 115200)), "GL9100");
}

TEST(SerialPort, NoPermissionIsGL9101) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  ASSERT_EQ(::chmod(pty->name().c_str(), 0), 0);
  const bool root = ::geteuid() == 0;
  if (root) {
    ASSERT_EQ(::seteuid(65534), 0);  // root may do anything
  }
  const std::string code = codeOf(SerialPort::open(pty->name(), 115200));
  if (root) {
    ASSERT_EQ(::seteuid(0), 0);
  }
  EXPECT_EQ(code, "GL9101");
}

TEST(SerialPort, InUseIsGL9102) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  const auto first = SerialPort::open(pty->name(), 115200);
  ASSERT_TRUE(first);
  EXPECT_EQ(codeOf(SerialPort::open(pty->name(), 115200)), "GL9102");
}

TEST(SerialPort, NotSerialIsGL9103) {
  EXPECT_EQ(codeOf(SerialPort::open("/dev/null", 115200)), "GL9103");
  EXPECT_EQ(codeOf(SerialPort::open("/tmp", 115200)), "GL9103");
  const std::string file = testing::TempDir() + "glider-file-" + std::to_string(getpid());
  std::ofstream(file) << "x";
  EXPECT_EQ(codeOf(SerialPort::open(file, 115200)), "GL9103");
  std::filesystem::remove(file);
}

TEST(SerialPort, ASpeedOfNoLineIsGL9104) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  const auto port = SerialPort::open(pty->name(), 12345);
  EXPECT_EQ(codeOf(port), "GL9104");
  EXPECT_NE(port.error().message.find("12345 baud"), std::string::npos);
}

/// Leaves the program no file descriptor to open.
class NoDescriptors {
 public:
  NoDescriptors() {
    EXPECT_EQ(::getrlimit(RLIMIT_NOFILE, &before_), 0);
    rlimit none = before_;
    none.rlim_cur = 0;
    EXPECT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  }
  NoDescriptors(const NoDescriptors&) = delete;
  NoDescriptors& operator=(const NoDescriptors&) = delete;
  ~NoDescriptors() { ::setrlimit(RLIMIT_NOFILE, &before_); }

 private:
  rlimit before_{};
};

/// No lack of descriptors: the sanitizers need one of their own to look at a virtual table.
TEST(SerialPort, AnythingElseIsGL9105) {
  auto pty = Pty::open();
  ASSERT_TRUE(pty);
  open_fails_with = EIO;
  const auto port = SerialPort::open(pty->name(), 115200);
  open_fails_with = 0;
  ASSERT_FALSE(port);
  EXPECT_EQ(support::code(port.error().id), "GL9105");
  EXPECT_NE(port.error().message.find("failed: Input/output error"), std::string::npos)
      << port.error().message;
}

TEST(Pty, NoneToBeHadIsGL9106) {
  const KeepsOpen input(STDIN_FILENO), output(STDOUT_FILENO);
  const NoDescriptors none;
  const auto pty = Pty::open();
  ASSERT_FALSE(pty);
  EXPECT_EQ(support::code(pty.error().id), "GL9106");
  EXPECT_NE(pty.error().message.find("Too many open files"), std::string::npos)
      << pty.error().message;
}

TEST(Pty, WhoseUserSideCannotBeOpenedIsGL9106) {
  open_fails_with = EIO;
  const auto pty = Pty::open();
  open_fails_with = 0;
  ASSERT_FALSE(pty);
  EXPECT_NE(pty.error().message.find("Input/output error"), std::string::npos)
      << pty.error().message;
}

}  // namespace
}  // namespace glider::hooks
