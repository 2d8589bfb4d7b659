// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/bitcode.h"

#include "codegen/llvm/program/emit.h"
#include "codegen/llvm/program/optimise.h"
#include "codegen/llvm/program/program.h"
#include "codegen/llvm/target/machine.h"
#include "codegen/llvm/user_code/machine_check.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"

#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/DiagnosticPrinter.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Verifier.h>
#include <llvm/Support/ErrorHandling.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/raw_ostream.h>

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

/// The data of the child process of `compileApart`.
struct BitcodeWork {
  llvm::Module& module;
  llvm::TargetMachine& machine;
  std::filesystem::path object;
  std::filesystem::path said;
};

[[noreturn]] void giveUp(const BitcodeWork& work, std::string_view why) {
  // If the reason cannot be written, the parent has a text of its own.
  static_cast<void>(support::writeFileAtomically(work.said, why));
  ::_exit(EXIT_FAILURE);
}

void onFatal(void* work, const char* why, bool /*crash*/) {
  giveUp(*static_cast<const BitcodeWork*>(work), why);
}

void onDiagnostic(const llvm::DiagnosticInfo* info, void* work) {
  if (info->getSeverity() == llvm::DS_Error) {
    std::string text;
    llvm::raw_string_ostream stream(text);
    llvm::DiagnosticPrinterRawOStream printer(stream);
    info->print(printer);
    giveUp(*static_cast<const BitcodeWork*>(work), stream.str());
  }
}

[[noreturn]] void compileAndExit(BitcodeWork& work) {
  llvm::install_fatal_error_handler(onFatal, &work);
  work.module.getContext().setDiagnosticHandlerCallBack(onDiagnostic, &work);
  optimise(work.module, work.machine, kUserCodeLevel);
  const std::string object = emitCode(work.module, work.machine, llvm::CodeGenFileType::ObjectFile);
  const bool written = support::writeFileAtomically(work.object, object).has_value();
  ::_exit(written ? EXIT_SUCCESS : EXIT_FAILURE);
}

/// Runs in a child of this process: LLVM ends the process on some errors, and this input comes from
/// the user.
bool compileApart(BitcodeWork& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    compileAndExit(work);
  }
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

/// Gives the module the machine of the board.
void adopt(llvm::Module& module, const llvm::TargetMachine& machine) {
  module.setTargetTriple(machine.getTargetTriple().str());
  module.setDataLayout(machine.createDataLayout());
  forgetMachine(module);
}

}  // namespace

Result<std::string> compileBitcode(const std::string& name, const std::string& content,
                                   const Board& board, const ScratchFolder& scratch) {
  llvm::LLVMContext context;
  auto module = llvm::parseBitcodeFile({content, name}, context);
  if (!module) {
    return support::fail(support::diagnostics::bitcodeRefused, name, board.name,
                         llvm::toString(module.takeError()));
  }
  const std::string wanted = machineOf(board.triple);
  if (const std::string found = machineOf((*module)->getTargetTriple()); found != wanted) {
    return support::fail(support::diagnostics::wrongMachine, name, found, board.name, wanted);
  }
  // Position-independent, both for a board's program and for one that flies in process.
  auto machine = makeMachine(board, kUserCodeLevel, ProgramKind::Executable);
  if (!machine) {
    return std::unexpected(machine.error());
  }
  std::string fault;
  llvm::raw_string_ostream stream(fault);
  if (llvm::verifyModule(**module, &stream)) {
    return support::fail(support::diagnostics::bitcodeRefused, name, board.name, stream.str());
  }
  adopt(**module, **machine);
  BitcodeWork work{**module, **machine, scratch.path() / "compiled.o", scratch.path() / "refused"};
  if (!compileApart(work)) {
    const std::string why = support::readFile(work.said).value_or("");
    return support::fail(support::diagnostics::bitcodeRefused, name, board.name,
                         why.empty() ? "its compilation ended without a message" : why);
  }
  return support::readFile(work.object);
}

}  // namespace glider::codegen
