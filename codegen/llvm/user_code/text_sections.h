// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <llvm/ADT/ArrayRef.h>
#include <llvm/Object/ELFObjectFile.h>

#include <functional>
#include <string>

namespace glider::codegen {

/// Checks the code of a section.
using CheckCode =
    std::function<support::Result<void>(const llvm::object::SectionRef&, llvm::ArrayRef<uint8_t>)>;

/// Checks each section of machine code; the first failure ends it. GL4003 for a section that cannot
/// be read; `name`: of the object.
support::Result<void> checkTextSections(const llvm::object::ELFObjectFileBase& object,
                                        const std::string& name, const CheckCode& check);

}  // namespace glider::codegen
