// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/sensor_lists.h"

#include "support/diagnostics/ids/vehicle.h"
#include "support/files.h"
#include "vehicles/slocum/data_files/blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace glider::slocum {
namespace {

namespace fs = std::filesystem;
using support::Result;

std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  return text;
}

Result<std::shared_ptr<const SensorList>> readCacheFile(const fs::path& path, uint32_t crc) {
  auto text = support::readFile(path);
  if (!text) {
    return std::unexpected(text.error());
  }
  const auto bad = [&](const std::string& what) {
    return support::fail(support::diagnostics::badSensorList, path.string(), what);
  };
  if (lowerCase(path.extension()) == ".ccc") {
    Decompressed opened = decompress(*text);
    if (!opened.damage.empty()) {
      const Damage& first = opened.damage.front();
      return bad(fmt::format("byte {}: {}", first.offset, first.what));
    }
    *text = std::move(opened.content);
  }
  auto list = parseSensorList(*text, 0, 0);
  if (!list) {
    return bad(fmt::format("byte {}: {}", list.error().offset, list.error().what));
  }
  if (list->crc != crc) {
    return bad(
        fmt::format("its name promises CRC {:08x}, but its lines have {:08x}", crc, list->crc));
  }
  return std::make_shared<const SensorList>(std::move(*list));
}

}  // namespace

const SensorLists::Names& SensorLists::cacheFiles(const fs::path& folder) {
  const auto [entry, fresh] = names_.try_emplace(folder);
  std::error_code error;
  for (fs::directory_iterator file(folder, error), end; fresh && !error && file != end;
       file.increment(error)) {
    const std::string name = lowerCase(file->path().filename());
    if (name.ends_with(".cac") || name.ends_with(".ccc")) {
      entry->second.emplace(name, file->path());
    }
  }
  return entry->second;
}

void SensorLists::add(std::shared_ptr<const SensorList> list) {
  lists_.try_emplace(list->crc, std::move(list));
}

Result<std::shared_ptr<const SensorList>> SensorLists::find(uint32_t crc, const fs::path& file) {
  if (const auto known = lists_.find(crc); known != lists_.end()) {
    return known->second;
  }
  const fs::path beside = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const auto folders =
      folders_.empty() ? std::vector<fs::path>{beside / "cac", beside / "cache", beside} : folders_;
  const std::string name = fmt::format("{:08x}", crc);
  std::string searched;
  std::optional<support::Failure> invalid;
  for (const fs::path& folder : folders) {
    searched += (searched.empty() ? "`" : ", `") + folder.string() + "`";
    const Names& names = cacheFiles(folder);
    for (const char* extension : {".cac", ".ccc"}) {
      const auto found = names.find(name + extension);
      if (found == names.end()) {
        continue;
      }
      if (auto list = readCacheFile(found->second, crc)) {
        add(*list);
        return *list;
      } else if (!invalid) {
        invalid = list.error();
      }
    }
  }
  if (invalid) {
    return std::unexpected(*invalid);
  }
  return support::fail(support::diagnostics::sensorListMissing, file.string(), name, searched);
}

}  // namespace glider::slocum
