// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"
#include "runtime/log/format.h"

/// The mission's log on the SBC: lines of comma-separated values, handed on at the end of every
/// tick. runtime/README.md has its format.
namespace glider::runtime {

/// The case that made the transition of this tick out of state `from`; there must be one.
const GliderCaseInfo& madeCase(const GliderContext& context, uint32_t from);

class MissionLog {
 public:
  /// A state's items after so many are not logged.
  static constexpr uint32_t kMostItems = 64;
  /// Longer names are cut off.
  static constexpr uint32_t kNameBytes = 60;

  explicit MissionLog(const GliderLogSink& sink) : sink_(sink) {}
  MissionLog(const MissionLog&) = delete;
  MissionLog& operator=(const MissionLog&) = delete;

  /// That the mission begins, and with which parameters.
  void begin(const GliderContext& context);
  /// The current state's items that are due.
  void values(const GliderContext& context);
  /// That the case which made this tick's transition led from `from` to the context's state.
  void transition(const GliderContext& context, uint32_t from);
  /// Note number `note` of this tick: a line for each of its values.
  void note(const GliderContext& context, uint32_t note);
  /// Something happened: `name` says what (`detail` may be ""), `value` may be NaN.
  void event(double time, const char* name, const char* detail, double value);
  /// Hands over what has gathered.
  void flush();
  /// How often the sink did not take what it was given.
  [[nodiscard]] uint32_t failures() const { return failures_; }

 private:
  struct Fields {
    double time;
    const char* record;
    const char* name;
    double value;
    const char* from = "";
    const char* to = "";
  };
  void line(const Fields& fields);
  void putName(const char* name);
  void compose(const Fields& fields);
  bool due(const GliderContext& context, uint32_t item);

  static constexpr uint32_t kBytes = 2048;
  GliderLogSink sink_;
  char bytes_[kBytes] = {};
  Text text_{bytes_, kBytes};
  double written_[kMostItems] = {};  ///< mission time at which each item was last logged
  uint32_t last_written_state_ = UINT32_MAX;
  uint32_t failures_ = 0;
  bool headed_ = false;  ///< the header was written
  bool torn_ = false;    ///< the sink may stand in the middle of a line
};

}  // namespace glider::runtime
