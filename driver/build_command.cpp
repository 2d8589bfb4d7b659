// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/mission_budget.h"
#include "codegen/codegen.h"
#include "compiler/boards.h"
#include "compiler/compilation.h"
#include "compiler/proving.h"
#include "compiler/user_code.h"
#include "driver/commands.h"
#include "driver/compile_for_flight.h"
#include "driver/exit_code.h"
#include "driver/output/executable.h"
#include "driver/output/overwritten.h"
#include "driver/output/symbols.h"
#include "driver/output/validation.h"
#include "driver/shared_options.h"
#include "driver/slocum/port_folder.h"
#include "driver/terminal.h"
#include "driver/usage/quantity.h"
#include "driver/usage/values.h"
#include "frontend/ast/print.h"
#include "ir/text/print.h"
#include "support/diagnostics/ids/command.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glider::driver {
namespace {

/// Products of the front end, which no back end sees.
constexpr codegen::Product kSyntaxTree{.name = "ast", .suffix = ".ast"};
constexpr codegen::Product kSymbols{
    .name = "symbols",
    .suffix = ".symbols.json",
    .note =
        "JSON for editors: the names of the mission and where they are used, even if the mission "
        "has errors"};
/// The prover's questions.
constexpr codegen::Product kChc{
    .name = "chc",
    .suffix = ".smt2",
    .note = "the questions about its requirements, as constrained Horn clauses in SMT-LIB 2"};
constexpr const codegen::Product* kOfTheFrontEnd[] = {&kSyntaxTree, &kSymbols, &kChc};

constexpr const char* kPortDialect = "extctl";
constexpr const char* kExecutable = "exe";
/// Above, mission and runtime are optimised as one program.
constexpr unsigned kMostValidatedLevel = 2;

struct BuildOptions {
  bool strict = false;  ///< warnings are errors
  std::string mission;
  std::string target = kUsualTarget;
  std::string emit = kExecutable;
  unsigned level = kUsualLevel;
  std::vector<std::string> print_after;
  std::vector<std::string> user_code;
  std::string output;
  std::string dialect = "hooks";
  PortOptions port;       ///< of dialect extctl
  bool validate = false;  ///< the code is compared with the mission
  std::string at;         ///< of the symbols: `LINE:COLUMN`; empty: all
};

/// What `--emit` can name; with a `board`, for that board only.
std::vector<const codegen::Product*> emitted(const platforms::Board* board = nullptr) {
  std::vector<const codegen::Product*> all = codegen::products();
  if (board != nullptr) {
    std::erase_if(all, [&](const codegen::Product* product) {
      return codegen::findProduct(product->name, *board) == nullptr;
    });
  }
  all.insert(all.begin(), std::begin(kOfTheFrontEnd), std::end(kOfTheFrontEnd));
  return all;
}

std::vector<std::string> namesOf(const std::vector<const codegen::Product*>& products) {
  std::vector<std::string> names;
  for (const codegen::Product* product : products) {
    names.emplace_back(product->name);
  }
  return names;
}

/// All values of `--emit` with their notes: "a, b (note) or c".
std::string emittedInWords() {
  std::vector<std::string> values;
  for (const codegen::Product* product : emitted()) {
    values.push_back(product->note.empty() ? std::string(product->name)
                                           : fmt::format("{} ({})", product->name, product->note));
  }
  const std::string last = values.back();
  values.pop_back();
  return fmt::format("{} or {}", fmt::join(values, ", "), last);
}

/// The product that `--emit` names, made for `board`. Throws CLI11's exception for a usage error if
/// no back end makes it for that board.
const codegen::Product& chosenProduct(const BuildOptions& options, const platforms::Board& board) {
  for (const codegen::Product* product : kOfTheFrontEnd) {
    if (options.emit == product->name) {
      return *product;
    }
  }
  const codegen::Product* product = codegen::findProduct(options.emit, board);
  if (product == nullptr) {
    throw CLI::ValidationError(
        "--emit", fmt::format("{} cannot be made for target {}; it can be {}", options.emit,
                              board.name, fmt::join(namesOf(emitted(&board)), ", ")));
  }
  return *product;
}

support::Result<std::string> printSyntaxTree(const BuildOptions& options,
                                             const compiler::Compilation& compilation) {
  return compilation.parsed ? support::Result<std::string>(ast::print(compilation.parsed->mission))
                            : support::fail(support::diagnostics::noSyntaxTree, options.mission);
}

support::Result<void> writeText(const BuildOptions& options,
                                const support::Result<std::string>& text) {
  if (!text) {
    return std::unexpected(text.error());
  }
  return options.output == "-"
             ? printOut(*text)
             : support::writeFileAtomically(options.output, *text, support::FileKind::Product);
}

support::Result<void> writeProduct(const codegen::Product& product, const BuildOptions& options,
                                   const codegen::Input& input, const platforms::Board& board,
                                   const codegen::CodegenOptions& how) {
  if (options.output != "-") {
    return codegen::writeProduct(product, input, board, how, options.output);
  }
  const auto content = product.make(input, board, how);
  return content ? printOut(*content) : std::unexpected(content.error());
}

support::Result<void> buildProduct(const codegen::Product& product, const BuildOptions& options,
                                   const platforms::Board& board,
                                   const compiler::Optimised& mission) {
  codegen::CodegenOptions how = buildOptions(mission, options.level);
  if (!product.for_board) {
    return writeProduct(product, options, mission.input(), board, how);
  }
  const auto code = compiler::loadUserCode(options.user_code, mission.mission, board);
  if (!code) {
    return std::unexpected(code.error());
  }
  code->addTo(how);
  if (!options.port.ignore_limits) {
    how.accepts = analysis::onlyWhatFits(board, mission);
  }
  if (options.validate) {
    how.validated = [&](const codegen::Validation& validation) {
      return reportValidation(validation, board.name, options.strict);
    };
  }
  return writeProduct(product, options, mission.input(), board, how);
}

/// The first file that the build reads and would overwrite.
std::optional<std::string> overwrittenBy(const BuildOptions& options,
                                         const codegen::Product& product) {
  std::vector<std::string> inputs = options.user_code;
  inputs.push_back(options.mission);
  const std::string beside =
      product.beside.empty() ? "" : options.output + std::string(product.beside);
  return overwrittenInput(inputs, {options.output, beside});
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

/// Shows a failure; a mission that needs more than its board has is at fault itself.
int failed(const support::Failure& failure) {
  const int status = reportFailure(failure);
  return failure.id == support::diagnostics::boardOverloaded ? kMissionHasErrors : status;
}

/// The folder for a vehicle without the hooks.
int buildForPort(const BuildOptions& options, const platforms::Board& board,
                 const compiler::Compilation& compilation) {
  const compiler::Optimised mission = optimise(options, compilation.checked);
  const auto written = writePortFolder(options.port, options.output, options.mission, board,
                                       options.user_code, mission);
  return !written ? failed(written.error()) : *written ? kFine : kMissionHasErrors;
}

support::Result<void> write(const codegen::Product& product, const BuildOptions& options,
                            const platforms::Board& board,
                            const compiler::Compilation& compilation) {
  if (&product == &kSymbols) {
    return writeText(options, printSymbols(compilation, options.at));
  }
  if (&product == &kChc) {
    return writeText(options, compiler::chcText(*compilation.checked));
  }
  const compiler::Optimised mission = optimise(options, compilation.checked);
  return &product == &kSyntaxTree ? writeText(options, printSyntaxTree(options, compilation))
                                  : buildProduct(product, options, board, mission);
}

int build(BuildOptions options) {
  // The target first: a typing error there should not cost the time of a compilation.
  const auto board = compiler::loadTarget(options.target);
  if (!board) {
    return reportFailure(board.error());
  }
  const codegen::Product& product = chosenProduct(options, *board);
  const auto compiled = compiler::compileMission(options.mission);
  if (!compiled) {
    return reportFailure(compiled.error());
  }
  const compiler::Compilation& compilation = *compiled;
  reportDiagnostics(compilation.diagnostics, *compilation.sources);
  const bool refused = options.strict && hasWarnings(compilation.diagnostics);
  if ((!compilation.checked || refused) && &product != &kSymbols) {
    return kMissionHasErrors;
  }
  if (options.dialect == kPortDialect) {
    return buildForPort(options, *board, compilation);
  }
  if (options.output.empty()) {
    options.output =
        builtName(options.mission, product.for_board ? options.target : "", product.suffix);
  }
  if (const auto input = overwrittenBy(options, product)) {
    return reportFailure(support::fail(support::diagnostics::outputIsInput, *input).error());
  }
  const auto written = write(product, options, *board, compilation);
  return !written ? failed(written.error()) : compilation.checked ? kFine : kMissionHasErrors;
}

}  // namespace

namespace {

/// Only a program is compared, and not one that is optimised together with the runtime.
void checkValidate(const BuildOptions& options) {
  if (!options.validate) {
    return;
  }
  if (options.emit != kExecutable || options.dialect == kPortDialect) {
    throw CLI::ValidationError("--validate", "is for programs that speak to the hooks only");
  }
  if (options.level > kMostValidatedLevel) {
    throw CLI::ValidationError("--validate", "is for -O 0 to 2 only");
  }
}

/// What the vehicle speaks to the SBC.
void addDialectOptions(CLI::App& command, BuildOptions& options) {
  CLI::Option* dialect =
      command
          .add_option("--dialect", options.dialect,
                      "What the vehicle speaks: hooks (hookprog and hookbeh are built into it), or "
                      "extctl (its port for a backseat driver: -o names a folder for all files)")
          ->check(oneOf({"hooks", kPortDialect}))
          ->capture_default_str();
  command
      .add_option("--release", options.port.release,
                  "With --dialect extctl: how the vehicle's software reads start_when: 10.05, or "
                  "mission-mode (15 is a bit of u_mission_mode)")
      ->check(oneOf({"10.05", "mission-mode"}))
      ->capture_default_str()
      ->needs(dialect);
  addDepthOption(
      command, "--max-depth", options.port.greatest_depth_m, 5, 2000,
      "With --dialect extctl: the program refuses deeper targets, and the vehicle aborts "
      "some metres below [the deepest that MISSION commands; at most what the vehicle can]")
      ->needs(dialect);
  addDurationOption(command, "--surface-after", options.port.surface_after_s,
                    slocum::kLeastSurfaceAfter, slocum::kMostSurfaceAfter,
                    "With --dialect extctl: without contact for this long the vehicle comes up by "
                    "itself [4h]");
  command
      .add_option("--port-sensors", options.port.sensors,
                  "With --dialect extctl: how many sensors the port takes, 32 or 64 [32]")
      ->check(CLI::IsMember({32, 64}))
      ->option_text("N")
      ->needs(dialect);
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
      ->type_name("TARGET")
      ->capture_default_str();
  command->add_option("--emit", options->emit, "Output to write: " + emittedInWords() + " [exe]")
      ->check(oneOf(namesOf(emitted())))
      ->option_text("STAGE");
  command
      ->add_option("--at", options->at,
                   "With --emit symbols: write only the name at this position of MISSION, and the "
                   "names that can be used there")
      ->check(CLI::Validator(checkPlace, "", "place"))
      ->option_text("LINE:COLUMN");
  command->add_option("-O", options->level, "Optimisation level, 0 to 3 [2]")
      ->check(CLI::Range(0, 3))
      ->option_text("LEVEL");
  std::vector<std::string> passes;
  for (const ir::OptPass& pass : ir::optPasses()) {
    passes.emplace_back(pass.name);
  }
  command
      ->add_option("--print-after", options->print_after,
                   "Print the IR to standard error after a pass: " +
                       fmt::format("{}", fmt::join(passes, ", ")) + " (not at -O0)")
      ->check(oneOf(passes))
      ->option_text("PASS ...");
  command->add_flag("--ignore-limits", options->port.ignore_limits,
                    "Build it even if it may need more than the board has (GL4013)");
  command->add_flag("--validate", options->validate,
                    "Prove that the code does in every tick what MISSION says, for all readings; "
                    "write nothing if it does not");
  command->add_flag("--strict", options->strict,
                    "Exit with 1 also for warnings, and write nothing then");
  addLinkOption(*command, options->user_code);
  command
      ->add_option("-o", options->output,
                   "Output file; `-` is standard output [named after MISSION]")
      ->option_text("FILE");
  addDialectOptions(*command, *options);
  command->callback([options, &status] {
    if (options->dialect == kPortDialect && options->output.empty()) {
      throw CLI::RequiredError("-o FOLDER (with --dialect extctl)");
    }
    if (!options->at.empty() && options->emit != kSymbols.name) {
      throw CLI::ValidationError("--at", "is for --emit symbols only");
    }
    checkValidate(*options);
    status = build(*options);
  });
}

}  // namespace glider::driver
