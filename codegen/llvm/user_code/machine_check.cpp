// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/machine_check.h"

#include "codegen/llvm/user_code/armv8.h"
#include "codegen/llvm/user_code/i486.h"
#include "support/diagnostics/ids/target.h"

#include <llvm/BinaryFormat/ELF.h>
#include <llvm/Support/ARMAttributeParser.h>
#include <llvm/Support/ARMBuildAttributes.h>
#include <llvm/TargetParser/ARMTargetParser.h>
#include <llvm/TargetParser/Triple.h>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

/// Reads the section of an ARM object that says what it was compiled for; empty if there is none.
llvm::Error readAttributes(const llvm::object::ELFObjectFileBase& object,
                           llvm::ARMAttributeParser& attributes) {
  for (const llvm::object::ELFSectionRef section : object.sections()) {
    if (section.getType() == llvm::ELF::SHT_ARM_ATTRIBUTES) {
      auto content = section.getContents();
      return content
                 ? attributes.parse(llvm::arrayRefFromStringRef(*content), llvm::endianness::little)
                 : content.takeError();
    }
  }
  return llvm::Error::success();
}

/// What an ARM object needs that its board's processor lacks, such as "built for a later ARM";
/// empty if nothing.
std::string armFault(const llvm::object::ELFObjectFileBase& object, const Board& board) {
  llvm::ARMAttributeParser attributes;
  if (llvm::Error error = readAttributes(object, attributes)) {
    return llvm::toString(std::move(error));
  }
  namespace arm = llvm::ARMBuildAttrs;
  const unsigned newest = llvm::ARM::getArchAttr(llvm::ARM::parseCPUArch(board.cpu));
  const auto value = [&](unsigned tag) { return attributes.getAttributeValue(tag).value_or(0); };
  if (value(arm::CPU_arch) > newest) {
    return "for a later ARM processor";
  }
  const bool soft = board.float_abi == platforms::FloatAbi::Soft;
  const bool registers = value(arm::ABI_VFP_args) == arm::HardFPAAPCS ||
                         (object.getPlatformFlags() & llvm::ELF::EF_ARM_ABI_FLOAT_HARD) != 0;
  return soft && (registers || value(arm::FP_arch) != 0) ? "for an ARM processor with FPU" : "";
}

std::string processorOf(const Board& board) {
  return board.float_abi == platforms::FloatAbi::Soft ? board.cpu + " without FPU" : board.cpu;
}

}  // namespace

std::string machineOf(const std::string& triple) {
  const llvm::Triple machine(triple);
  const std::string arch = llvm::Triple::getArchTypeName(machine.getArch()).str();
  const bool arm = (machine.isARM() || machine.isThumb()) && machine.isLittleEndian();
  return machine.getArch() == llvm::Triple::x86_64    ? "for 64-bit x86"
         : machine.getArch() == llvm::Triple::x86     ? "for 32-bit x86"
         : arm                                        ? "for 32-bit ARM"
         : machine.getArch() == llvm::Triple::aarch64 ? "for 64-bit ARM"
                                                      : "for " + arch;
}

Result<void> checkMachine(const llvm::object::ELFObjectFileBase& object, const std::string& name,
                          const Board& board) {
  const std::string wanted = machineOf(board.triple);
  if (const std::string found = machineOf(object.makeTriple().str()); found != wanted) {
    return support::fail(support::diagnostics::wrongMachine, name, found, board.name, wanted);
  }
  const llvm::Triple triple(board.triple);
  if (triple.isARM()) {
    if (const std::string fault = armFault(object, board); !fault.empty()) {
      return support::fail(support::diagnostics::wrongMachine, name, fault, board.name,
                           "for an " + processorOf(board));
    }
  }
  if (triple.isAArch64()) {
    return checkArmv8(object, name, board);
  }
  return board.cpu == "i486" ? checkI486(object, name, board) : Result<void>{};
}

}  // namespace glider::codegen
