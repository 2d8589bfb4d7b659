// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "codegen/options.h"
#include "compiler/compilation.h"
#include "report/brief/brief.h"
#include "support/result.h"

#include <string>
#include <string_view>
#include <vector>

namespace glider::driver {

inline constexpr const char* kUsualTarget = "host";
inline constexpr unsigned kUsualLevel = 2;

/// How `build` compiles `mission`, which must outlive this.
codegen::CodegenOptions buildOptions(const compiler::Optimised& mission, unsigned level);
/// The name of `mission`, a file, without folder and ending: what is written is named after it.
std::string stemOf(const std::string& mission);
/// The file that `build` writes if none is named: "survey-ts7800".
std::string builtName(const std::string& mission, const std::string& target,
                      std::string_view suffix);

/// The digest of the executable that `glidercc build --target TARGET` writes for the mission at
/// `path`. Without one if code in C is missing: BriefHash::note names it. Fails as a build does.
support::Result<report::BriefHash> executableHash(const std::string& path,
                                                  const compiler::Optimised& mission,
                                                  const std::string& target,
                                                  const std::vector<std::string>& user_code);

}  // namespace glider::driver
