// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/result.h"
#include "vehicles/slocum/data_files/sensor_list.h"

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace glider::slocum {

/// The sensor lists that data files refer to by their CRC: from other data files, or from the
/// vehicle's cache files (1f35be3b.cac, or compressed .ccc), which are read when first asked for.
class SensorLists {
 public:
  /// `folders`: where cache files are. Empty: in the folder of the data file that needs one, and in
  /// its folders `cac` and `cache`.
  explicit SensorLists(std::vector<std::filesystem::path> folders = {})
      : folders_(std::move(folders)) {}

  /// The list with this CRC, for the data file `file`. GL5201: it is missing; GL5202.
  support::Result<std::shared_ptr<const SensorList>> find(uint32_t crc,
                                                          const std::filesystem::path& file);
  void add(std::shared_ptr<const SensorList> list);

 private:
  using Names = std::map<std::string, std::filesystem::path>;
  const Names& cacheFiles(const std::filesystem::path& folder);

  std::vector<std::filesystem::path> folders_;
  std::map<std::filesystem::path, Names> names_;  ///< of the cache files, in lower case
  std::map<uint32_t, std::shared_ptr<const SensorList>> lists_;
};

}  // namespace glider::slocum
