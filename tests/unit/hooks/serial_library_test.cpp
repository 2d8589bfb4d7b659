// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Ports of real adapters, which a test machine lacks: the test answers for libserialport.

#include "hooks/transport/host/pty.h"
#include "hooks/transport/host/serial_port.h"
#include "support/diagnostics/diagnostic.h"

#include <gtest/gtest.h>
#include <libserialport.h>

#include <cerrno>
#include <cstdarg>
#include <fcntl.h>
#include <linux/serial.h>
#include <optional>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace {

/// What the library was asked for, and which of its functions fails.
struct Line {
  int descriptor = -1;
  std::string fails;
  int error = 0;                ///< of the failure
  std::optional<int> transfer;  ///< what reading and writing answer instead of carrying bytes
  std::optional<int> overruns;  ///< that the driver counts; empty: it does not
  std::string name;
  int opened = 0, closed = 0, freed = 0;
  int mode = 0, baud = 0, bits = 0, parity = -1, stop_bits = 0, flow_control = -1;
};

/// While there is one it is every port of the library.
Line* line = nullptr;

sp_return answer(std::string_view function) {
  return line->fails == function ? SP_ERR_FAIL : SP_OK;
}

sp_return answer(std::string_view function, int& kept, int value) {
  kept = value;
  return answer(function);
}

}  // namespace

extern "C" {
sp_return __real_sp_get_port_by_name(const char* name, sp_port** port);
sp_return __wrap_sp_get_port_by_name(const char* name, sp_port** port) {
  if (line == nullptr) {
    return __real_sp_get_port_by_name(name, port);
  }
  line->name = name;
  *port = line->fails == "name" ? nullptr : reinterpret_cast<sp_port*>(line);
  return answer("name");
}
void __wrap_sp_free_port(const sp_port* port) {
  if (port != nullptr) {
    ++line->freed;
  }
}
sp_return __wrap_sp_open(sp_port* /*port*/, sp_mode mode) {
  line->opened += line->fails == "open" ? 0 : 1;
  return answer("open", line->mode, mode);
}
sp_return __wrap_sp_close(sp_port* /*port*/) {
  ++line->closed;
  return SP_OK;
}
int __wrap_sp_last_error_code() {
  return line->error;
}
sp_return __wrap_sp_get_port_handle(const sp_port* /*port*/, void* handle) {
  *static_cast<int*>(handle) = line->descriptor;
  return answer("handle");
}
sp_return __wrap_sp_set_baudrate(sp_port* /*port*/, int baud) {
  return answer("baud", line->baud, baud);
}
sp_return __wrap_sp_set_bits(sp_port* /*port*/, int bits) {
  return answer("bits", line->bits, bits);
}
sp_return __wrap_sp_set_parity(sp_port* /*port*/, sp_parity parity) {
  return answer("parity", line->parity, parity);
}
sp_return __wrap_sp_set_stopbits(sp_port* /*port*/, int stop_bits) {
  return answer("stop bits", line->stop_bits, stop_bits);
}
sp_return __wrap_sp_set_flowcontrol(sp_port* /*port*/, sp_flowcontrol flow_control) {
  return answer("flow control", line->flow_control, flow_control);
}
/// As the library's: 0 when there is nothing, also when the adapter has been unplugged.
sp_return __wrap_sp_nonblocking_read(sp_port* /*port*/, void* bytes, size_t capacity) {
  const auto got =
      line->transfer.value_or(static_cast<int>(::read(line->descriptor, bytes, capacity)));
  return static_cast<sp_return>(got == -1 ? 0 : got);
}
sp_return __wrap_sp_nonblocking_write(sp_port* /*port*/, const void* bytes, size_t count) {
  return static_cast<sp_return>(
      line->transfer.value_or(static_cast<int>(::write(line->descriptor, bytes, count))));
}

int __real_ioctl(int descriptor, unsigned long request, ...);
int __wrap_ioctl(int descriptor, unsigned long request, ...);
int __wrap_ioctl(int descriptor, unsigned long request, ...) {
  va_list more;
  va_start(more, request);
  void* argument = va_arg(more, void*);
  va_end(more);
  if (line == nullptr || request != TIOCGICOUNT) {
    return __real_ioctl(descriptor, request, argument);
  }
  auto* counts = static_cast<serial_icounter_struct*>(argument);
  counts->overrun = line->overruns.value_or(0);
  counts->buf_overrun = 1;
  counts->frame = 5;
  return line->overruns && descriptor == line->descriptor ? 0 : -1;
}
}

namespace glider::hooks {
namespace {

/// Any device that is not a pseudo-terminal.
constexpr const char* kDevice = "/dev/null";

class LibraryPort : public testing::Test {
 protected:
  LibraryPort() {
    line = &line_;
    line_.descriptor = ::open(far_end_->name().c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK);
  }
  ~LibraryPort() override {
    ::close(line_.descriptor);
    line = nullptr;
  }

  /// The code of what is said when `function` fails with `error`.
  std::string codeWhenFails(const char* function, int error = 0) {
    line_.fails = function;
    line_.error = error;
    const auto port = SerialPort::open(kDevice, 9600);
    return port ? "opened" : support::code(port.error().id);
  }

