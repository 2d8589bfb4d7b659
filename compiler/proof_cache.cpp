// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/proof_cache.h"

#include "codegen/digest.h"
#include "compiler/build_id.h"
#include "compiler/proving.h"
#include "support/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace glider::compiler {
namespace {

using codegen::digestOf;
using ir::prove::CachedVerdict;
using ir::prove::RequirementVerdict;
using ir::prove::Verdict;

constexpr std::string_view kMagic = "glidercc proof 2";
/// The number of files that are kept; a proof takes some hundred bytes.
constexpr size_t kMostKept = 5000;
/// The longest file that is read, in bytes: a longer one was not written by glidercc.
constexpr uintmax_t kLongest = 4096;

std::filesystem::path cacheFolder() {
  const auto given = [](const char* name) {
    const char* value = std::getenv(name);
    return std::filesystem::path(value == nullptr ? "" : value);
  };
  if (const auto cache = given("XDG_CACHE_HOME"); cache.is_absolute()) {
    return cache / "glidercc" / "proofs";
  }
  const auto home = given("HOME");
  return home.is_absolute() ? home / ".cache" / "glidercc" / "proofs" : std::filesystem::path();
}

/// "KEY\nverdict\nassumptions\nwords\n" with its own digest, so that a part of a file, or the file
/// of another key, is not accepted.
std::string written(const std::string& key, const RequirementVerdict& verdict) {
  const std::string body =
      fmt::format("{}\n{}\n{}\n{}\n", key, ir::prove::word(verdict.verdict),
                  fmt::join(verdict.assumptions, " "),
                  verdict.verdict == Verdict::Proved ? verdict.premise : verdict.reason);
  return fmt::format("{}\n{}\n{}", kMagic, digestOf(body), body);
}

std::optional<CachedVerdict> readBack(const std::string& key, std::string_view text) {
  const auto line = [&]() {
    const size_t end = text.find('\n');
    const std::string_view found = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
    return found;
  };
  const std::string_view magic = line();
  const std::string_view digest = line();
  if (magic != kMagic || digest != digestOf(text) || line() != key) {
    return std::nullopt;
  }
  const std::string_view verdict = line();
  const bool proved = verdict == ir::prove::word(Verdict::Proved);
  if (!proved && verdict != ir::prove::word(Verdict::Open)) {
    return std::nullopt;
  }
  std::istringstream numbers{std::string(line())};
  CachedVerdict found{proved ? Verdict::Proved : Verdict::Open, std::string(line())};
  for (uint32_t number = 0; numbers >> number;) {
    found.assumptions.push_back(number);
  }
  return found;
}

/// Removes the oldest files to make room for new ones.
void makeRoom(const std::filesystem::path& folder) {
  std::error_code trouble;
  std::vector<std::pair<std::filesystem::file_time_type, std::filesystem::path>> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, trouble)) {
    std::error_code gone;
    files.emplace_back(entry.last_write_time(gone), entry.path());
  }
  if (files.size() < kMostKept) {
    return;
  }
  std::ranges::sort(files);
  for (size_t i = 0; i < files.size() - kMostKept / 2; ++i) {
    std::filesystem::remove(files[i].second, trouble);
  }
}

}  // namespace

ProofCache::ProofCache(const Checked& checked, const ir::prove::Options& how) {
  const std::string program = buildId();
  const auto subject = proofSubject(checked);
  if (program.empty() || !subject) {
    return;
  }
  folder_ = cacheFolder();
  all_ = fmt::format("{}\n{} {} {}\n{}", program, how.effort, how.run_effort, how.total_effort,
                     *subject);
}

std::filesystem::path ProofCache::fileOf(uint32_t requirement) const {
  return folder_ / digestOf(fmt::format("{}\n{}", requirement, all_));
}

std::optional<CachedVerdict> ProofCache::find(uint32_t requirement) const {
  if (folder_.empty()) {
    return std::nullopt;
  }
  const std::filesystem::path path = fileOf(requirement);
  std::error_code trouble;
  const uintmax_t size = std::filesystem::file_size(path, trouble);
  if (trouble || size > kLongest || !std::filesystem::is_regular_file(path, trouble)) {
    return std::nullopt;
  }
  const auto text = support::readFile(path);
  return text ? readBack(path.filename().string(), *text) : std::nullopt;
}

void ProofCache::keep(const std::vector<RequirementVerdict>& verdicts) const {
  std::error_code trouble;
  bool looked = false;
  for (const RequirementVerdict& verdict : verdicts) {
    const bool worth = verdict.searched && verdict.verdict != Verdict::Refuted;
    if (!worth || folder_.empty()) {
      continue;
    }
    if (!std::exchange(looked, true)) {
      std::filesystem::create_directories(folder_, trouble);
      makeRoom(folder_);
    }
    const std::filesystem::path path = fileOf(verdict.requirement);
    // A cache that cannot be written is not an error of the mission.
    (void)support::writeFileAtomically(path, written(path.filename().string(), verdict));
  }
}

}  // namespace glider::compiler
