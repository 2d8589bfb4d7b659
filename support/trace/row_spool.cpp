// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/trace/row_spool.h"

#include "support/check.h"

#include <utility>

namespace glider::support {

void RowSpool::take(Trace& trace) {
  if (refused_ || trace.rowCount() < kMostRows) {
    return;
  }
  if (file_ == nullptr) {
    file_.reset(std::tmpfile());
  }
  const size_t count = trace.rows.size() - trace.columns.size();
  // Where it ends is known: what is written only in part is written over, or not read.
  refused_ = file_ == nullptr ||
             std::fseek(file_.get(), static_cast<long>(values_ * sizeof(double)), SEEK_SET) != 0 ||
             std::fwrite(trace.rows.data(), sizeof(double), count, file_.get()) != count ||
             std::fflush(file_.get()) != 0;
  if (!refused_) {
    values_ += count;
    trace.rows.erase(trace.rows.begin(), trace.rows.begin() + static_cast<std::ptrdiff_t>(count));
  }
}

void RowSpool::giveBack(Trace& trace) {
  if (values_ == 0) {
    return;
  }
  std::vector<double> rows(values_);
  const bool whole = std::fseek(file_.get(), 0, SEEK_SET) == 0 &&
                     std::fread(rows.data(), sizeof(double), values_, file_.get()) == values_;
  CHECK(whole, "a temporary file has lost what was written");
  rows.insert(rows.end(), trace.rows.begin(), trace.rows.end());
  trace.rows = std::move(rows);
  values_ = 0;
  file_.reset();
}

}  // namespace glider::support
