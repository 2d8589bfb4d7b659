// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/codegen.h"
#include "compiler/boards.h"
#include "compiler/compilation.h"
#include "compiler/user_code.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "frontend/ast/print.h"
#include "ir/opt/drop_requirements.h"
#include "ir/opt/optimise.h"
#include "ir/text/c_header.h"
#include "ir/text/print.h"
#include "support/check.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace glider::driver {
namespace {

enum class Emit : uint8_t { Ast, Ir, Header, Llvm, Asm, Obj, Exe };

/// The values of `--emit`.
const std::map<std::string, Emit> kEmits = {
    {"ast", Emit::Ast}, {"ir", Emit::Ir},   {"header", Emit::Header}, {"llvm", Emit::Llvm},
    {"asm", Emit::Asm}, {"obj", Emit::Obj}, {"exe", Emit::Exe}};

struct BuildOptions {
  std::string mission;
  std::string target = "host";
  Emit emit = Emit::Exe;
  unsigned level = 2;
  std::vector<std::string> print_after;
  std::vector<std::string> user_code;
  std::string output;
};

/// The file to write when none is named: beside where the command runs, named after mission and
/// target.
std::string outputName(const BuildOptions& options) {
  const std::string stem = std::filesystem::path(options.mission).stem().string();
  const std::string built = fmt::format("{}-{}", stem, options.target);
  switch (options.emit) {
    case Emit::Ast:
      return stem + ".ast";
    case Emit::Ir:
      return stem + ".ir";
    case Emit::Header:
      return stem + ".h";
    case Emit::Llvm:
      return built + ".ll";
    case Emit::Asm:
      return built + ".s";
    case Emit::Obj:
      return built + ".o";
    case Emit::Exe:
      return built;
  }
  return built;
}

codegen::CodegenOptions codegenOptions(const BuildOptions& options,
                                       const compiler::Compilation& compilation) {
  codegen::CodegenOptions result;
  result.optimisation_level = static_cast<int>(options.level);
  result.sources = &compilation.sources;
  result.last_link = true;
  return result;
}

/// The product of every stage but the last as text or bytes.
support::Result<std::string> produce(const BuildOptions& options,
                                     const compiler::Compilation& compilation) {
  if (options.emit == Emit::Ast) {
    if (!compilation.ast) {
      return support::fail(support::DiagnosticId::noSyntaxTree, options.mission);
    }
    return ast::print(*compilation.ast);
  }
  if (options.emit == Emit::Ir) {
    return ir::print(*compilation.mission);
  }
  if (options.emit == Emit::Header) {
    return ir::printHeader(compilation.in_c, compilation.mission->name);
  }
  const auto board = compiler::loadTarget(options.target);
  if (!board) {
    return std::unexpected(board.error());
  }
  const auto code = compiler::loadUserCode(options.user_code, compilation, *board);
  if (!code) {
    return std::unexpected(code.error());
  }
  codegen::CodegenOptions how = codegenOptions(options, compilation);
  code->addTo(how);
  switch (options.emit) {
    case Emit::Llvm:
      return codegen::emitLlvm(*compilation.mission, compilation.facts, *board, how);
    case Emit::Asm:
      return codegen::emitAssembly(*compilation.mission, compilation.facts, *board, how);
    case Emit::Exe:
      return codegen::linkForStream(*compilation.mission, compilation.facts, *board, how);
    case Emit::Obj:
      return codegen::emitObject(*compilation.mission, compilation.facts, *board, how);
    case Emit::Ast:
    case Emit::Ir:
    case Emit::Header:
      break;
  }
  CHECK(false, "not made by codegen");
}

support::Result<void> buildProduct(const BuildOptions& options,
                                   const compiler::Compilation& compilation) {
  const auto product = produce(options, compilation);
  if (!product) {
    return std::unexpected(product.error());
  }
  if (options.output == "-") {
    return printOut(*product);
  }
  return support::writeFileAtomically(options.output, *product, support::FileKind::Product);
}

support::Result<void> buildExecutable(const BuildOptions& options,
                                      const compiler::Compilation& compilation) {
  const auto board = compiler::loadTarget(options.target);
  if (!board) {
    return std::unexpected(board.error());
  }
  const auto code = compiler::loadUserCode(options.user_code, compilation, *board);
  if (!code) {
    return std::unexpected(code.error());
  }
  codegen::CodegenOptions how = codegenOptions(options, compilation);
  code->addTo(how);
  return codegen::linkExecutable(*compilation.mission, compilation.facts, *board, how,
                                 options.output);
}

/// True if the build would write over a file that it reads.
bool overwritesInput(const BuildOptions& options) {
  std::error_code error;  // a file that is not there yet is not the mission
  std::vector<std::string> inputs = options.user_code;
  inputs.push_back(options.mission);
  const auto isInput = [&](const std::string& file) {
    return std::ranges::any_of(inputs, [&](const std::string& input) {
      return std::filesystem::equivalent(file, input, error) && !error;
    });
  };
  return isInput(options.output) ||
         (options.emit == Emit::Exe && isInput(options.output + ".debug"));
}

/// Runs the passes over the IR, and prints it to standard error after those that `--print-after`
/// names.
void optimiseIr(const BuildOptions& options, compiler::Compilation& compilation) {
  if (options.level == 0) {
    if (options.emit != Emit::Ir) {
      ir::dropRequirements(*compilation.mission);
    }
    return;
  }
  ir::optimise(*compilation.mission, [&](const ir::OptPass& pass, const ir::Mission& mission) {
    if (std::ranges::find(options.print_after, pass.name) != options.print_after.end()) {
      fmt::print(stderr, "# after {}\n{}", pass.name, ir::print(mission));
    }
  });
}

int build(BuildOptions options) {
  // The target first: a typing error there should not cost a compilation.
  if (const auto board = compiler::loadTarget(options.target); !board) {
    return reportFailure(board.error());
  }
  auto compiled = compiler::compileMission(options.mission);
  if (!compiled) {
    return reportFailure(compiled.error());
  }
  compiler::Compilation& compilation = **compiled;
  reportDiagnostics(compilation.diagnostics, compilation.sources);
  if (!compilation.ok()) {
    return kMissionHasErrors;
  }
  optimiseIr(options, compilation);
  options.output = options.output.empty() ? outputName(options) : options.output;
  if (overwritesInput(options)) {
    return reportFailure(
        support::fail(support::DiagnosticId::outputIsInput, options.output).error());
  }
  const bool executable = options.emit == Emit::Exe && options.output != "-";
  const auto built =
      executable ? buildExecutable(options, compilation) : buildProduct(options, compilation);
  return built ? kFine : reportFailure(built.error());
}

}  // namespace

void addBuildCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<BuildOptions>();
  CLI::App* command =
      app.add_subcommand("build", "Compile a mission for the computer in the payload bay");
  command
      ->add_option("MISSION", options->mission, "The mission file (or the IR's text form, FILE.ir)")
      ->required();
  command
      ->add_option("--target", options->target,
                   "Target to build for, as listed by `glidercc targets`")
      ->capture_default_str();
  command
      ->add_option_function<std::string>(
          "--emit", [options](const std::string& stage) { options->emit = kEmits.at(stage); },
          "Output to write: ast, ir, header (C declarations of the mission), llvm, asm, obj or exe "
          "[exe]")
      ->check(CLI::IsMember(
          std::vector<std::string>{"ast", "ir", "header", "llvm", "asm", "obj", "exe"}))
      ->option_text("STAGE");
  command->add_option("-O", options->level, "Optimisation level, 0 to 3")
      ->check(CLI::Range(0, 3))
      ->capture_default_str();
  std::vector<std::string> passes;
  for (const ir::OptPass& pass : ir::optPasses()) {
    passes.emplace_back(pass.name);
  }
  command
      ->add_option("--print-after", options->print_after,
                   "Print the IR to standard error after a pass: " +
                       fmt::format("{}", fmt::join(passes, ", ")) + " (not at -O0)")
      ->check(CLI::IsMember(passes))
      ->option_text("PASS ...");
  addLinkOption(*command, options->user_code);
  command->add_option("-o", options->output, "Output file; `-` is standard output")
      ->option_text("FILE");
  command->callback([options, &status] { status = build(*options); });
}

}  // namespace glider::driver
