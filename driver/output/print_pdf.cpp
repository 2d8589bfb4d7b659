// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/print_pdf.h"

#include "driver/output/flight_folder.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"
#include "support/program.h"

#include <fmt/format.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string_view>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace glider::driver {
namespace {

using support::Result;

constexpr const char* kBrowsers[] = {"chromium", "chromium-browser", "google-chrome"};
constexpr std::chrono::seconds kLongest{60};
constexpr std::chrono::milliseconds kPoll{20};

std::unexpected<support::Failure> notPrinted(const std::string& why) {
  return support::fail(support::diagnostics::pdfNotPrinted, why);
}

/// The first browser that is in PATH; empty: none.
std::string browser() {
  const char* path = std::getenv("PATH");
  for (const char* name : kBrowsers) {
    for (std::string_view rest = path == nullptr ? "" : path; !rest.empty();) {
      const size_t end = std::min(rest.find(':'), rest.size());
      const auto file = std::filesystem::path(rest.substr(0, end)) / name;
      if (::access(file.c_str(), X_OK) == 0) {
        return file.string();
      }
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }
  return "";
}

/// Waits until the program has ended; kills it after kLongest. Returns whether it ended well.
bool waitFor(pid_t program) {
  const auto until = std::chrono::steady_clock::now() + kLongest;
  int status = 0;
  for (;;) {
    const pid_t ended = ::waitpid(program, &status, WNOHANG);
    if (ended == program) {
      return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    }
    if (ended < 0 && errno != EINTR) {
      return false;
    }
    if (std::chrono::steady_clock::now() > until) {
      ::kill(program, SIGKILL);
      ::waitpid(program, &status, 0);
      return false;
    }
    std::this_thread::sleep_for(kPoll);
  }
}

/// Runs `command` without input; what it writes is lost.
bool runsWell(const std::vector<std::string>& command) {
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  if (nothing < 0) {
    return false;
  }
  // The shell takes the browser's messages away, which are about desktops that are not there.
  std::vector<std::string> quiet = {"sh", "-c", R"(exec "$0" "$@" 2>/dev/null)"};
  quiet.insert(quiet.end(), command.begin(), command.end());
  const pid_t program = support::startProgram(quiet, nothing, nothing);
  ::close(nothing);
  return program >= 0 && waitFor(program);
}

}  // namespace

Result<void> printPdf(const std::string& html, const std::filesystem::path& output) {
  const std::string program = browser();
  if (program.empty()) {
    return notPrinted("there is no chromium, chromium-browser or google-chrome in PATH");
  }
  const auto folder = FlightFolder::scratch();
  if (!folder) {
    return std::unexpected(folder.error());
  }
  const auto page = folder->staging() / "brief.html";
  const auto pdf = folder->staging() / "brief.pdf";
  if (auto written = support::writeFileAtomically(page, html, support::FileKind::Product);
      !written) {
    return written;
  }
  // A profile of its own: another browser of the user may be open. No sandbox: it needs rights that
  // containers do not give, and the page has no script.
  const bool printed = runsWell(
      {program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
       "--user-data-dir=" + (folder->staging() / "profile").string(), "--no-pdf-header-footer",
       "--print-to-pdf=" + pdf.string(), "file://" + page.string()});
  const auto content = support::readFile(pdf);
  if (!printed || !content) {
    return notPrinted(fmt::format("`{}` did not print the page", program));
  }
  return support::writeFileAtomically(output, *content);
}

}  // namespace glider::driver
