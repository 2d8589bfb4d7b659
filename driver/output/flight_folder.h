// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace glider::driver {

/// The folder of one flight's files, or of one run's that a check has found. They are written
/// beside it, into a folder of their own, and take its place all at once: files of two flights are
/// never mixed, and what goes wrong before that leaves the earlier flight as it was.
class FlightFolder {
 public:
  /// A name in every folder of a flight: the file that lists the others (writeFlightSummary).
  static constexpr const char* kSummary = "flight.json";
  /// A name in every folder of a run: the file that it is flown again from.
  static constexpr const char* kRun = "trace.json";
  enum class Use : uint8_t { Flight, Run };

  /// For `target`, which need not exist. GL9374 if it holds anything but a flight (GL9002 if
  /// anything but a run), GL9002 if it cannot be made.
  static support::Result<FlightFolder> open(const std::filesystem::path& target,
                                            Use use = Use::Flight);
  /// For files that nobody keeps, among the system's temporary ones.
  static support::Result<FlightFolder> scratch();
  FlightFolder(FlightFolder&& other) noexcept;
  FlightFolder& operator=(FlightFolder&&) = delete;
  FlightFolder(const FlightFolder&) = delete;
  FlightFolder& operator=(const FlightFolder&) = delete;
  /// Without commit() nothing is left behind.
  ~FlightFolder();

  /// Where to write the files.
  [[nodiscard]] const std::filesystem::path& staging() const { return staging_; }
  /// Where a file that the user names is to be written: in staging() if that is in the folder.
  [[nodiscard]] std::filesystem::path placeOf(const std::filesystem::path& file) const;
  /// The names in staging(), sorted.
  [[nodiscard]] std::vector<std::string> names() const;
  /// Puts what has been written in the place of the folder. GL9002.
  support::Result<void> commit();

 private:
  FlightFolder(std::filesystem::path target, std::filesystem::path staging)
      : target_(std::move(target)), staging_(std::move(staging)) {}

  std::filesystem::path target_;
  std::filesystem::path staging_;  ///< empty: nothing to take away
};

}  // namespace glider::driver
