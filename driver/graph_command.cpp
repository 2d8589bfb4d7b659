// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/graph_of.h"
#include "compiler/compilation.h"
#include "compiler/proving.h"
#include "driver/commands.h"
#include "driver/exit_code.h"
#include "driver/output/executable.h"
#include "driver/output/overwritten.h"
#include "driver/terminal.h"
#include "driver/usage/values.h"
#include "ir/verify/promela.h"
#include "support/counted.h"
#include "support/diagnostics/ids/command.h"
#include "support/files.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>

namespace glider::driver {
namespace {

enum class GraphFormat : uint8_t { Svg, Dot, Json, Promela };

/// The values of `--format`.
const std::map<std::string, GraphFormat> kGraphFormats = {{"svg", GraphFormat::Svg},
                                                          {"dot", GraphFormat::Dot},
                                                          {"json", GraphFormat::Json},
                                                          {"promela", GraphFormat::Promela}};

struct GraphOptions {
  std::string mission;
  GraphFormat format = GraphFormat::Svg;
  bool deepest = false;
  std::string output;
};

using DeadCases = std::map<ir::CasePlace, bool>;

std::string draw(const GraphOptions& options, const compiler::Compilation& compilation,
                 const DeadCases& dead) {
  const compiler::Lowered& mission = *compilation.lowered;
  if (options.format == GraphFormat::Promela) {
    return ir::promela(mission.mission);
  }
  const report::Graph graph = analysis::graphOf(
      mission,
      compilation.checked ? compilation.checked->facts.deepest_path : std::vector<ir::StateId>(),
      dead);
  const report::GraphStyle style{options.deepest};
  switch (options.format) {
    case GraphFormat::Svg:
      return report::graphToSvg(graph, style);
    case GraphFormat::Dot:
      return report::graphToDot(graph, style);
    case GraphFormat::Json:
      return report::graphToJson(graph);
    case GraphFormat::Promela:
      break;
  }
  return "";
}

/// The file to write if none is named: in the current folder, named after the mission.
std::string outputName(const GraphOptions& options) {
  constexpr const char* kEndings[] = {".svg", ".dot", ".graph.json", ".pml"};
  return stemOf(options.mission) + kEndings[static_cast<size_t>(options.format)];
}

support::Result<void> put(const GraphOptions& options, const compiler::Compilation& compilation) {
  const std::string output = options.output.empty() ? outputName(options) : options.output;
  if (const auto input = overwrittenInput({options.mission}, {output})) {
    return support::fail(support::diagnostics::outputIsInput, *input);
  }
  // Nothing can be proved about a mission with errors; its known structure is drawn.
  const DeadCases dead = compilation.checked && options.format != GraphFormat::Promela
                             ? compiler::casesThatNeverFire(*compilation.checked)
                             : DeadCases();
  const std::string text = draw(options, compilation, dead);
  if (output == "-") {
    return printOut(text);
  }
  if (auto written = support::writeFileAtomically(output, text); !written) {
    return written;
  }
  return printSuccess(
      fmt::format("{}: mission {}, {}\n", output, compilation.lowered->mission.name,
                  support::counted(compilation.lowered->mission.states.size(), "state")));
}

int graph(const GraphOptions& options) {
  const auto compiled = compiler::compileMission(options.mission);
  if (!compiled) {
    return reportFailure(compiled.error());
  }
  const compiler::Compilation& compilation = *compiled;
  reportDiagnostics(compilation.diagnostics, *compilation.sources);
  if (!compilation.lowered) {
    return kMissionHasErrors;
  }
  if (auto done = put(options, compilation); !done) {
    return reportFailure(done.error());
  }
  return compilation.checked ? kFine : kMissionHasErrors;
}

}  // namespace

void addGraphCommand(CLI::App& app, int& status) {
  auto options = std::make_shared<GraphOptions>();
  CLI::App* command =
      app.add_subcommand("graph", "Draw the states of a mission and the transitions between them");
  command
      ->add_option("MISSION", options->mission,
                   "The mission file (or the IR's text form, FILE.ir); `-` is standard "
                   "input")
      ->required();
  command
      ->add_option_function<std::string>(
          "--format",
          [options](const std::string& format) { options->format = kGraphFormats.at(format); },
          "Output format: svg, dot (Graphviz), json, or promela (a model of the structure for "
          "SPIN) [svg]")
      ->check(oneOf({"svg", "dot", "json", "promela"}))
      ->option_text("FORMAT");
  command->add_flag("--deepest", options->deepest, "Highlight the deepest call stack");
  command->add_option("-o", options->output, "Output file; `-` is standard output [MISSION.svg]")
      ->option_text("FILE");
  command->callback([options, &status] { status = graph(*options); });
}

}  // namespace glider::driver
