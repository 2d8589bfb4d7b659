// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/check_progress.h"

#include "support/one_line.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace glider::driver {
namespace {

constexpr std::chrono::seconds kPatience(1);
constexpr std::chrono::milliseconds kBetween(250);

/// The width of the terminal; a longer line could not be overwritten.
size_t columns() {
  constexpr size_t kUsual = 80;
  winsize size = {};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1;
  return known ? size.ws_col : kUsual;
}

/// The beginning of `text` that is at most `bytes` long and ends with a whole character.
std::string_view cut(std::string_view text, size_t bytes) {
  auto continues = [&](size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
  };
  size_t end = std::min(text.size(), bytes);
  while (end > 0 && end < text.size() && continues(end)) {
    --end;
  }
  return text.substr(0, end);
}

}  // namespace

CheckProgress::CheckProgress(std::string mission, double limit_s)
    : mission_(std::move(mission)), limit_s_(limit_s) {
  teller_ = std::thread([this] { run(); });
}

CheckProgress::~CheckProgress() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  ended_.notify_all();
  if (teller_.joinable()) {
    teller_.join();
  }
}

void CheckProgress::at(const std::string& work) {
  const std::lock_guard lock(mutex_);
  work_ = support::onOneLine(work);
}

void CheckProgress::clear() {
  const std::lock_guard lock(mutex_);
  line_.clear();
}

/// Runs in its own thread and shows the elapsed time: the solver reports nothing for seconds.
void CheckProgress::run() {
  std::unique_lock lock(mutex_);
  for (auto wait = std::chrono::milliseconds(kPatience);
       !ended_.wait_for(lock, wait, [this] { return end_; }); wait = kBetween) {
    const auto took = std::chrono::steady_clock::now() - begin_;
    const std::string after =
        fmt::format(", {} s{}", std::chrono::duration_cast<std::chrono::seconds>(took).count(),
                    limit_s_ > 0 ? fmt::format(" (proofs: at most {:g} s)", limit_s_) : "");
    const size_t room = line_.onTerminal() ? columns() - 1 : std::string::npos;
    const size_t before = room > after.size() ? room - after.size() : 0;
    line_.show(fmt::format("{}{}", cut(fmt::format("{}: {}", mission_, work_), before), after));
  }
}

}  // namespace glider::driver
