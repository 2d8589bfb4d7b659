// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// The pages of `glidercc explain`: what a page refuses is refused for that reason only, and what it
// repairs is fine and laid out as `glidercc fmt` would.

#include "compiler/compilation.h"
#include "compiler/proving.h"
#include "frontend/format/format.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/diagnostics/ids/syntax.h"
#include "support/diagnostics/ids/verification.h"
#include "support/diagnostics/render.h"
#include "tests/docs/examples.h"
#include "tests/unit/frontend/compile.h"

#include <algorithm>
#include <filesystem>
#include <set>

namespace glider::tests {
namespace {

using frontend::testing_support::FrontendRun;
using support::DiagnosticId;

/// Errors that no page can show: they are about bytes, sizes, other files, or what only the IR's
/// text form can say.
const std::set<DiagnosticId> kNotShown = {
    support::diagnostics::notUtf8, support::diagnostics::nulByte, support::diagnostics::utf16,
    support::diagnostics::nestedTooDeep, support::diagnostics::fileTooLarge,
    support::diagnostics::tooManyErrors, support::diagnostics::expressionTooLong,
    support::diagnostics::notInLibrary, support::diagnostics::importUnreadable,
    support::diagnostics::importCycle, support::diagnostics::importsTooDeep,
    support::diagnostics::emptyImport, support::diagnostics::waypointsNeedName,
    support::diagnostics::nameForMission, support::diagnostics::waypointLine,
    support::diagnostics::noWaypoints, support::diagnostics::listBeginsElsewhere,
    support::diagnostics::argumentRange, support::diagnostics::parameterDefault,
    support::diagnostics::tooManyOwnSensors,
    // A vehicle that no shipped file describes.
    support::diagnostics::declinationUnknown,
    // The vehicle's mission file: vehicle_missions_test.cpp tries the page.
    support::diagnostics::mayStayBelow, support::diagnostics::vehicleRefuses,
    support::diagnostics::vehicleAborts, support::diagnostics::startUnassumed,
    support::diagnostics::hookbehOverrides, support::diagnostics::mayNotFollow,
    support::diagnostics::commandsMasked, support::diagnostics::controlPrevented,
    support::diagnostics::sensorUnread};
/// Their repair needs a second file.
const std::set<DiagnosticId> kNotRepaired = {support::diagnostics::openString};

bool aboutMissions(DiagnosticId id) {
  const auto number = static_cast<int>(id);
  return number < 1800 || (number >= 2000 && number < 4000);
}

std::vector<std::string> idsOf(const std::string& text, std::string& said) {
  auto compilation = compiler::compileText("test.mission", text);
  if (!compilation) {
    said = compilation.error().message;
    return {};
  }
  if (compilation->checked) {
    compiler::prove(*compilation->checked, {}, compilation->diagnostics);
  }
  said = support::render(compilation->diagnostics, *compilation->sources, false);
  std::vector<std::string> ids;
  for (const support::Diagnostic& d : compilation->diagnostics.sorted()) {
    ids.push_back(support::code(d.id));
  }
  return ids;
}

void expectFine(const Example& example) {
  std::string said;
  EXPECT_TRUE(idsOf(example.text, said).empty()) << said;
  FrontendRun run(example.text);
  EXPECT_EQ(frontend::format(run.sources, run.file, run.diagnostics), example.text);
}

TEST(ExplainPages, SayWhatIsTrue) {
  const std::filesystem::path folder = GLIDER_SOURCE_DIR "/support/diagnostics/explain";
  for (const support::CatalogueRow& row : support::catalogue()) {
    const std::string code = support::code(row.id);
    SCOPED_TRACE(code + " " + std::string(row.slug));
    const auto page = folder / (code + ".md");
    ASSERT_TRUE(std::filesystem::exists(page));
    size_t refused = 0;
    size_t repaired = 0;
    for (const Example& example : examplesOf(page)) {
      if (example.expected.empty()) {
        ++repaired;
        expectFine(example);
        continue;
      }
      ++refused;
      EXPECT_EQ(example.expected, code);
      std::string said;
      const auto ids = idsOf(example.text, said);
      EXPECT_NE(std::ranges::find(ids, code), ids.end()) << said;
    }
    const bool shown = aboutMissions(row.id) && !kNotShown.contains(row.id);
    EXPECT_EQ(refused, shown ? 1U : 0U);
    EXPECT_EQ(repaired, shown && !kNotRepaired.contains(row.id) ? 1U : 0U);
  }
}

}  // namespace
}  // namespace glider::tests
