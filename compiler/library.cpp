// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "compiler/library.h"

#include "compiler/share.h"

#include <utility>

namespace glider::compiler {

std::vector<LibraryFile> libraryFor(const platforms::Platform& platform) {
  const std::filesystem::path folder = shareDirectory() / "library";
  if (platform.envelope.steersBySpeed()) {
    return {{folder / "propeller.mission", false, ""},
            {folder / "standard.mission", true, "fixed_fin"}};
  }
  return {{folder / "standard.mission", false, ""}};
}

void addPart(const LibraryFile& part, ast::File parsed_file, Parsed& parsed) {
  if (part.routes_only) {
    std::erase_if(parsed_file.items, [&](const ast::Item& item) {
      const auto* behaviour = std::get_if<ast::Behaviour>(&item);
      return behaviour != nullptr && (behaviour->kind == ast::BehaviourKind::Profile ||
                                      behaviour->name.text == part.without);
    });
  }
  parsed.standard_library.push_back(parsed_file.file);
  parsed.libraries.push_back(std::move(parsed_file));
}

}  // namespace glider::compiler
