// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/files.h"

#include "support/diagnostics/ids/files.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>
#include <vector>

namespace glider::support {
namespace {

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

/// True for the names of open descriptors and of devices. The file that they refer to must be
/// written to directly, even if it is a regular file, because it is the standard output of some
/// program.
bool isDescriptorName(const std::filesystem::path& path) {
  std::error_code error;
  const auto folder = std::filesystem::canonical(path.parent_path(), error);
  return !error && (folder == "/dev" || folder.native().starts_with("/proc/"));
}

/// A device or pipe (/dev/full, a FIFO) cannot be replaced by a rename.
bool isSpecialFile(const std::filesystem::path& path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

/// Where the symbolic links that `path` itself may be lead to: a rename would replace the link. A
/// descriptor's name is not followed; a link to a file that does not exist yet is.
std::filesystem::path followLinks(std::filesystem::path path) {
  constexpr int kMostLinks = 40;  // as many as Linux follows
  std::error_code error;
  for (int i = 0; i < kMostLinks && !isDescriptorName(path); ++i) {
    const auto target = std::filesystem::read_symlink(path, error);
    if (error) {
      break;  // not a link: the end
    }
    path = path.parent_path() / target;  // an absolute target replaces it all
  }
  return path;
}

Result<void> writeSpecial(const std::filesystem::path& path, std::string_view content) {
  // Appends: a regular file behind the name may contain earlier output.
  Descriptor file(::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  if (file.get() < 0 || !writeAll(file.get(), content) || file.close() != 0) {
    return fail(support::diagnostics::cannotWrite, path.string(), std::strerror(errno));
  }
  return {};
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& path, size_t largest) {
  auto failed = [&](const std::string& why) {
    return fail(support::diagnostics::cannotRead, path.string(), why);
  };
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
    if (content.size() > largest) {
      return failed(fmt::format("it is larger than {} MiB", largest >> 20U));
    }
  }
}

bool isReplaceable(const std::filesystem::path& path) {
  const auto end = followLinks(path);
  return !isDescriptorName(end) && !isSpecialFile(end);
}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
  }
}

Result<StagedFile> StagedFile::write(const std::filesystem::path& path, std::string_view content,
                                     FileKind kind) {
  StagedFile staged;
  staged.path_ = followLinks(path);
  auto failed = [&] {
    return fail(support::diagnostics::cannotWrite, path.string(), std::strerror(errno));
  };
  std::error_code error;  // of a folder on the way, which mkostemp meets too
  if (std::filesystem::is_symlink(staged.path_, error)) {
    errno = ELOOP;
    return failed();
  }
  std::string temporary = staged.path_.string() + ".XXXXXX";
  Descriptor file(::mkostemp(temporary.data(), O_CLOEXEC));
  if (file.get() < 0) {
    return failed();
  }
  staged.temporary_ = std::move(temporary);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  const mode_t mode = (kind == FileKind::ExecutableProduct ? 0777U : 0666U) & ~mask;
  if (!writeAll(file.get(), content) || ::fchmod(file.get(), mode) != 0 ||
      (kind == FileKind::Document && ::fsync(file.get()) != 0) || file.close() != 0) {
    return failed();
  }
  return staged;
}

Result<void> StagedFile::publish() {
  if (::rename(temporary_.c_str(), path_.c_str()) != 0) {
    return fail(support::diagnostics::cannotWrite, path_.string(), std::strerror(errno));
  }
  temporary_.clear();
  return {};
}

Result<void> writeFileAtomically(const std::filesystem::path& path, std::string_view content,
                                 FileKind kind) {
  if (!isReplaceable(path)) {
    return writeSpecial(path, content);
  }
  auto staged = StagedFile::write(path, content, kind);
  return staged ? staged->publish() : std::unexpected(staged.error());
}

}  // namespace glider::support
