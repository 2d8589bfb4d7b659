// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/codegen.h"
#include "compiler/boards.h"
#include "compiler/compilation.h"
#include "compiler/user_code.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/emit.h"
#include "driver/output/symbols.h"
#include "driver/shared_options.h"
#include "driver/terminal.h"
#include "frontend/ast/print.h"
#include "ir/text/c_header.h"
#include "ir/text/print.h"
#include "support/check.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace glider::driver {
namespace {

struct BuildOptions {
  std::string mission;
  std::string target = "host";
  Emit emit = Emit::Exe;
  unsigned level = 2;
  std::vector<std::string> print_after;
  std::vector<std::string> user_code;
  std::string output;
  std::string at;  ///< of the symbols: `LINE:COLUMN`; empty: all
};

/// The file to write when none is named: beside where the command runs, named after mission and
/// target.
std::string outputName(const BuildOptions& options) {
  const std::string stem = std::filesystem::path(options.mission).stem().string();
  const std::string built = needsTarget(options.emit) ? stem + "-" + options.target : stem;
  return built + std::string(suffixOf(options.emit));
}

codegen::CodegenOptions codegenOptions(const BuildOptions& options,
                                       const compiler::Optimised& mission) {
  codegen::CodegenOptions result;
  result.optimisation_level = static_cast<int>(options.level);
  result.sources = &mission.sources();
  result.last_link = true;
  return result;
}

/// What an early stage has made, as text. Of the IR: of the mission with its requirements if no
/// pass is to run.
support::Result<std::string> printStage(const BuildOptions& options,
                                        const compiler::Compilation& compilation,
                                        const compiler::Optimised& mission) {
  const compiler::Lowered& lowered = *compilation.lowered;
  switch (options.emit) {
    case Emit::Ast:
      return compilation.parsed
                 ? support::Result<std::string>(ast::print(compilation.parsed->mission))
                 : support::fail(support::DiagnosticId::noSyntaxTree, options.mission);
    case Emit::Ir:
      return ir::print(options.level == 0 ? lowered.mission : mission.mission);
    case Emit::Header:
      return ir::printHeader(lowered.in_c, lowered.mission.name);
    case Emit::Symbols:
    case Emit::Llvm:
    case Emit::Asm:
    case Emit::Obj:
    case Emit::Exe:
      break;
  }
  CHECK(false, "no early stage");
}

/// What the code generator makes of a mission, without a file of its own.
support::Result<std::string> generate(Emit emit, const codegen::Input& input,
                                      const platforms::Board& board,
                                      const codegen::CodegenOptions& how) {
  switch (emit) {
    case Emit::Llvm:
      return codegen::emitLlvm(input, board, how);
    case Emit::Asm:
      return codegen::emitAssembly(input, board, how);
    case Emit::Obj:
      return codegen::emitObject(input, board, how);
    case Emit::Exe:
      return codegen::linkForStream(input, board, how);
    case Emit::Ast:
    case Emit::Symbols:
    case Emit::Ir:
    case Emit::Header:
      break;
  }
  CHECK(false, "not made by the code generator");
}

support::Result<void> writeProduct(const BuildOptions& options,
                                   const support::Result<std::string>& product) {
  if (!product) {
    return std::unexpected(product.error());
  }
  return options.output == "-"
             ? printOut(*product)
             : support::writeFileAtomically(options.output, *product, support::FileKind::Product);
}

support::Result<void> buildForTarget(const BuildOptions& options,
                                     const compiler::Optimised& mission) {
  const auto board = compiler::loadTarget(options.target);
  if (!board) {
    return std::unexpected(board.error());
  }
  const auto code = compiler::loadUserCode(options.user_code, mission.mission, *board);
  if (!code) {
    return std::unexpected(code.error());
  }
  codegen::CodegenOptions how = codegenOptions(options, mission);
  code->addTo(how);
  if (options.emit == Emit::Exe && options.output != "-") {
    return codegen::linkExecutable(mission.input(), *board, how, options.output);
  }
  return writeProduct(options, generate(options.emit, mission.input(), *board, how));
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

/// The mission as it is built; the IR is printed to standard error after the passes that
/// `--print-after` names.
compiler::Optimised optimise(const BuildOptions& options,
                             const std::shared_ptr<const compiler::Checked>& checked) {
  if (options.level == 0) {
    return compiler::withoutPasses(checked);
  }
  return compiler::optimise(checked, [&](const ir::OptPass& pass, const ir::Mission& mission) {
    if (std::ranges::find(options.print_after, pass.name) != options.print_after.end()) {
      fmt::print(stderr, "# after {}\n{}", pass.name, ir::print(mission));
    }
  });
}

support::Result<void> write(const BuildOptions& options, const compiler::Compilation& compilation) {
  if (options.emit == Emit::Symbols) {
    return writeProduct(options, printSymbols(compilation, options.at));
  }
  const compiler::Optimised mission = optimise(options, compilation.checked);
  return needsTarget(options.emit)
             ? buildForTarget(options, mission)
             : writeProduct(options, printStage(options, compilation, mission));
}

int build(BuildOptions options) {
  // The target first: a typing error there should not cost a compilation.
  if (const auto board = compiler::loadTarget(options.target); !board) {
    return reportFailure(board.error());
  }
  const auto compiled = compiler::compileMission(options.mission);
  if (!compiled) {
    return reportFailure(compiled.error());
  }
  reportDiagnostics(compiled->diagnostics, *compiled->sources);
  if (!compiled->checked && options.emit != Emit::Symbols) {
    return kMissionHasErrors;
  }
  options.output = options.output.empty() ? outputName(options) : options.output;
  if (overwritesInput(options)) {
    return reportFailure(
        support::fail(support::DiagnosticId::outputIsInput, options.output).error());
  }
  const auto written = write(options, *compiled);
  return !written ? reportFailure(written.error()) : compiled->checked ? kFine : kMissionHasErrors;
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
          "--emit", [options](const std::string& stage) { options->emit = emitOf(stage); },
          "Output to write: ast, symbols (JSON for editors: the names of the mission and where "
          "they "
          "are used, also of a mission with errors), ir, header (C declarations of the mission), "
          "llvm, asm, obj or exe [exe]")
      ->check(CLI::IsMember(emitWords()))
      ->option_text("STAGE");
  command
      ->add_option("--at", options->at,
                   "With --emit symbols: write only the name at this position of MISSION, and the "
                   "names that can be used there")
      ->check(CLI::Validator(checkPlace, "", "place"))
      ->option_text("LINE:COLUMN");
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
  command
      ->add_option("-o", options->output,
                   "Output file; `-` is standard output [named after MISSION]")
      ->option_text("FILE");
  command->callback([options, &status] {
    if (!options->at.empty() && options->emit != Emit::Symbols) {
      throw CLI::ValidationError("--at", "is for --emit symbols only");
    }
    status = build(*options);
  });
}

}  // namespace glider::driver
