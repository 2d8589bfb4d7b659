// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/program/program.h"

#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/IR/DiagnosticHandler.h>
#include <llvm/IR/DiagnosticInfo.h>
#include <llvm/IR/DiagnosticPrinter.h>
#include <llvm/Linker/Linker.h>
#include <llvm/Support/Error.h>
#include <llvm/Support/MemoryBuffer.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Transforms/IPO/Internalize.h>

#include <algorithm>

#include "support/files.h"

namespace glider::codegen {
namespace {

/// Gathers what LLVM says instead of letting it write to the terminal.
class Listener final : public llvm::DiagnosticHandler {
 public:
  explicit Listener(std::string& text) : text_(text) {}
  bool handleDiagnostics(const llvm::DiagnosticInfo& info) override {
    if (info.getSeverity() == llvm::DS_Error) {
      llvm::raw_string_ostream stream(text_);
      llvm::DiagnosticPrinterRawOStream printer(stream);
      info.print(printer);
    }
    return true;
  }

 private:
  std::string& text_;
};

/// Declares `name` as something undefined, so that linking brings its definition in.
void wantSymbol(llvm::Module& module, const std::string& name) {
  if (module.getNamedValue(name) == nullptr) {
    llvm::Function::Create(llvm::FunctionType::get(llvm::Type::getVoidTy(module.getContext()), false),
                           llvm::GlobalValue::ExternalLinkage, name, module);
  }
}

}  // namespace

support::Result<void> joinRuntime(llvm::Module& mission, const std::filesystem::path& runtime_file,
                                  const std::vector<std::string>& visible) {
  const std::string path = runtime_file.string();
  auto bitcode = support::readFile(path);
  if (!bitcode) {
    return std::unexpected(bitcode.error());
  }
  std::string trouble;
  llvm::LLVMContext& context = mission.getContext();
  context.setDiagnosticHandler(std::make_unique<Listener>(trouble));
  auto runtime = llvm::getOwningLazyBitcodeModule(
      llvm::MemoryBuffer::getMemBufferCopy(*bitcode, path), context);
  if (!runtime) {
    return support::fail(support::DiagnosticId::badRuntime, path,
                         llvm::toString(runtime.takeError()));
  }
  for (const std::string& name : visible) {
    wantSymbol(mission, name);
  }
  if (llvm::Linker::linkModules(mission, std::move(*runtime), llvm::Linker::LinkOnlyNeeded)) {
    return support::fail(support::DiagnosticId::badRuntime, path, trouble);
  }
  for (const std::string& name : visible) {
    if (mission.getNamedValue(name)->isDeclaration()) {
      return support::fail(support::DiagnosticId::badRuntime, path,
                           "it does not define `" + name + "`");
    }
  }
  llvm::internalizeModule(mission, [&](const llvm::GlobalValue& value) {
    return std::ranges::find(visible, value.getName()) != visible.end();
  });
  return {};
}

}  // namespace glider::codegen
