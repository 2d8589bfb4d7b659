// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace glider::driver {

/// The folder for the files of one flight, or of one trace that a check has found. They are written
/// into a staging folder beside it, which replaces it in one step: files of two flights are never
/// mixed, and an error before that leaves the earlier flight as it was.
class FlightFolder {
 public:
  /// A name in every folder of a flight: the file that lists the others (writeFlightSummary).
  static constexpr const char* kSummary = "flight.json";
  /// A name in every folder of a trace: the file that is replayed.
  static constexpr const char* kRun = "trace.json";
  enum class Use : uint8_t { Flight, Run };

  /// For `target`, which need not exist. GL9374 if it holds anything but a flight (GL9002 if
  /// anything but a trace), GL9002 if it cannot be created.
  static support::Result<FlightFolder> open(const std::filesystem::path& target,
                                            Use use = Use::Flight);
  /// For files that are not kept, in the system's temporary folder.
  static support::Result<FlightFolder> scratch();
  FlightFolder(FlightFolder&& other) noexcept;
  FlightFolder& operator=(FlightFolder&&) = delete;
  FlightFolder(const FlightFolder&) = delete;
  FlightFolder& operator=(const FlightFolder&) = delete;
  /// Removes everything unless commit() was called.
  ~FlightFolder();

  /// Where to write the files.
  [[nodiscard]] const std::filesystem::path& staging() const { return staging_; }
  /// Where to write a file that the user names: in staging() if it is inside the folder.
  [[nodiscard]] std::filesystem::path placeOf(const std::filesystem::path& file) const;
  /// The names in staging(), sorted.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Replaces the folder with what has been written. GL9002.
  support::Result<void> commit();

 private:
  FlightFolder(std::filesystem::path target, std::filesystem::path staging)
      : target_(std::move(target)), staging_(std::move(staging)) {}

  std::filesystem::path target_;
  std::filesystem::path staging_;  ///< empty: nothing to remove
};

}  // namespace glider::driver
