// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include <netcdf.h>
#include <netcdf_mem.h>
#include <string>

namespace glider::support {

/// The functions of netCDF-C that glidercc calls, from the shared library, which is loaded when it
/// is first needed: with the 40 libraries that it needs itself, loading takes longer than all else
/// that a short command does.
struct NetcdfLibrary {
  /// Loads the library, once. Without it no function may be called; `error` says why.
  static const NetcdfLibrary& get();

#define FUNCTION(name) decltype(&::nc_##name) name = nullptr;
#include "support/netcdf/netcdf_functions.def"
#undef FUNCTION
  std::string error;  ///< empty: all functions are there
};

}  // namespace glider::support
