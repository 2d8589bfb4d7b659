// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/disassembler.h"

#include "codegen/llvm/target/machine.h"
#include "support/diagnostics/ids/target.h"

#include <llvm/ADT/SmallVector.h>
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
#include <vector>

namespace glider::codegen {

struct Disassembler::Machine {
  std::unique_ptr<llvm::TargetMachine> target;
  llvm::MCTargetOptions options;
  std::unique_ptr<llvm::MCContext> context;
  std::unique_ptr<llvm::MCDisassembler> reader;
  std::unique_ptr<llvm::MCInstPrinter> printer;
  std::unique_ptr<llvm::MCInstrAnalysis> analysis;
  bool arm = false;
  std::vector<std::pair<uint8_t, llvm::MCRegister>> registers;  // by StackMachine's numbers
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

/// ARM's multiplications, which are plain arithmetic. LLVM rejects those with registers that the
/// manual forbids before ARMv6, but the compiler's arithmetic has some that every ARM9 executes
/// correctly.
bool isMultiplication(llvm::StringRef bytes) {
  constexpr uint32_t kMask = 0x0F0000F0, kMultiply = 0x00000090;
  return bytes.size() >= 4 && (llvm::support::endian::read32le(bytes.data()) & kMask) == kMultiply;
}

/// N of "movl $N, %ecx"; empty for any other instruction.
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

/// The number of a register of the processor; kNone for any other.
uint8_t numberOf(llvm::StringRef name, bool arm) {
  static constexpr std::array<std::string_view, 16> kArm = {"R0",  "R1", "R2", "R3", "R4",  "R5",
                                                            "R6",  "R7", "R8", "R9", "R10", "R11",
                                                            "R12", "SP", "LR", "PC"};
  static constexpr std::array<std::string_view, 8> kX86 = {"EAX", "ECX", "EDX", "EBX",
                                                           "ESP", "EBP", "ESI", "EDI"};
  auto place = [&](const auto& names) {
    const auto found = std::ranges::find(names, std::string_view(name.data(), name.size()));
    return found == names.end() ? StackEffect::kNone : static_cast<uint8_t>(found - names.begin());
  };
  return arm ? place(kArm) : place(kX86);
}

/// The parts of "ldr r3, [pc, #16]", "add r2, pc, r2", "ldr r0, [pc, r3]" and "add r1, pc, #8" that
/// say where something is.
void mentionOfArm(const Written& written, Instruction& one) {
  constexpr uint64_t kAhead = 8;  // of pc
  llvm::SmallVector<llvm::StringRef, 4> parts;
  llvm::StringRef(written.operands.data(), written.operands.size()).split(parts, ", ");
  const bool loads = written.operation.starts_with("ldr"),
             adds = written.operation.starts_with("add");
  if (parts.size() != 3 || !(loads ? parts[1] == "[pc" : adds && parts[1] == "pc")) {
    return;
  }
  llvm::StringRef last = parts[2];
  (void)last.consume_back("]");
  int64_t number = 0;
  if (last.consume_front("#") && !last.getAsInteger(0, number)) {
    one.mentions.numbers[one.mentions.count++] =
        static_cast<uint32_t>(one.address + kAhead + static_cast<uint64_t>(number));
    one.mentions.literal_to = loads ? numberOf(parts[0].upper(), true) : Mentions::kNone;
  }
  one.mentions.pc_plus = numberOf(last.upper(), true);  // a number is not a register
}

void mentionOfX86(const llvm::MCInst& inst, Instruction& one) {
  for (const llvm::MCOperand& operand : inst) {
    if (operand.isImm() && one.mentions.count < one.mentions.numbers.size()) {
      one.mentions.numbers[one.mentions.count++] = static_cast<uint32_t>(operand.getImm());
    }
  }
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

const StackMachine& stackMachine(const platforms::Board& board) {
  const llvm::Triple triple(llvm::Triple::normalize(board.triple));
  return triple.getArch() == llvm::Triple::arm ? kArmStack : kX86Stack;
}

support::Result<std::unique_ptr<Disassembler>> Disassembler::make(const platforms::Board& board) {
  auto target = makeMachine(board, 0, ProgramKind::Executable);
  if (!target) {
    return std::unexpected(target.error());
  }
  const llvm::Triple& triple = (*target)->getTargetTriple();
  if (!knows(board)) {
    return support::fail(support::diagnostics::unsupportedMachine, board.name, board.triple,
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
  const llvm::MCRegisterInfo& registers = *(*target)->getMCRegisterInfo();
  for (unsigned id = 1; id < registers.getNumRegs(); ++id) {
    const uint8_t number = numberOf(registers.getName(id), machine->arm);
    if (number != StackEffect::kNone) {
      machine->registers.emplace_back(number, llvm::MCRegister(id));
    }
  }
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

bool Disassembler::isTrap(llvm::StringRef bytes) const {
  constexpr uint32_t kMask = 0xFFF000F0, kTrap = 0xE7F000F0;
  return machine_->arm && bytes.size() >= 4 &&
         (llvm::support::endian::read32le(bytes.data()) & kMask) == kTrap;
}

/// How many instructions ARM's "cmp r3, #10" and "addls pc, pc, r3, lsl #2" choose from.
void Disassembler::choose(const Written& written, Instruction& one) {
  const auto [place, number] =
      llvm::StringRef(written.operands.data(), written.operands.size()).split(", #");
  if (one.flow == Flow::JumpAhead || one.flow == Flow::JumpAheadIf) {
    constexpr uint64_t kAhead = 8;
    one.target = one.address + kAhead;
    const bool bounded = written.operation == "addls" && !compared_.empty() &&
                         written.operands == "pc, pc, " + compared_ + ", lsl #2";
    one.choices = bounded ? static_cast<uint64_t>(compared_with_) + 1 : 0;
    one.counted_at = compared_at_;
  }
  compared_.clear();
  if (written.operation == "cmp" && !number.getAsInteger(0, compared_with_) &&
      compared_with_ >= 0) {
    compared_ = place.str();
    compared_at_ = one.address;
  }
}

/// x86's switches in position-independent code: their tables contain distances.
void Disassembler::switchByDistance(const Written& written, Instruction& one) {
  const llvm::StringRef operands(written.operands.data(), written.operands.size());
  if (written.operation == "jmpl" && !jumps_by_.empty() && operands == jumps_by_) {
    one.flow = Flow::JumpByTable;
    one.by_distance = true;
    one.target = static_cast<uint32_t>(table_);
    one.counted_at = compared_at_;
  }
  jumps_by_.clear();
  if (written.operation == "addl" && !added_.empty() && operands == added_) {
    jumps_by_ = "*" + operands.take_back(4).str();
  }
  added_.clear();
  // "-8(%ebx,%ecx,4), %ecx"
  const auto [place, to] = operands.split(",4), ");
  const auto [offset, registers] = place.split('(');
  if (written.operation == "movl" && to.size() == 4 && !offset.getAsInteger(0, table_)) {
    added_ = (registers.split(',').first + ", " + to).str();
    compared_at_ = one.address;
  }
}

/// The effect of the instruction on the stack and its registers.
void Disassembler::judgeStack(const llvm::MCInst& inst, const Written& written, Instruction& one) {
  const StackMachine& machine = machine_->arm ? kArmStack : kX86Stack;
  one.stack = machine_->arm ? armStack(written) : x86Stack(written);
  const llvm::MCInstrDesc& about = machine_->target->getMCInstrInfo()->get(inst.getOpcode());
  const llvm::MCRegisterInfo& registers = *machine_->target->getMCRegisterInfo();
  for (const auto& [number, id] : machine_->registers) {
    if (about.hasDefOfPhysReg(inst, id, registers)) {
      one.stack.writes |= static_cast<uint16_t>(1U << number);
    }
  }
  for (const llvm::MCOperand& operand : inst) {
    if (operand.isReg()) {
      const uint8_t number = numberOf(registers.getName(operand.getReg()), machine_->arm);
      if (number < 16) {
        one.mentions.registers |= static_cast<uint16_t>(1U << number);
      }
    }
  }
  const uint32_t writes = one.stack.writes;
  const bool moved = (writes >> machine.pointer & 1U) != 0;
  const bool by_call = !machine_->arm && (one.stack.enters_kernel || one.flow != Flow::Next);
  one.stack.known = !moved || one.stack.to == machine.pointer || by_call;
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
    one.stack.writes = static_cast<uint16_t>(~(1U << kArmStack.pointer));
    if (isTrap(bytes)) {
      one.flow = Flow::Return;
      one.stack.stops = true;
    }
    return one;
  }
  one.size = static_cast<uint32_t>(size);
  std::string line;
  llvm::raw_string_ostream stream(line);
  machine_->printer->printInst(&inst, address, "", *machine_->target->getMCSubtargetInfo(), stream);
  stream.flush();
  const Written written = split(line);
  one.flow = machine_->arm ? armFlow(written) : x86Flow(written);
  judgeStack(inst, written, one);
  if (machine_->arm) {
    mentionOfArm(written, one);
    choose(written, one);
  } else {
    mentionOfX86(inst, one);
    count(written, one);
    switchByDistance(written, one);
  }
  if (!machine_->arm && one.flow == Flow::JumpByTable && !one.by_distance) {
    one.target = tableOf(written);
  }
  if (hasTarget(one.flow) && !machine_->analysis->evaluateBranch(inst, address, size, one.target)) {
    one.flow = Flow::Unknown;
  }
  return one;
}

}  // namespace glider::codegen
