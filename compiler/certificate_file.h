// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "compiler/compilation.h"
#include "ir/certify/certificate.h"
#include "ir/prove/prove.h"
#include "support/result.h"
#include "support/trace/trace.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glider::compiler {

/// The content of a certificate's file.
struct Certificate {
  std::string requirement;  ///< its text in the mission
  std::string subject;      ///< the digest of the mission and the vehicle: subjectOf
  ir::prove::Method method = ir::prove::Method::Invariant;
  std::vector<uint32_t> assumptions;  ///< numbers of the mission's, on which the proof rests
  std::vector<ir::certify::Invariant> invariants;
  std::optional<support::Trace> run;  ///< of the method Run
};

/// The digest of everything that a proof is about: the mission and the platform file.
support::Result<std::string> subjectOf(const Checked& checked);

/// Where the certificate of the requirement with that number (from 0) is in a folder.
std::filesystem::path certificatePath(const std::filesystem::path& folder, uint32_t requirement);

/// The certificate of a proof that has evidence, without its run.
Certificate certificateOf(const Checked& checked, const ir::prove::RequirementVerdict& verdict,
                          std::string subject);

/// As JSON; docs/certificates.md describes it.
std::string certificateToJson(const Certificate& certificate, const ir::Mission& mission);

/// Reads what certificateToJson wrote; `name` is that of the file. GL9381, also if a state does not
/// exist in the mission or a configuration occurs twice. Of a certificate with another subject,
/// what names parts of the mission is not read: `recheck` refuses it.
support::Result<Certificate> certificateFromJson(const std::string& text, const std::string& name,
                                                 const Checked& checked);

}  // namespace glider::compiler
