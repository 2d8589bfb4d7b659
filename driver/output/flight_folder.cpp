// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/flight_folder.h"

#include "compiler/boards.h"
#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/files.h"
#include "support/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <set>
#include <unistd.h>
#include <utility>
#include <vector>

namespace glider::driver {
namespace {

namespace fs = std::filesystem;
using support::Result;

constexpr std::string_view kStagingEnd = ".partial";

/// Whether this is a usual file name of a flight without a list of files; `targets` are the targets
/// that a mission may be built for.
bool isUsualName(const std::string& name, const std::vector<std::string>& targets) {
  constexpr std::array<std::string_view, 5> kNames = {"report.html", "trace.csv", "events.csv",
                                                      "mission.log", FlightFolder::kSummary};
  std::string_view stem = name;
  for (const std::string_view end : {".debug", ".checkpoint"}) {
    stem.remove_suffix(stem.ends_with(end) ? end.size() : 0);
  }
  const bool binary = std::ranges::any_of(
      targets, [&](const std::string& target) { return stem.ends_with("-" + target); });
  return binary || std::ranges::find(kNames, name) != kNames.end();
}

/// The files that the flight in `folder` lists as its own.
std::set<std::string> listedIn(const fs::path& folder) {
  std::set<std::string> names;
  if (const auto text = support::readFile(folder / FlightFolder::kSummary)) {
    const auto document = nlohmann::json::parse(*text, nullptr, false);
    const auto files = document.is_object() ? document.find("files") : document.end();
    if (document.is_object() && files != document.end() && files->is_array()) {
      for (const auto& file : *files) {
        names.insert(file.is_string() ? file.get<std::string>() : "");
      }
    }
  }
  return names;
}

/// The first name in `folder` that is not a file of a flight, or of a trace; empty if there is
/// none.
Result<std::string> foreignIn(const fs::path& folder, FlightFolder::Use use) {
  std::set<std::string> listed = listedIn(folder);
  if (use == FlightFolder::Use::Run) {
    listed.insert(FlightFolder::kRun);
  }
  const std::vector<std::string> targets = compiler::targetNames();
  std::error_code error;
  std::set<std::string> foreign;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!isUsualName(name, targets) && !listed.contains(name)) {
      foreign.insert(name);
    }
  }
  if (error) {
    return support::fail(support::diagnostics::cannotWrite, folder.string(), error.message());
  }
  return foreign.empty() ? "" : *foreign.begin();
}

/// The process that wrote staging folder `name` of `target`; 0 if it is not a staging folder.
pid_t writerOf(std::string_view name, const std::string& target) {
  const std::string begin = "." + target + ".";
  pid_t pid = 0;
  if (name.starts_with(begin) && name.ends_with(kStagingEnd)) {
    const std::string_view digits =
        name.substr(begin.size(), name.size() - begin.size() - kStagingEnd.size());
    const auto [end, bad] = std::from_chars(digits.data(), digits.data() + digits.size(), pid);
    pid = bad == std::errc() && end == digits.data() + digits.size() ? pid : 0;
  }
  return pid;
}

/// Removes what killed flights have left beside `target`.
void removeLeftOvers(const fs::path& target) {
  std::error_code ignored;
  std::vector<fs::path> left;
  for (const auto& entry : fs::directory_iterator(target.parent_path(), ignored)) {
    const pid_t writer = writerOf(entry.path().filename().string(), target.filename().string());
    if (writer > 0 && ::kill(writer, 0) != 0 && errno == ESRCH) {
      left.push_back(entry.path());
    }
  }
  for (const fs::path& path : left) {
    fs::remove_all(path, ignored);
  }
}

/// Whether the current folder is `target` or inside it: it would be gone after the exchange.
bool holdsWorkingFolder(const fs::path& target) {
  std::error_code error;
  const fs::path here = fs::current_path(error);
  const auto [end, rest] = std::ranges::mismatch(target, here);
  return !error && end == target.end();
}

Result<void> failed(const fs::path& path, const std::string& why) {
  return support::fail(support::diagnostics::cannotWrite, path.string(), why);
}

