// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/disassembler.h"

#include "codegen/llvm/budget/architecture.h"
#include "codegen/llvm/target/machine.h"
#include "support/diagnostics/ids/target.h"

#include <llvm/MC/MCAsmInfo.h>
#include <llvm/MC/MCContext.h>
#include <llvm/MC/MCDisassembler/MCDisassembler.h>
#include <llvm/MC/MCInst.h>
#include <llvm/MC/MCInstPrinter.h>
#include <llvm/MC/MCInstrAnalysis.h>
#include <llvm/MC/MCInstrInfo.h>
#include <llvm/MC/MCRegisterInfo.h>
#include <llvm/MC/MCSubtargetInfo.h>
#include <llvm/MC/TargetRegistry.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace glider::codegen {

struct Disassembler::Machine {
  std::unique_ptr<llvm::TargetMachine> target;
  std::unique_ptr<Architecture> architecture;
  std::unique_ptr<llvm::MCContext> context;
  std::unique_ptr<llvm::MCDisassembler> reader;
  std::unique_ptr<llvm::MCInstPrinter> printer;
  std::unique_ptr<llvm::MCInstrAnalysis> analysis;
  /// By LLVM's register: the registers by StackEffect's numbers of which it has a part, a bit each.
  std::vector<uint32_t> numbered;
};

namespace {

std::unique_ptr<Architecture> architectureOf(const platforms::Board& board) {
  return Architecture::of(llvm::Triple(llvm::Triple::normalize(board.triple)));
}

/// "ldr" and "pc, [sp]" of "\tldr\tpc, [sp]\t@ comment".
Written split(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("\t "), line.size()));
  const size_t end = std::min(line.find_first_of("\t "), line.size());
  const std::string_view operation = line.substr(0, end);
  line.remove_prefix(end);
  line.remove_prefix(std::min(line.find_first_not_of("\t "), line.size()));
  const size_t comment = std::min({line.find_first_of("@\n"), line.find("//"), line.size()});
  std::string_view operands = line.substr(0, comment);
  while (operands.ends_with(' ') || operands.ends_with('\t')) {
    operands.remove_suffix(1);
  }
  return {operation, operands};
}

std::vector<uint32_t> numbersOf(const llvm::MCRegisterInfo& registers,
                                const Architecture& architecture) {
  std::vector<uint32_t> numbered(registers.getNumRegs(), 0);
  for (unsigned whole = 1; whole < registers.getNumRegs(); ++whole) {
    const uint8_t number = architecture.numberOf(registers.getName(whole));
    for (unsigned part = 1; part < registers.getNumRegs() && number != StackEffect::kNone; ++part) {
      numbered[part] |= registers.regsOverlap(whole, part) ? 1U << number : 0;
    }
  }
  return numbered;
}

bool hasTarget(Flow flow) {
  return flow == Flow::Jump || flow == Flow::JumpIf || flow == Flow::Call;
}

}  // namespace

Disassembler::Disassembler(std::unique_ptr<Machine> machine) : machine_(std::move(machine)) {}
Disassembler::~Disassembler() = default;

bool Disassembler::knows(const platforms::Board& board) {
  return architectureOf(board) != nullptr;
}

const StackMachine& stackMachine(const platforms::Board& board) {
  return architectureOf(board)->stackMachine();
}

support::Result<std::unique_ptr<Disassembler>> Disassembler::make(const platforms::Board& board) {
  auto target = makeMachine(board, 0, ProgramKind::Executable);
  if (!target) {
    return std::unexpected(target.error());
  }
  auto machine = std::make_unique<Machine>();
  machine->architecture = architectureOf(board);
  if (!machine->architecture) {
    return support::fail(support::diagnostics::unsupportedMachine, board.name, board.triple,
                         board.cpu);
  }
  machine->architecture->initialiseDisassembler();
  const llvm::Triple& triple = (*target)->getTargetTriple();
  const llvm::Target& known = (*target)->getTarget();
  const llvm::MCSubtargetInfo& chip = *(*target)->getMCSubtargetInfo();
  machine->context = std::make_unique<llvm::MCContext>(triple, (*target)->getMCAsmInfo(),
                                                       (*target)->getMCRegisterInfo(), &chip);
  machine->reader.reset(known.createMCDisassembler(chip, *machine->context));
  machine->printer.reset(known.createMCInstPrinter(triple, 0, *(*target)->getMCAsmInfo(),
                                                   *(*target)->getMCInstrInfo(),
                                                   *(*target)->getMCRegisterInfo()));
  machine->analysis.reset(known.createMCInstrAnalysis((*target)->getMCInstrInfo()));
  machine->numbered = numbersOf(*(*target)->getMCRegisterInfo(), *machine->architecture);
  machine->target = std::move(*target);
  return std::unique_ptr<Disassembler>(new Disassembler(std::move(machine)));
}

bool Disassembler::isTrap(llvm::StringRef bytes) const {
  return machine_->architecture->isTrap(bytes);
}

/// The registers that an instruction changes, a bit each.
uint32_t Disassembler::writtenBy(const llvm::MCInst& inst, const llvm::MCInstrDesc& about) const {
  uint32_t written = 0;
  for (const llvm::MCPhysReg implied : about.implicit_defs()) {
    written |= machine_->numbered[implied];
  }
  const unsigned variable = about.variadicOpsAreDefs() ? about.getNumOperands() - 1 : UINT_MAX;
  for (unsigned i = 0; i < inst.getNumOperands(); ++i) {
    if (inst.getOperand(i).isReg() && (i < about.getNumDefs() || i >= variable)) {
      written |= machine_->numbered[inst.getOperand(i).getReg()];
    }
  }
  return written;
}

Instruction Disassembler::read(llvm::StringRef bytes, uint64_t address) {
  Architecture& architecture = *machine_->architecture;
  Instruction one;
  one.address = address;
  llvm::MCInst inst;
  uint64_t size = 0;
  const llvm::ArrayRef<uint8_t> code(bytes.bytes_begin(), bytes.size());
  const auto status = machine_->reader->getInstruction(inst, size, code, address, llvm::nulls());
  if (status == llvm::MCDisassembler::Fail) {
    architecture.undecoded(bytes, one);
    return one;
  }
  one.size = static_cast<uint32_t>(size);
  std::string line;
  llvm::raw_string_ostream stream(line);
  machine_->printer->printInst(&inst, address, "", *machine_->target->getMCSubtargetInfo(), stream);
  stream.flush();
  const Written written = split(line);
  const llvm::MCInstrDesc& about = machine_->target->getMCInstrInfo()->get(inst.getOpcode());
  const uint8_t pointer = architecture.stackMachine().pointer;
  one.flow = architecture.flow(written);
  one.stack = architecture.stack(written);
  one.stack.writes = writtenBy(inst, about);
  one.stack.known = (one.stack.writes >> pointer & 1U) == 0 || one.stack.to == pointer;
  for (const llvm::MCOperand& operand : inst) {
    one.mentions.registers |= operand.isReg() ? machine_->numbered[operand.getReg()] : 0;
  }
  if (hasTarget(one.flow) && !machine_->analysis->evaluateBranch(inst, address, size, one.target)) {
    one.flow = Flow::Unknown;
  }
  architecture.complete({inst, about, written}, one);
  return one;
}

}  // namespace glider::codegen
