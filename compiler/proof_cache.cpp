// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/proof_cache.h"

#include "codegen/digest.h"
#include "compiler/certificate_file.h"
#include "ir/prove/reprove.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

namespace glider::compiler {
namespace {

using ir::prove::EarlierProof;
using ir::prove::RequirementVerdict;

/// The number of files that are kept; most take some kilobytes.
constexpr size_t kMostKept = 5000;
/// The longest file that is kept, in bytes: to check a longer one takes as long as the search.
constexpr uintmax_t kLongest = 1 << 20;

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

ProofCache::ProofCache(const Checked& checked, unsigned effort)
    : checked_(checked), effort_(effort) {
  if (const auto subject = subjectOf(checked)) {
    subject_ = *subject;
    folder_ = cacheFolder();
  }
}

std::filesystem::path ProofCache::fileOf(uint32_t requirement) const {
  return folder_ / codegen::digestOf(fmt::format("{}\n{}", requirement, subject_));
}

std::optional<EarlierProof> ProofCache::find(uint32_t requirement) const {
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
  auto certificate =
      text ? certificateFromJson(*text, path.string(), checked_) : std::unexpected(text.error());
  if (!certificate || certificate->subject != subject_) {
    return std::nullopt;
  }
  EarlierProof proof{std::move(certificate->invariants), std::move(certificate->assumptions)};
  const bool proves =
      ir::prove::reproves(checked_.mission(), checked_.platform(), requirement, proof, effort_);
  return proves ? std::optional(std::move(proof)) : std::nullopt;
}

void ProofCache::keep(const std::vector<RequirementVerdict>& verdicts) const {
  std::error_code trouble;
  bool looked = false;
  for (const RequirementVerdict& verdict : verdicts) {
    const bool worth = verdict.searched && !verdict.cached && verdict.evidence &&
                       verdict.evidence->method == ir::prove::Method::Invariant;
    if (!worth || folder_.empty()) {
      continue;
    }
    const std::string text =
        certificateToJson(certificateOf(checked_, verdict, subject_), checked_.mission());
    if (text.size() > kLongest) {
      continue;
    }
    if (!std::exchange(looked, true)) {
      std::filesystem::create_directories(folder_, trouble);
      makeRoom(folder_);
    }
    // A cache that cannot be written is not an error of the mission.
    (void)support::writeFileAtomically(fileOf(verdict.requirement), text);
  }
}

}  // namespace glider::compiler
