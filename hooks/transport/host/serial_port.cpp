// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "hooks/transport/host/serial_port.h"

#include "hooks/transport/descriptor.h"
#include "hooks/transport/termios.h"
#include "support/diagnostics/ids/ports.h"

#include <libserialport.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <linux/serial.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <system_error>

namespace glider::hooks {
namespace {

using support::fail;
using support::Failure;

/// One writer per port: two programs that share one would each lose half of the answers.
bool lock(int descriptor) {
  return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
}

std::unexpected<Failure> failureOf(int error, const std::string& path, uint32_t baud) {
  switch (error) {
    case ENOENT:
    case ENXIO:
    case ENODEV:
      return fail(support::diagnostics::portMissing, path);
    case EACCES:
    case EPERM:
      return fail(support::diagnostics::portDenied, path);
    case EBUSY:
    case EWOULDBLOCK:
      return fail(support::diagnostics::portBusy, path);
    case ENOTTY:
    case EISDIR:
      return fail(support::diagnostics::portNotSerial, path);
    case EINVAL:
      return fail(support::diagnostics::baudNotPossible, path, baud);
    default:
      return fail(support::diagnostics::portFailed, path, std::strerror(error));
  }
}

}  // namespace

class SerialPort::Port {
 public:
  Port() = default;
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;
  virtual ~Port() = default;
  virtual GliderByteStream stream() = 0;
  [[nodiscard]] virtual int descriptor() const = 0;
};

class SerialPort::TerminalPort final : public SerialPort::Port {
 public:
  /// 0 or an errno.
  int open(const std::string& path, uint32_t baud) {
    const int error = device_.open(path.c_str(), baud);
    return error != 0 ? error : lock(device_.descriptor()) ? 0 : EBUSY;
  }
  GliderByteStream stream() override { return device_.stream(); }
  [[nodiscard]] int descriptor() const override { return device_.descriptor(); }

 private:
  SerialDevice device_;
};

class SerialPort::LibraryPort final : public SerialPort::Port {
 public:
  ~LibraryPort() override {
    if (open_) {
      sp_close(port_);
    }
    sp_free_port(port_);
  }
  /// 0 or an errno.
  int open(const std::string& path, uint32_t baud) {
    if (sp_get_port_by_name(path.c_str(), &port_) != SP_OK) {
      return ENOTTY;  // the caller has checked that it exists, but it is not a serial port
    }
    if (sp_open(port_, SP_MODE_READ_WRITE) != SP_OK) {
      return sp_last_error_code();
    }
    open_ = true;
    int descriptor = -1;
    if (sp_get_port_handle(port_, &descriptor) != SP_OK || !lock(descriptor)) {
      return EBUSY;
    }
    if (sp_set_baudrate(port_, static_cast<int>(baud)) != SP_OK) {
      return EINVAL;
    }
    const bool set = sp_set_bits(port_, 8) == SP_OK &&
                     sp_set_parity(port_, SP_PARITY_NONE) == SP_OK &&
                     sp_set_stopbits(port_, 1) == SP_OK &&
                     sp_set_flowcontrol(port_, SP_FLOWCONTROL_NONE) == SP_OK;
    return set ? 0 : EIO;
  }
  GliderByteStream stream() override { return {this, &LibraryPort::read, &LibraryPort::write}; }
  [[nodiscard]] int descriptor() const override {
    int descriptor = -1;
    sp_get_port_handle(port_, &descriptor);
    return descriptor;
  }

 private:
  static int32_t read(void* self, uint8_t* bytes, uint32_t capacity) {
    sp_port* port = static_cast<LibraryPort*>(self)->port_;
    const auto got = sp_nonblocking_read(port, bytes, capacity);
    if (got == 0 &&
        isHungUp(static_cast<LibraryPort*>(self)->descriptor())) {  // an unplugged adapter
      return kGliderStreamClosed;
    }
    return got >= 0 ? static_cast<int32_t>(got) : kGliderStreamFailed;
  }
  static int32_t write(void* self, const uint8_t* bytes, uint32_t count) {
    const auto taken = sp_nonblocking_write(static_cast<LibraryPort*>(self)->port_, bytes, count);
    return taken >= 0 ? static_cast<int32_t>(taken) : kGliderStreamFailed;
  }

  sp_port* port_ = nullptr;
  bool open_ = false;
};

support::Result<SerialPort> SerialPort::open(const std::string& path, uint32_t baud) {
  std::error_code error;
  const std::filesystem::path device = std::filesystem::canonical(path, error);
  if (error) {
    return failureOf(error.value() == EACCES ? EACCES : ENOENT, path, baud);
  }
  if (!std::filesystem::is_character_file(device, error)) {
    return fail(support::diagnostics::portNotSerial, path);
  }
  if (isPseudoTerminal(device.c_str())) {
    auto terminal = std::make_unique<TerminalPort>();
    const int failed = terminal->open(device.string(), baud);
    return failed != 0 ? support::Result<SerialPort>(failureOf(failed, path, baud))
                       : SerialPort(std::move(terminal));
  }
  auto port = std::make_unique<LibraryPort>();
  const int failed = port->open(device.string(), baud);
  return failed != 0 ? support::Result<SerialPort>(failureOf(failed, path, baud))
                     : SerialPort(std::move(port));
}

SerialPort::SerialPort(std::unique_ptr<Port> port) : port_(std::move(port)) {}
SerialPort::SerialPort(SerialPort&&) noexcept = default;
SerialPort& SerialPort::operator=(SerialPort&&) noexcept = default;
SerialPort::~SerialPort() = default;

std::optional<SerialPort::Errors> SerialPort::errors() const {
  serial_icounter_struct counts{};
  if (::ioctl(port_->descriptor(), TIOCGICOUNT, &counts) != 0) {
    return std::nullopt;
  }
  return Errors{
      .overruns = static_cast<uint32_t>(counts.overrun) + static_cast<uint32_t>(counts.buf_overrun),
      .framing = static_cast<uint32_t>(counts.frame)};
}

GliderByteStream SerialPort::stream() const {
  return port_->stream();
}

}  // namespace glider::hooks
