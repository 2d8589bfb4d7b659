// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/link/debug_file.h"

#include "support/check.h"

#include <llvm/ADT/ArrayRef.h>
#include <llvm/ADT/SmallVector.h>
#include <llvm/ObjCopy/CommonConfig.h>
#include <llvm/ObjCopy/ConfigManager.h>
#include <llvm/ObjCopy/ObjCopy.h>
#include <llvm/Object/ELFObjectFile.h>
#include <llvm/Support/CRC.h>
#include <llvm/Support/Error.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/raw_ostream.h>

namespace glider::codegen {
namespace {

std::string copy(std::string_view linked, const llvm::objcopy::ConfigManager& config) {
  auto binary = llvm::object::createBinary(
      llvm::MemoryBufferRef(llvm::StringRef(linked.data(), linked.size()), "linked"));
  CHECK(static_cast<bool>(binary), "lld has made a file that LLVM cannot read");
  llvm::SmallVector<char, 0> bytes;
  llvm::raw_svector_ostream stream(bytes);
  llvm::Error error = llvm::objcopy::executeObjcopyOnBinary(config, **binary, stream);
  CHECK(!error, "lld has made a file that objcopy refuses");
  return {bytes.begin(), bytes.end()};
}

}  // namespace

SplitExecutable splitDebug(std::string_view linked, const std::string& debug_name) {
  SplitExecutable split;
  llvm::objcopy::ConfigManager debug;
  debug.Common.OnlyKeepDebug = true;
  split.debug = copy(linked, debug);
  llvm::objcopy::ConfigManager stripped;
  stripped.Common.StripAll = true;
  stripped.Common.AddGnuDebugLink = debug_name;
  stripped.Common.GnuDebugLinkCRC32 =
      llvm::crc32(llvm::arrayRefFromStringRef(llvm::StringRef(split.debug)));
  split.stripped = copy(linked, stripped);
  return split;
}

}  // namespace glider::codegen
