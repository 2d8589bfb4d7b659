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

/// What reads one encoding.
struct Disassembler::Reader {
  std::unique_ptr<Architecture> architecture;
  std::unique_ptr<llvm::MCSubtargetInfo> chip;
  std::unique_ptr<llvm::MCDisassembler> decoder;
  std::unique_ptr<llvm::MCInstrAnalysis> analysis;
};

struct Disassembler::Machine {
  std::unique_ptr<llvm::TargetMachine> target;
  std::unique_ptr<llvm::MCContext> context;
  std::unique_ptr<llvm::MCInstPrinter> printer;
  std::vector<Reader> readers;  ///< by Encoding; of Thumb only where there is any
  /// By LLVM's register: the registers by StackEffect's numbers of which it has a part, a bit each.
  std::vector<uint32_t> numbered;
};

namespace {

llvm::Triple tripleOf(const platforms::Board& board) {
  return llvm::Triple(llvm::Triple::normalize(board.triple));
}

std::unique_ptr<Architecture> architectureOf(const platforms::Board& board) {
  return Architecture::of(tripleOf(board));
}

/// "thumbv5e-…" for "armv5e-…".
llvm::Triple inThumb(llvm::Triple triple) {
  triple.setArchName(("thumb" + triple.getArchName().drop_front(3)).str());
  return triple;
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

/// `machine` has a target and a context; `triple` says the encoding.
Disassembler::Reader Disassembler::readerOf(const platforms::Board& board,
                                            const llvm::Triple& triple, const Machine& machine) {
  std::string ignored;
  const llvm::Target& known = *llvm::TargetRegistry::lookupTarget(triple.str(), ignored);
  Reader reader;
  reader.architecture = Architecture::of(triple);
  reader.chip.reset(known.createMCSubtargetInfo(triple.str(), board.cpu, board.features));
  reader.decoder.reset(known.createMCDisassembler(*reader.chip, *machine.context));
  reader.analysis.reset(known.createMCInstrAnalysis(machine.target->getMCInstrInfo()));
  return reader;
}

support::Result<std::unique_ptr<Disassembler>> Disassembler::make(const platforms::Board& board) {
  auto target = makeMachine(board, 0, ProgramKind::Executable);
  if (!target) {
    return std::unexpected(target.error());
  }
  const auto architecture = architectureOf(board);
  if (!architecture) {
    return support::fail(support::diagnostics::unsupportedMachine, board.name, board.triple,
                         board.cpu);
  }
  architecture->initialiseDisassembler();
  const llvm::Triple triple = tripleOf(board);
  auto machine = std::make_unique<Machine>();
  machine->target = std::move(*target);
  const llvm::MCAsmInfo& syntax = *machine->target->getMCAsmInfo();
  const llvm::MCRegisterInfo& registers = *machine->target->getMCRegisterInfo();
  machine->context = std::make_unique<llvm::MCContext>(triple, &syntax, &registers,
                                                       machine->target->getMCSubtargetInfo());
  machine->printer.reset(machine->target->getTarget().createMCInstPrinter(
      triple, 0, syntax, *machine->target->getMCInstrInfo(), registers));
  machine->numbered = numbersOf(registers, *architecture);
  machine->readers.push_back(readerOf(board, triple, *machine));
  if (triple.isARM()) {
    machine->readers.push_back(readerOf(board, inThumb(triple), *machine));
  }
  return std::unique_ptr<Disassembler>(new Disassembler(std::move(machine)));
}

bool Disassembler::isTrap(llvm::StringRef bytes) const {
  return machine_->readers.front().architecture->isTrap(bytes);
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

Instruction Disassembler::read(llvm::StringRef bytes, uint64_t address, Encoding encoding) {
  const Reader& reader = machine_->readers[static_cast<size_t>(encoding)];
  Architecture& architecture = *reader.architecture;
  Instruction one;
  one.address = address;
  llvm::MCInst inst;
  uint64_t size = 0;
  const llvm::ArrayRef<uint8_t> code(bytes.bytes_begin(), bytes.size());
  const auto status = reader.decoder->getInstruction(inst, size, code, address, llvm::nulls());
  if (status == llvm::MCDisassembler::Fail) {
    architecture.undecoded(bytes, one);
    return one;
  }
  one.size = static_cast<uint32_t>(size);
  std::string line;
  llvm::raw_string_ostream stream(line);
  machine_->printer->printInst(&inst, address, "", *reader.chip, stream);
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
  if (hasTarget(one.flow) && !reader.analysis->evaluateBranch(inst, address, size, one.target)) {
    one.flow = Flow::Unknown;
  }
  architecture.complete({inst, about, written}, one);
  return one;
}

}  // namespace glider::codegen
