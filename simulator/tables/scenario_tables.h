// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "platforms/load/toml_reader.h"
#include "simulator/geography/local_frame.h"

#include <functional>
#include <optional>
#include <string>

namespace glider::simulator {

/// One table of a scenario file: number fields with bounds, in addition to what TomlReader reads.
class Fields {
 public:
  /// `frame` is that of the scenario's start; null if no position is read.
  Fields(const std::string& file, const toml::table& table, const std::string& where,
         const LocalFrame* frame)
      : table_(table), frame_(frame), reader_(file, table, where) {}

  /// Stores the number `key`, if present, in `into`; a value outside lowest…highest is refused.
  void number(const char* key, double& into, double lowest, double highest);
  /// The same for a number that must be present.
  double required(const char* key, double lowest, double highest);
  /// The number `key`, which must be present; it may be infinite or NaN.
  double anyNumber(const char* key);
  /// A bearing in degrees clockwise from north, as rad.
  void bearing(const char* key, double& into);
  /// The position latitude_deg, longitude_deg, which must be present, in m east and north of the
  /// start.
  void place(double& x, double& y);
  /// Refuses one of two fields without the other if they are meaningful only together.
  void together(const char* one, const char* other);
  [[nodiscard]] bool has(const char* key) const { return table_.contains(key); }
  platforms::TomlReader& reader() { return reader_; }

 private:
  const toml::table& table_;
  const LocalFrame* frame_;
  platforms::TomlReader reader_;
};

/// A scenario file that is being read. Tables that are left out read as empty; the first failure is
/// kept.
class ScenarioTables {
 public:
  using Read = std::function<void(Fields&)>;

  ScenarioTables(std::string file, const toml::table& root) : file_(std::move(file)), root_(root) {}

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] const toml::table& root() const { return root_; }
  [[nodiscard]] bool has(const char* table, const char* part) const {
    return static_cast<bool>(root_[table][part]);
  }
  /// From now on positions are relative to this start.
  void startAt(double latitude_deg, double longitude_deg) {
    frame_.emplace(latitude_deg, longitude_deg);
  }
  /// Reads what is not in a table.
  void head(const Read& read);
  /// Reads [table].
  void table(const char* table, const Read& read);
  /// Reads [table.part].
  void part(const char* table, const char* part, const Read& read);
  /// Reads each [[table.part]].
  void each(const char* table, const char* part, const Read& read);
  [[nodiscard]] const std::optional<support::Failure>& failure() const { return failure_; }

 private:
  void read(const toml::table& table, const std::string& where, const Read& read);
  void refuse(const char* table, const char* part, const char* why);

  std::string file_;
  const toml::table& root_;
  std::optional<LocalFrame> frame_;
  std::optional<support::Failure> failure_;
};

}  // namespace glider::simulator
