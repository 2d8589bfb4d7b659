// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "support/netcdf/netcdf_library.h"

#include <dlfcn.h>

namespace glider::support {
namespace {

NetcdfLibrary load() {
  NetcdfLibrary library;
  void* const handle = dlopen(GLIDER_NETCDF, RTLD_NOW | RTLD_LOCAL);
  if (handle == nullptr) {
    library.error = dlerror();
    return library;
  }
  const auto find = [&]<typename Function>(Function& function, const char* name) {
    function = reinterpret_cast<Function>(dlsym(handle, name));
    if (function == nullptr) {
      library.error = std::string(GLIDER_NETCDF) + " has no " + name;
    }
  };
#define FUNCTION(name) find(library.name, "nc_" #name);
#include "support/netcdf/netcdf_functions.def"
#undef FUNCTION
  return library;
}

}  // namespace

const NetcdfLibrary& NetcdfLibrary::get() {
  static const NetcdfLibrary library = load();
  return library;
}

}  // namespace glider::support
