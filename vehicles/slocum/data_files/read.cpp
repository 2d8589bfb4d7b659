// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/data_files/read.h"

#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/vehicle.h"
#include "support/files.h"
#include "vehicles/slocum/data_files/blocks.h"
#include "vehicles/slocum/data_files/header.h"
#include "vehicles/slocum/data_files/known_bytes.h"
#include "vehicles/slocum/data_files/records.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace glider::slocum {
namespace {

namespace fs = std::filesystem;
using support::Result;

constexpr std::string_view kLabel = "dbd_label:";

/// True for ".sbd", ".TCD" and the like.
bool isDataExtension(std::string extension) {
  std::ranges::transform(extension, extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
  });
  return extension.size() == 4 && extension[0] == '.' &&
         std::string_view("dmsent").contains(extension[1]) &&
         std::string_view("bc").contains(extension[2]) && extension[3] == 'd';
}

/// The extension in the header says which computer wrote the file: a file may have been renamed.
Computer computerOf(const DataHeader& header) {
  const char kind = header.extension.empty() ? ' ' : header.extension[0];
  return std::string_view("entENT").contains(kind) ? Computer::Science : Computer::Flight;
}

/// Reads a file part by part.
class Reader {
 public:
  Reader(const fs::path& path, std::string_view content, SensorLists& lists,
         std::vector<size_t> holes = {})
      : path_(path), content_(content), lists_(lists), holes_(std::move(holes)) {}

  Result<DataFile> read() {
    auto header = parseHeader(content_);
    if (!header) {
      return notData(header.error());
    }
    file_.header = std::move(header->header);
    file_.computer = computerOf(file_.header);
    const auto begin = readList(header->end);
    if (!begin) {
      return std::unexpected(begin.error());
    }
    const auto order = byteOrderOf(content_.substr(*begin));
    if (!order) {
      return notData({*begin, content_.size() < *begin + kKnownBytes
                                  ? "the file ends before the known bytes"
                                  : "the known bytes that show the byte order are wrong"});
    }
    file_.order = *order;
    decodeRecords(content_, *begin + kKnownBytes, holes_, file_);
    return std::move(file_);
  }

 private:
  [[nodiscard]] std::unexpected<support::Failure> notData(const Damage& damage) const {
    return support::fail(support::diagnostics::notDataFile, path_.string(),
                         fmt::format("byte {}: {}", damage.offset, damage.what));
  }

  /// Makes the columns from the sensor list, which is in the file at `begin` or in a cache file.
  /// Returns where the list ends.
  Result<size_t> readList(size_t begin) {
    const DataHeader& header = file_.header;
    size_t end = begin;
    std::shared_ptr<const SensorList> list;
    if (header.list_factored) {
      auto found = lists_.find(header.list_crc, path_);
      if (!found) {
        return std::unexpected(found.error());
      }
      list = std::move(*found);
    } else {
      auto parsed = parseSensorList(content_, begin, header.total_sensors);
      if (!parsed) {
        return notData(parsed.error());
      }
      end = parsed->end;
      if (parsed->crc != header.list_crc) {
        file_.damage.push_back(
            {begin, fmt::format("the sensor list has CRC {:08x}, and the header says {:08x}",
                                parsed->crc, header.list_crc)});
      }
      list = std::make_shared<const SensorList>(std::move(*parsed));
      lists_.add(list);
    }
    if (list->sensors.size() != header.sensors) {
      return notData({begin, fmt::format("the sensor list has {} sensors, and the header says {}",
                                         list->sensors.size(), header.sensors)});
    }
    for (const Sensor& sensor : list->sensors) {
      file_.columns.push_back({sensor, {}});
    }
    return end;
  }

  const fs::path& path_;
  std::string_view content_;
  SensorLists& lists_;
  std::vector<size_t> holes_;  ///< in front of these bytes content is missing
  DataFile file_;
};

/// Whether each line feed of `bytes`, also in the records, has a carriage return in front of it: a
/// transfer as text did that, and it can be undone exactly.
bool isTextTransfer(std::string_view bytes) {
  size_t feeds = 0;
  for (size_t at = bytes.find('\n'); at != std::string_view::npos; at = bytes.find('\n', at + 1)) {
    if (at == 0 || bytes[at - 1] != '\r') {
      return false;
    }
    ++feeds;
  }
  return feeds > 0;
}

std::string withoutCarriageReturns(std::string_view bytes) {
  std::string content;
  content.reserve(bytes.size());
  for (size_t i = 0; i < bytes.size(); ++i) {
    if (bytes[i] != '\r' || i + 1 == bytes.size() || bytes[i + 1] != '\n') {
      content += bytes[i];
    }
  }
  return content;
}

Result<DataFile> decodeCompressed(const fs::path& path, std::string_view bytes,
                                  SensorLists& lists) {
  const Decompressed opened = decompress(bytes);
  auto file = Reader(path, opened.content, lists, opened.holes).read();
  if (file) {
    file->compressed = true;
    for (Damage& damage : file->damage) {
      damage.what += " (counted in the decompressed content)";
    }
    if (!file->end_mark || !opened.holes.empty()) {  // what follows the end mark does not matter
      file->damage.insert(file->damage.end(), opened.damage.begin(), opened.damage.end());
    }
  }
  return file;
}

}  // namespace

bool looksLikeDataFile(const fs::path& path, std::string_view bytes) {
  return bytes.starts_with(kLabel) || firstBlockBeginsWith(bytes, kLabel) ||
         isDataExtension(path.extension());
}

Result<DataFile> decodeDataFile(const fs::path& path, std::string_view bytes, SensorLists& lists) {
  if (!bytes.starts_with(kLabel) && firstBlockBeginsWith(bytes, kLabel)) {
    return decodeCompressed(path, bytes, lists);
  }
  if (!bytes.starts_with(kLabel) || !isTextTransfer(bytes)) {
    return Reader(path, bytes, lists).read();
  }
  auto file = Reader(path, withoutCarriageReturns(bytes), lists).read();
  if (file) {
    file->as_text = true;
  }
  return file;
}

Result<DataFile> readDataFile(const fs::path& path, SensorLists& lists) {
  const auto bytes = support::readFile(path, kLargestContent);
  if (!bytes) {
    return std::unexpected(bytes.error());
  }
  return decodeDataFile(path, *bytes, lists);
}

Result<std::vector<fs::path>> findDataFiles(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) {
    return std::vector{folder};
  }
  std::vector<fs::path> files;
  for (fs::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error)) {
    if (isDataExtension(file->path().extension()) && !file->is_directory(error)) {
      files.push_back(file->path());
    }
  }
  if (error || files.empty()) {
    return support::fail(support::diagnostics::cannotRead, folder.string(),
                         error ? error.message() : "the folder has no data files");
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace glider::slocum
