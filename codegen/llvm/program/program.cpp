// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/program/program.h"

#include "support/diagnostics/ids/command.h"
#include "support/files.h"

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
#include <memory>
#include <set>

namespace glider::codegen {
namespace {

/// Collects LLVM's messages instead of letting it write to the terminal.
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

/// Collects the messages of a context for its own lifetime.
class Listening {
 public:
  explicit Listening(llvm::LLVMContext& context) : context_(context) {
    context.setDiagnosticHandler(std::make_unique<Listener>(heard_));
  }
  ~Listening() { context_.setDiagnosticHandler(std::make_unique<llvm::DiagnosticHandler>()); }
  Listening(const Listening&) = delete;
  Listening& operator=(const Listening&) = delete;
  [[nodiscard]] const std::string& heard() const { return heard_; }

 private:
  llvm::LLVMContext& context_;
  std::string heard_;
};

/// Declares `name` as undefined, so that linking brings its definition in.
void wantSymbol(llvm::Module& module, const std::string& name) {
  if (module.getNamedValue(name) == nullptr) {
    llvm::Function::Create(
        llvm::FunctionType::get(llvm::Type::getVoidTy(module.getContext()), false),
        llvm::GlobalValue::ExternalLinkage, name, module);
  }
}

/// Adds what `mission` needs of the bitcode file `part`, or with the flags None all of it.
support::Result<void> joinPart(llvm::Module& mission, const std::string& part,
                               const std::string& trouble,
                               unsigned flags = llvm::Linker::LinkOnlyNeeded) {
  auto bitcode = support::readFile(part);
  if (!bitcode) {
    return std::unexpected(bitcode.error());
  }
  auto module = llvm::getOwningLazyBitcodeModule(
      llvm::MemoryBuffer::getMemBufferCopy(*bitcode, part), mission.getContext());
  if (!module) {
    return support::fail(support::diagnostics::badRuntime, part,
                         llvm::toString(module.takeError()));
  }
  if (llvm::Linker::linkModules(mission, std::move(*module), flags)) {
    return support::fail(support::diagnostics::badRuntime, part, trouble);
  }
  return {};
}

}  // namespace

void forgetMachine(llvm::Module& module) {
  for (llvm::Function& function : module) {
    for (const char* attribute : {"target-cpu", "target-features", "tune-cpu"}) {
      function.removeFnAttr(attribute);
    }
  }
}

support::Result<void> importRuntime(llvm::Module& mission, const std::filesystem::path& part) {
  std::set<const llvm::Function*> own;
  for (const llvm::Function& function : mission) {
    if (!function.isDeclaration()) {
      own.insert(&function);
    }
  }
  const Listening listening(mission.getContext());
  if (auto joined = joinPart(mission, part.string(), listening.heard()); !joined) {
    return joined;
  }
  forgetMachine(mission);
  for (llvm::Function& function : mission) {
    if (function.hasExternalLinkage() && !function.isDeclaration() && !own.contains(&function)) {
      function.setLinkage(llvm::GlobalValue::AvailableExternallyLinkage);
    }
  }
  return {};
}

support::Result<void> joinRuntime(llvm::Module& mission,
                                  const std::vector<std::filesystem::path>& parts,
                                  const std::vector<std::string>& visible,
                                  const std::vector<std::filesystem::path>& whole) {
  const Listening listening(mission.getContext());
  for (const std::string& name : visible) {
    wantSymbol(mission, name);
  }
  for (const std::filesystem::path& part : whole) {
    if (auto joined =
            joinPart(mission, part.string(), listening.heard(), llvm::Linker::Flags::None);
        !joined) {
      return joined;
    }
  }
  for (const std::filesystem::path& part : parts) {
    if (auto joined = joinPart(mission, part.string(), listening.heard()); !joined) {
      return joined;
    }
  }
  for (const std::string& name : visible) {
    if (mission.getNamedValue(name)->isDeclaration()) {
      return support::fail(support::diagnostics::badRuntime, parts.back().string(),
                           "it does not define `" + name + "`");
    }
  }
  forgetMachine(mission);
  llvm::internalizeModule(mission, [&](const llvm::GlobalValue& value) {
    return std::ranges::find(visible, value.getName()) != visible.end();
  });
  return {};
}

}  // namespace glider::codegen
