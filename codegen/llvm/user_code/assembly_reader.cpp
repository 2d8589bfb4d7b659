// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/assembly_reader.h"

#include "support/check.h"

#include <llvm/ADT/StringRef.h>
#include <llvm/MC/MCAsmInfo.h>
#include <llvm/MC/MCContext.h>
#include <llvm/MC/MCDisassembler/MCDisassembler.h>
#include <llvm/MC/MCInst.h>
#include <llvm/MC/MCInstPrinter.h>
#include <llvm/MC/MCInstrInfo.h>
#include <llvm/MC/MCRegisterInfo.h>
#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/TargetParser/Triple.h>

#include <algorithm>

namespace glider::codegen {

AssemblyReader::AssemblyReader(const std::string& triple, const std::string& cpu,
                               const std::string& features) {
  std::string error;
  const llvm::Target* target = llvm::TargetRegistry::lookupTarget(triple, error);
  CHECK(target != nullptr, error.c_str());
  registers_.reset(target->createMCRegInfo(triple));
  syntax_.reset(target->createMCAsmInfo(*registers_, triple, options_));
  machine_.reset(target->createMCSubtargetInfo(triple, cpu, features));
  instructions_.reset(target->createMCInstrInfo());
  context_ = std::make_unique<llvm::MCContext>(llvm::Triple(triple), syntax_.get(),
                                               registers_.get(), machine_.get());
  reader_.reset(target->createMCDisassembler(*machine_, *context_));
  printer_.reset(
      target->createMCInstPrinter(llvm::Triple(triple), 0, *syntax_, *instructions_, *registers_));
}

AssemblyReader::~AssemblyReader() = default;

std::string AssemblyReader::next(llvm::ArrayRef<uint8_t>& code) {
  llvm::MCInst instruction;
  uint64_t size = 0;
  const auto status = reader_->getInstruction(instruction, size, code, 0, llvm::nulls());
  code = code.drop_front(size == 0 ? 1 : std::min<uint64_t>(size, code.size()));
  if (status != llvm::MCDisassembler::Success) {
    return "";
  }
  std::string text;
  llvm::raw_string_ostream stream(text);
  printer_->printInst(&instruction, 0, "", *machine_, stream);
  return llvm::StringRef(stream.str()).trim().str();
}

}  // namespace glider::codegen
