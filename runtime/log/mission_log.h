// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "hooks/protocol/payload.h"
#include "runtime/abi/runtime.h"
#include "runtime/log/records.h"

/// The mission's log on the SBC: frames of the hook protocol, passed to the sink at the end of
/// every tick. runtime/README.md has its format.
namespace glider::runtime {

/// The case that made the transition of this tick out of state `from`; there must be one.
const GliderCaseInfo& madeCase(const GliderContext& context, uint32_t from);

/// When the state that a transition left had been entered and resumed, mission time, s.
struct StateTimes {
  double entered, resumed;
};

class MissionLog {
 public:
  /// Further items of a state are not logged.
  static constexpr uint32_t kMostItems = 64;
  /// Longer names and texts are cut off.
  static constexpr uint32_t kNameBytes = 60;
  /// The most bytes that are passed to the sink at once.
  static constexpr uint32_t kBytes = 2048;

  /// `mission` and its name outlive the log.
  MissionLog(const GliderLogSink& sink, const GliderMission& mission)
      : sink_(sink), mission_(mission) {}
  MissionLog(const MissionLog&) = delete;
  MissionLog& operator=(const MissionLog&) = delete;

  /// Records that the mission begins, and with which parameters.
  void begin(const GliderContext& context);
  /// Records the current state's items that are due.
  void values(const GliderContext& context);
  /// Records that the case that made this tick's transition led from state `from`, which had those
  /// times, to the context's state; with every sensor's reading of this tick.
  void transition(const GliderContext& context, uint32_t from, const StateTimes& times);
  /// Records note number `note` of this tick.
  void note(const GliderContext& context, uint32_t note);
  /// Records an event; `value` may be NaN.
  void event(double time, LogEvent what, LogDetail detail, double value);
  /// Passes collected records to the sink. Everything except values is on the card when this
  /// returns.
  void flush();
  /// Records at once that checks of the program's own memory failed: `check` is the number of the
  /// first (log/checks.def), `count` how many.
  void failed(double time, uint32_t check, uint32_t count);
  /// How many bytes wait for the sink: at most kBytes, unless its memory is broken.
  [[nodiscard]] uint32_t held() const { return size_; }
  /// How often the sink did not accept the data.
  [[nodiscard]] uint32_t failures() const { return failures_; }
  /// True if the last write or sync failed.
  [[nodiscard]] bool isFailing() const { return failures_ > 0 && (torn_ || unsynced_); }

 private:
  hooks::ByteWriter open(LogRecord kind);
  hooks::ByteWriter start(LogRecord kind);
  void close(const hooks::ByteWriter& writer);
  void writeHead();
  void name(LogNamed what, uint32_t number, uint32_t item, const char* text);
  /// False if the sink did not accept it.
  bool handOver();
  bool due(const GliderContext& context, uint32_t item);

  GliderLogSink sink_;
  const GliderMission& mission_;
  hooks::Frame frame_;  ///< the record being written
  uint8_t bytes_[kBytes] = {};
  uint32_t size_ = 0;
  double written_[kMostItems] = {};  ///< mission time at which each item was last logged
  uint32_t last_written_state_ = UINT32_MAX;
  uint32_t failures_ = 0;
  /// The state of the head, which begins the log and is needed to read it.
  enum class Head : uint8_t { Missing, Writing, HandedOn, Taken };
  Head head_ = Head::Missing;
  bool torn_ = true;       ///< the log may end in the middle of a record
  bool unsynced_ = false;  ///< what was written last might not survive a power cut
  bool urgent_ = false;    ///< there are records other than values
};

}  // namespace glider::runtime
