// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "runtime/abi/runtime.h"
#include "runtime/abi/talk_mission.h"
#include "support/result.h"

#include <memory>
#include <string_view>

namespace glider::codegen {

/// A mission compiled by codegen::linkShared, loaded into this process for the lifetime of this
/// object. Its functions keep no state of their own: every runtime is in memory that the caller
/// provides.
class LoadedMission {
 public:
  /// GL9002 if there is no room for a temporary file (removed on return), GL9051 if it is not such
  /// a mission.
  static support::Result<LoadedMission> load(std::string_view shared_object);

  [[nodiscard]] const GliderMission& mission() const { return *mission_; }
  /// What it sends and receives by its modem; null if it shares nothing.
  [[nodiscard]] const GliderTalk* talk() const { return talk_; }

  // The entry points of runtime/abi/runtime.h, which says what they take and return.
  [[nodiscard]] uint32_t runtimeSize() const { return entries_.gliderRuntimeSize(); }
  GliderRuntime* init(void* memory, void* context_memory,
                      const GliderRuntimeOptions* options = nullptr) const {
    return entries_.gliderRuntimeInit(memory, context_memory, mission_, options);
  }
  GliderRuntimeStatus poll(GliderRuntime* runtime, const GliderByteStream& stream,
                           const GliderClock& clock) const {
    return entries_.gliderRuntimePoll(runtime, &stream, &clock);
  }
  const GliderContext* context(const GliderRuntime* runtime) const {
    return entries_.gliderRuntimeContext(runtime);
  }
  uint32_t failedCheck(const GliderRuntime* runtime) const {
    return entries_.gliderRuntimeFailedCheck(runtime);
  }
  GliderContext* start(void* context_memory, const double* parameters, const GliderUpdate* updates,
                       uint32_t count) const {
    return entries_.gliderStart(context_memory, mission_, parameters, updates, count);
  }
  void step(GliderContext* context, double mission_time, const GliderUpdate* updates,
            uint32_t count) const {
    entries_.gliderStep(context, mission_time, updates, count);
  }

 private:
  LoadedMission() = default;

  struct EntryPoints {
#define ENTRY_POINT(result, name, parameters) result(*name) parameters = nullptr;
#include "runtime/abi/entry_points.def"
#undef ENTRY_POINT
  };
  struct Unloader {
    void operator()(void* handle) const;
  };

  std::unique_ptr<void, Unloader> handle_;
  const GliderMission* mission_ = nullptr;
  const GliderTalk* talk_ = nullptr;
  EntryPoints entries_;
};

}  // namespace glider::codegen
