// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/explain_page.h"

#include "compiler/share.h"
#include "support/files.h"

namespace glider::driver {

support::Result<std::string> explainPage(support::DiagnosticId id) {
  return support::readFile(compiler::shareDirectory() / "explain" / (support::code(id) + ".md"));
}

}  // namespace glider::driver
