// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "support/netcdf/netcdf_library.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace glider::support {

/// A netCDF-4 file of the classic model in memory, so that it is written whole or not at all. After
/// an error, even that the library is missing, the calls do nothing, and the first error is kept.
class NetcdfMemoryFile {
 public:
  NetcdfMemoryFile();
  ~NetcdfMemoryFile();
  NetcdfMemoryFile(const NetcdfMemoryFile&) = delete;
  NetcdfMemoryFile& operator=(const NetcdfMemoryFile&) = delete;

  /// Returns its number, as the following do.
  int dimension(const char* name, size_t size);
  /// A compressed variable along `along`.
  int variable(const std::string& name, nc_type type, int along);
  /// A variable of one value.
  int scalar(const std::string& name, nc_type type);
  void attribute(int variable, const char* name, std::string_view text);
  void fill(int variable, nc_type type, double value);
  void attributeBytes(int variable, const char* name, const std::vector<signed char>& values);
  void endDefinitions();
  void put(int variable, const std::vector<double>& values, const std::string& name);
  /// The library refuses to make a float of an infinity: they come as floats, as they are stored.
  void putFloats(int variable, const std::vector<double>& values, const std::string& name);
  /// The content of the finished file; "" after an error.
  std::string close();
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  [[nodiscard]] bool good() const { return error_.empty(); }
  template <typename Call>
  void run(Call call, const std::string& name) {
    if (good()) {
      check(call(), name);
    }
  }
  void check(int status, const std::string& name);

  const NetcdfLibrary& nc_;
  int id_ = -1;
  bool open_ = false;
  std::string error_;
};

}  // namespace glider::support
