// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "ir/core/mission.h"
#include "ir/text/layout.h"

#include <fmt/format.h>

#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace glider::ir::text {

/// A name unchanged if it has the form of a name, otherwise in quotes with everything but printable
/// ASCII escaped.
std::string nameText(std::string_view name);

/// Writes the text form of a valid mission, once. The order of the text is that of the mission's
/// vectors; what cannot be written in that order is named before its use.
class Printer {
 public:
  explicit Printer(const Mission& mission)
      : m_(mission), layout_(layOut(mission)), block_first_(layOutBlocks(mission)) {}

  std::string run();

 private:
  template <typename... Args>
  void add(fmt::format_string<Args...> format, Args&&... args) {
    fmt::format_to(std::back_inserter(out_), format, std::forward<Args>(args)...);
  }
  /// Begins a line of the text.
  template <typename... Args>
  void line(fmt::format_string<Args...> format, Args&&... args) {
    out_ += '\n';
    out_.append(2 * size_t{indent_}, ' ');
    add(format, std::forward<Args>(args)...);
  }

  void compass();
  void sensor(const Sensor& sensor);
  void shares();
  void behaviour(const Behaviour& behaviour);
  void variable(const Variable& variable);
  void table(const Table& table);
  void function(const Function& function);
  void launch();
  void initials();
  void state(const State& state);
  void activity(std::string_view what, const Activity& activity);

  void temporal(const Temporal& temporal);
  void cases(const std::vector<Case>& cases);
  void assumption(const Assumption& a);
  void geofence(const Geofence& fence);
  void monitor(const Monitor& monitor);
  void table(const GuardTable& table);
  void requirement(const Requirement& requirement);
  void entry(BlockId block);
  void defineBlocks(BlockId user);
  void useBlock(BlockId block, std::string_view word);
  void statements(BlockId block);
  void statement(const Statement& statement);
  void condition(const Statement& statement);

  void prepare(std::span<const ExprId> ids);
  void defineUpTo(uint32_t end);
  bool defineNext(uint32_t end);
  bool writeNext(uint32_t end);
  void use(ExprId id);
  void list(std::span<const ExprId> ids);
  void tree(uint32_t number);
  void leaf(const Expr& expr);

  const Mission& m_;
  Layout layout_;
  std::vector<uint32_t> block_first_;
  std::string out_;
  uint32_t indent_ = 0;
  bool defining_ = false;
  uint32_t next_ = 0;        ///< expressions below this number are written
  uint32_t next_block_ = 0;  ///< the same for blocks, and so on
  uint32_t next_initial_ = 0;
  uint32_t next_temporal_ = 0;
  uint32_t next_condition_ = 0;
};

}  // namespace glider::ir::text
