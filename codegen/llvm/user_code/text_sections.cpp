// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/text_sections.h"

#include "support/diagnostics/ids/target.h"

namespace glider::codegen {

support::Result<void> checkTextSections(const llvm::object::ELFObjectFileBase& object,
                                        const std::string& name, const CheckCode& check) {
  for (const llvm::object::SectionRef& section : object.sections()) {
    if (!section.isText()) {
      continue;
    }
    auto content = section.getContents();
    if (!content) {
      return support::fail(support::diagnostics::notLinkable, name,
                           llvm::toString(content.takeError()));
    }
    if (auto checked = check(section, {content->bytes_begin(), content->bytes_end()}); !checked) {
      return checked;
    }
  }
  return {};
}

}  // namespace glider::codegen
