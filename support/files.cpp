// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/files.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace glider::support {
namespace {

constexpr size_t kLargestFile = size_t{64} << 20U;

/// Closes a file descriptor at the end of a scope.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) {
      ::close(fd_);
    }
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  /// Closes now and returns close's result: a full disk may only show there.
  int close() {
    const int result = ::close(fd_);
    fd_ = -1;
    return result;
  }

 private:
  int fd_;
};

bool writeAll(int fd, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(fd, content.data(), content.size());
    if (n < 0 && errno == EINTR) {
      continue;
    }
    if (n <= 0) {
      return false;
    }
    content.remove_prefix(static_cast<size_t>(n));
  }
  return true;
}

/// A device or pipe (`-o /dev/stdout`, /dev/full) cannot be replaced by a rename, so it is written
/// to directly.
bool isSpecialFile(const std::filesystem::path& path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

Result<void> writeSpecial(const std::filesystem::path& path, std::string_view content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0 || !writeAll(file.get(), content) || file.close() != 0) {
    return fail(DiagnosticId::cannotWrite, path.string(), std::strerror(errno));
  }
  return {};
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path) {
  auto failed = [&](const char* why) { return fail(DiagnosticId::cannotRead, path.string(), why); };
  Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (file.get() < 0) {
    return failed(std::strerror(errno));
  }
  std::string content;
  std::vector<char> buffer(size_t{1} << 16U);
  for (;;) {
    const ssize_t n = ::read(file.get(), buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) {
      continue;
    }
    if (n < 0) {
      return failed(std::strerror(errno));
    }
    if (n == 0) {
      return content;
    }
    content.append(buffer.data(), static_cast<size_t>(n));
    if (content.size() > kLargestFile) {
      return failed("it is larger than 64 MiB");
    }
  }
}

Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                 FileKind kind) {
  if (isSpecialFile(path)) {
    return writeSpecial(path, content);
  }
  std::string temporary = path.string() + ".XXXXXX";
  Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  auto failed = [&]() -> Result<void> {
    auto failure = fail(DiagnosticId::cannotWrite, path.string(), std::strerror(errno));
    ::unlink(temporary.c_str());
    return failure;
  };
  if (file.get() < 0) {
    return fail(DiagnosticId::cannotWrite, path.string(), std::strerror(errno));
  }
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const mode_t mode = (kind == FileKind::ExecutableProduct ? 0777U : 0666U) & ~mask;
  if (!writeAll(file.get(), content) || ::fchmod(file.get(), mode) != 0 ||
      (kind == FileKind::Document && ::fsync(file.get()) != 0) || file.close() != 0 ||
      ::rename(temporary.c_str(), path.c_str()) != 0) {
    return failed();
  }
  return {};
}

}  // namespace glider::support
