// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "analysis/as_written.h"
#include "compiler/compilation.h"
#include "report/brief/brief.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace glider::analysis {

/// The statements and cases of a mission in words, for report::Brief.
class InWords {
 public:
  /// `lowered` outlives this; `loops` are those of its text.
  explicit InWords(const compiler::Lowered& lowered, std::vector<WrittenLoop> loops = {})
      : m_(lowered.mission), sources_(*lowered.sources), loops_(std::move(loops)) {}

  /// "sets `n` to `n + 1`, logs “warm” with `n`"; empty for an invalid block.
  [[nodiscard]] std::string block(ir::BlockId block) const;
  /// `never` is that of report::GraphCase.
  [[nodiscard]] report::BriefEvent event(const ir::Case& c, const std::string& never) const;
  /// "`depth` and `temp` on every tick; `lat` every 8 s"; empty if the state logs nothing.
  [[nodiscard]] static std::string samples(const ir::State& state);
  [[nodiscard]] static std::string instruments(const ir::State& state);

 private:
  [[nodiscard]] std::string written(support::SourceRange range) const;
  /// The first of some statements.
  [[nodiscard]] std::string statement(std::span<const ir::Statement> statements,
                                      const WrittenLoop* around) const;
  [[nodiscard]] std::optional<std::string> positionSet(
      std::span<const ir::Statement> statements) const;
  [[nodiscard]] std::string oneAsIs(const ir::Statement& statement,
                                    const WrittenLoop* around) const;
  [[nodiscard]] std::string list(std::span<const ir::Statement> statements,
                                 const WrittenLoop* around) const;
  [[nodiscard]] std::string block(ir::BlockId block, const WrittenLoop* around) const;
  /// The outermost loop in `around` that a statement was written out from; null if there is none.
  [[nodiscard]] const WrittenLoop* loopOf(const ir::Statement& statement,
                                          const WrittenLoop* around) const;
  /// A latitude and the longitude after it as one position: by its text, or as numbers in the one
  /// form; empty if they are two values of their own.
  [[nodiscard]] std::optional<std::string> position(ir::ExprId first, ir::ExprId second) const;
  [[nodiscard]] std::string values(const std::vector<ir::ExprId>& values) const;
  /// "corner.latitude" of the variable "leg.corner.latitude".
  [[nodiscard]] std::string nameIn(const ir::State& state, size_t parameter) const;
  [[nodiscard]] std::string transition(const ir::Case& c) const;

  const ir::Mission& m_;
  const support::SourceManager& sources_;
  std::vector<WrittenLoop> loops_;
};

}  // namespace glider::analysis