/// Checks that what is in the way at `whole` may be replaced. `target`: as the user named it.
Result<void> checkReplaceable(const fs::path& whole, const fs::path& target,
                              FlightFolder::Use use) {
  const bool run = use == FlightFolder::Use::Run;
  const auto refuse = [&](const std::string& why) -> Result<void> {
    return run ? failed(target, why)
               : support::fail(support::diagnostics::outputFolderInUse, target.string(), why);
  };
  const auto foreign = foreignIn(whole, use);
  if (!foreign) {
    return std::unexpected(foreign.error());
  }
  const char* what = run ? "counterexample" : "flight";
  if (!foreign->empty()) {
    return refuse(fmt::format("it contains `{}`, which is not from a {}", *foreign, what));
  }
  std::error_code error;
  if (!fs::is_empty(whole, error) && holdsWorkingFolder(whole)) {
    return refuse(fmt::format("it is the current folder and contains an earlier {}", what));
  }
  return {};
}

}  // namespace

Result<FlightFolder> FlightFolder::scratch() {
  std::error_code error;
  fs::path folder = fs::temp_directory_path(error) / fmt::format("glidercc-{}", ::getpid());
  if (error || !fs::create_directory(folder, error)) {
    return support::fail(support::diagnostics::cannotWrite, folder.string(),
                         error ? error.message() : "it already exists");
  }
  return FlightFolder(folder, folder);
}

Result<FlightFolder> FlightFolder::open(const fs::path& target, Use use) {
  std::error_code error;
  fs::path whole = fs::weakly_canonical(fs::absolute(target), error);
  whole = whole.has_filename() ? whole : whole.parent_path();
  if (!error) {
    fs::create_directories(whole.parent_path(), error);
  }
  if (!error && fs::exists(whole) && !fs::is_directory(whole)) {
    error = std::make_error_code(std::errc::not_a_directory);
  }
  if (error) {
    return support::fail(support::diagnostics::cannotWrite, target.string(), error.message());
  }
  if (fs::exists(whole, error)) {
    if (auto replaceable = checkReplaceable(whole, target, use); !replaceable) {
      return std::unexpected(replaceable.error());
    }
  }
  removeLeftOvers(whole);
  fs::path staging = whole.parent_path() /
                     fmt::format(".{}.{}{}", whole.filename().string(), ::getpid(), kStagingEnd);
  fs::remove_all(staging, error);
  if (!fs::create_directory(staging, error)) {
    return support::fail(support::diagnostics::cannotWrite, target.string(), error.message());
  }
  return FlightFolder(std::move(whole), std::move(staging));
}

FlightFolder::FlightFolder(FlightFolder&& other) noexcept
    : target_(std::move(other.target_)), staging_(std::exchange(other.staging_, {})) {}

FlightFolder::~FlightFolder() {
  if (!staging_.empty()) {
    std::error_code ignored;
    fs::remove_all(staging_, ignored);
  }
}

fs::path FlightFolder::placeOf(const fs::path& file) const {
  std::error_code error;
  const fs::path whole = fs::weakly_canonical(fs::absolute(file), error);
  return !error && whole.parent_path() == target_ ? staging_ / whole.filename() : file;
}

std::vector<std::string> FlightFolder::names() const {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(staging_, ignored)) {
    names.push_back(entry.path().filename().string());
  }
  std::ranges::sort(names);
  return names;
}

Result<void> FlightFolder::commit() {
  std::error_code error;
  const bool there = fs::exists(target_, error);
  if (there && fs::is_empty(target_, error)) {
    // This may be the current folder of a process, so the folder itself is kept.
    for (const std::string& name : names()) {
      fs::rename(staging_ / name, target_ / name, error);
      if (error) {
        return failed(target_, error.message());
      }
    }
    return {};
  }
  if (!there) {
    fs::rename(staging_, target_, error);
    staging_ = error ? staging_ : fs::path();
    return error ? failed(target_, error.message()) : Result<void>();
  }
  if (::renameat2(AT_FDCWD, staging_.c_str(), AT_FDCWD, target_.c_str(), RENAME_EXCHANGE) != 0) {
    return failed(target_, std::strerror(errno));
  }
  return {};  // staging_ is now the earlier flight, which the destructor removes
}

}  // namespace glider::driver
