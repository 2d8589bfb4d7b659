// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/budget/disassembler.h"

#include "codegen/target/machine.h"

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
#include <llvm/Support/Endian.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace glider::codegen {

struct Disassembler::Machine {
  std::unique_ptr<llvm::TargetMachine> target;
  llvm::MCTargetOptions options;
  std::unique_ptr<llvm::MCContext> context;
  std::unique_ptr<llvm::MCDisassembler> reader;
  std::unique_ptr<llvm::MCInstPrinter> printer;
  std::unique_ptr<llvm::MCInstrAnalysis> analysis;
  bool arm = false;
};

namespace {

/// "ldr" and "pc, [sp]" of "\tldr\tpc, [sp]\t@ comment".
Written split(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("\t "), line.size()));
  const size_t end = std::min(line.find_first_of("\t "), line.size());
  const std::string_view operation = line.substr(0, end);
  line.remove_prefix(end);
  line.remove_prefix(std::min(line.find_first_not_of("\t "), line.size()));
  const size_t comment = std::min(line.find_first_of("@\n"), line.size());
  std::string_view operands = line.substr(0, comment);
  while (operands.ends_with(' ') || operands.ends_with('\t')) {
    operands.remove_suffix(1);
  }
  return {operation, operands};
}

/// ARM's multiplications, which do nothing but arithmetic. LLVM refuses those whose registers the
/// manual forbid before ARMv6, and the compiler's arithmetic has some that every ARM9 does right.
bool isMultiplication(llvm::StringRef bytes) {
  constexpr uint32_t kMask = 0x0F0000F0, kMultiply = 0x00000090;
  return bytes.size() >= 4 && (llvm::support::endian::read32le(bytes.data()) & kMask) == kMultiply;
}

/// N of "movl $N, %ecx"; nothing for any other instruction.
std::optional<int64_t> countSetBy(const Written& written) {
  const std::string_view operands = written.operands;
  constexpr std::string_view kTo = ", %ecx";
  int64_t number = 0;
  if (written.operation != "movl" || !operands.starts_with('$') || !operands.ends_with(kTo)) {
    return std::nullopt;
  }
  const std::string_view text = operands.substr(1, operands.size() - 1 - kTo.size());
  const bool whole = !llvm::StringRef(text.data(), text.size()).getAsInteger(0, number);
  return whole && number >= 0 ? std::optional(number) : std::nullopt;
}

/// The address in "*4197908(,%esi,4)"; 0 if there is none.
uint64_t tableOf(const Written& written) {
  uint64_t address = 0;
  llvm::StringRef text(written.operands.data(), written.operands.size());
  text.consume_front("*");
  const bool wrong = text.take_until([](char c) { return c == '('; }).getAsInteger(0, address);
  return wrong || !text.ends_with(",4)") ? 0 : address;
}

bool hasTarget(Flow flow) {
  return flow == Flow::Jump || flow == Flow::JumpIf || flow == Flow::Call;
}

}  // namespace

Disassembler::Disassembler(std::unique_ptr<Machine> machine) : machine_(std::move(machine)) {}
Disassembler::~Disassembler() = default;

bool Disassembler::knows(const platforms::Board& board) {
  const llvm::Triple triple(llvm::Triple::normalize(board.triple));
  return triple.getArch() == llvm::Triple::x86 || triple.getArch() == llvm::Triple::arm;
}

support::Result<std::unique_ptr<Disassembler>> Disassembler::make(const platforms::Board& board) {
  auto target = makeMachine(board, 0, ProgramKind::Executable);
  if (!target) {
    return std::unexpected(target.error());
  }
  const llvm::Triple& triple = (*target)->getTargetTriple();
  if (!knows(board)) {
    return support::fail(support::DiagnosticId::unsupportedMachine, board.name, board.triple,
                         board.cpu);
  }
  if (triple.isARM()) {
    LLVMInitializeARMDisassembler();
  } else {
    LLVMInitializeX86Disassembler();
  }
  auto machine = std::make_unique<Machine>();
  const llvm::Target& known = (*target)->getTarget();
  const llvm::MCSubtargetInfo& chip = *(*target)->getMCSubtargetInfo();
  machine->context = std::make_unique<llvm::MCContext>(triple, (*target)->getMCAsmInfo(),
                                                       (*target)->getMCRegisterInfo(), &chip);
  machine->reader.reset(known.createMCDisassembler(chip, *machine->context));
  machine->printer.reset(known.createMCInstPrinter(triple, 0, *(*target)->getMCAsmInfo(),
                                                   *(*target)->getMCInstrInfo(),
                                                   *(*target)->getMCRegisterInfo()));
  machine->analysis.reset(known.createMCInstrAnalysis((*target)->getMCInstrInfo()));
  machine->arm = triple.isARM();
  machine->target = std::move(*target);
  return std::unique_ptr<Disassembler>(new Disassembler(std::move(machine)));
}

/// Follows ecx from instruction to instruction, for `rep`.
void Disassembler::count(const Written& written, Instruction& one) {
  constexpr std::array<std::string_view, 4> kNames = {"ecx", "%cx", "%cl", "%ch"};
  if (written.operation.starts_with("rep")) {
    one.repeats = count_.value_or(Instruction::kUncounted);
    one.counted_at = counted_at_;
    count_.reset();
    return;
  }
  if (const auto set = countSetBy(written)) {
    count_ = set;
    counted_at_ = one.address;
    return;
  }
  const bool touches = std::ranges::any_of(kNames, [&](std::string_view name) {
    return written.operands.find(name) != std::string_view::npos;
  });
  if (touches || one.flow != Flow::Next) {
    count_.reset();
  }
}

Instruction Disassembler::read(llvm::StringRef bytes, uint64_t address) {
  Instruction one;
  one.address = address;
  llvm::MCInst inst;
  uint64_t size = 0;
  const llvm::ArrayRef<uint8_t> code(bytes.bytes_begin(), bytes.size());
  const auto status = machine_->reader->getInstruction(inst, size, code, address, llvm::nulls());
  if (status == llvm::MCDisassembler::Fail) {
    one.size = machine_->arm ? static_cast<uint32_t>(std::min<size_t>(4, bytes.size())) : 1;
    one.flow = machine_->arm && isMultiplication(bytes) ? Flow::Next : Flow::Unknown;
    return one;
  }
  one.size = static_cast<uint32_t>(size);
  std::string line;
  llvm::raw_string_ostream stream(line);
  machine_->printer->printInst(&inst, address, "", *machine_->target->getMCSubtargetInfo(), stream);
  stream.flush();
  const Written written = split(line);
  one.flow = machine_->arm ? armFlow(written) : x86Flow(written);
  if (!machine_->arm) {
    count(written, one);
  }
  if (!machine_->arm && one.flow == Flow::JumpByTable) {
    one.target = tableOf(written);
  }
  if (hasTarget(one.flow) && !machine_->analysis->evaluateBranch(inst, address, size, one.target)) {
    one.flow = Flow::Unknown;
  }
  return one;
}

}  // namespace glider::codegen