  support::Result<Pty> far_end_ = Pty::open();
  Line line_;
};

TEST_F(LibraryPort, IsEightBitsWithoutParityOrFlowControl) {
  {
    const auto port = SerialPort::open(kDevice, 57600);
    ASSERT_TRUE(port);
    EXPECT_EQ(line_.name, kDevice);
    EXPECT_EQ(line_.mode, SP_MODE_READ_WRITE);
    EXPECT_EQ(line_.baud, 57600);
    EXPECT_EQ(line_.bits, 8);
    EXPECT_EQ(line_.parity, SP_PARITY_NONE);
    EXPECT_EQ(line_.stop_bits, 1);
    EXPECT_EQ(line_.flow_control, SP_FLOWCONTROL_NONE);
    EXPECT_EQ(line_.closed, 0);
  }
  EXPECT_EQ(line_.closed, 1);
  EXPECT_EQ(line_.freed, 1);
}

TEST_F(LibraryPort, CarriesBytesBothWays) {
  const auto port = SerialPort::open(kDevice, 9600);
  ASSERT_TRUE(port);
  const GliderByteStream near = port->stream(), far = far_end_->stream();
  const uint8_t word[] = {1, 2, 0};
  uint8_t got[4] = {};
  EXPECT_EQ(near.read(near.self, got, 4), 0) << "nothing yet is not the end";
  ASSERT_EQ(near.write(near.self, word, 3), 3);
  EXPECT_EQ(far.read(far.self, got, 4), 3);
  ASSERT_EQ(far.write(far.self, word, 3), 3);
  EXPECT_EQ(near.read(near.self, got, 2), 2);
  EXPECT_EQ(near.read(near.self, got + 2, 2), 1);
  EXPECT_EQ(got[1], 2);
  EXPECT_EQ(got[2], 0);
}

TEST_F(LibraryPort, HasTheCountsOfADriverThatCounts) {
  const auto port = SerialPort::open(kDevice, 9600);
  ASSERT_TRUE(port);
  EXPECT_FALSE(port->errors());
  line_.overruns = 2;
  const auto errors = port->errors();
  ASSERT_TRUE(errors);
  EXPECT_EQ(errors->overruns, 3U) << "of the device and of the driver";
  EXPECT_EQ(errors->framing, 5U);
}

TEST(TerminalPort, CountsNothing) {
  const auto far_end = Pty::open();
  const auto port = SerialPort::open(far_end->name(), 9600);
  ASSERT_TRUE(port);
  EXPECT_FALSE(port->errors());
}

TEST_F(LibraryPort, TellsAFailureFromAFullLineAndFromTheEnd) {
  const auto port = SerialPort::open(kDevice, 9600);
  ASSERT_TRUE(port);
  const GliderByteStream near = port->stream();
  uint8_t byte = 0;
  line_.transfer = SP_ERR_MEM;
  EXPECT_EQ(near.read(near.self, &byte, 1), kGliderStreamFailed);
  EXPECT_EQ(near.write(near.self, &byte, 1), kGliderStreamFailed);
  line_.transfer = 0;
  EXPECT_EQ(near.read(near.self, &byte, 1), 0);
  EXPECT_EQ(near.write(near.self, &byte, 1), 0);
  far_end_ = Pty::open();  // unplugged
  EXPECT_EQ(near.read(near.self, &byte, 1), kGliderStreamClosed);
  line_.transfer = 1;
  EXPECT_EQ(near.read(near.self, &byte, 1), 1) << "what had come before";
}

TEST_F(LibraryPort, OfAnotherProgramIsGL9102) {
  const int other = ::open(far_end_->name().c_str(), O_RDWR | O_NOCTTY);
  ASSERT_EQ(::flock(other, LOCK_EX | LOCK_NB), 0);
  EXPECT_EQ(codeWhenFails(""), "GL9102");
  ::close(other);
  EXPECT_EQ(codeWhenFails(""), "opened");
}

TEST_F(LibraryPort, SaysWhyItCannotBeOpened) {
  const std::pair<int, const char*> errors[] = {
      {ENOENT, "GL9100"}, {ENXIO, "GL9100"},  {ENODEV, "GL9100"},      {EACCES, "GL9101"},
      {EPERM, "GL9101"},  {EBUSY, "GL9102"},  {EWOULDBLOCK, "GL9102"}, {ENOTTY, "GL9103"},
      {EISDIR, "GL9103"}, {EINVAL, "GL9104"}, {EIO, "GL9105"}};
  for (const auto& [error, code] : errors) {
    EXPECT_EQ(codeWhenFails("open", error), code) << error;
  }
  EXPECT_EQ(line_.closed, 0) << "never open";
}

TEST_F(LibraryPort, SaysWhatOfTheLineCannotBeSet) {
  const std::pair<const char*, const char*> functions[] = {
      {"handle", "GL9102"}, {"baud", "GL9104"},      {"bits", "GL9105"},
      {"parity", "GL9105"}, {"stop bits", "GL9105"}, {"flow control", "GL9105"}};
  for (const auto& [function, code] : functions) {
    EXPECT_EQ(codeWhenFails(function), code) << function;
  }
  EXPECT_EQ(line_.opened, 6);
  EXPECT_EQ(line_.closed, 6);
  EXPECT_EQ(line_.freed, 6);
  EXPECT_EQ(codeWhenFails("name"), "GL9103");
}

}  // namespace
}  // namespace glider::hooks
