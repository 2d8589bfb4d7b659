// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/load/loaded_mission.h"

#include "codegen/scratch_folder.h"
#include "support/diagnostics/ids/command.h"

#include <fmt/format.h>

#include <dlfcn.h>

namespace glider::codegen {

void LoadedMission::Unloader::operator()(void* handle) const {
  ::dlclose(handle);
}

support::Result<LoadedMission> LoadedMission::load(std::string_view shared_object) {
  auto scratch = ScratchFolder::make();
  if (!scratch) {
    return std::unexpected(scratch.error());
  }
  const auto file = scratch->write("mission.so", shared_object);
  if (!file) {
    return std::unexpected(file.error());
  }
  LoadedMission loaded;
  loaded.handle_.reset(::dlopen(file->c_str(), RTLD_NOW | RTLD_LOCAL));
  if (!loaded.handle_) {
    return support::fail(support::diagnostics::cannotLoadMission, ::dlerror());
  }
  const char* missing = nullptr;
  auto find = [&]<typename Pointer>(const char* name, Pointer& pointer) {
    pointer = reinterpret_cast<Pointer>(::dlsym(loaded.handle_.get(), name));
    if (pointer == nullptr) {
      missing = name;
    }
  };
  find("gliderMission", loaded.mission_);
#define ENTRY_POINT(result, name, parameters) find(#name, loaded.entries_.name);
#include "runtime/abi/entry_points.def"
#undef ENTRY_POINT
  loaded.talk_ = static_cast<const GliderTalk*>(::dlsym(loaded.handle_.get(), "gliderTalk"));
  if (missing != nullptr) {
    return support::fail(support::diagnostics::cannotLoadMission,
                         fmt::format("it has no `{}`", missing));
  }
  return loaded;
}

}  // namespace glider::codegen
