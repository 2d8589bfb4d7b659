// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/trace/trace.h"

#include <cstdio>
#include <memory>

namespace glider::support {

/// Rows of a trace that wait on disk while it grows, in a file without a name that is gone with the
/// process. What cannot be written stays in memory.
class RowSpool {
 public:
  /// So many rows of a trace stay in memory, at most.
  static constexpr size_t kMostRows = 512;

  /// Moves all rows but the newest to the disk, once there are kMostRows.
  void take(Trace& trace);
  /// Puts them back before those that the trace has.
  void giveBack(Trace& trace);

 private:
  struct Close {
    void operator()(std::FILE* file) const { (void)std::fclose(file); }
  };

  std::unique_ptr<std::FILE, Close> file_;
  size_t values_ = 0;     ///< on disk
  bool refused_ = false;  ///< the disk takes no more
};

}  // namespace glider::support
