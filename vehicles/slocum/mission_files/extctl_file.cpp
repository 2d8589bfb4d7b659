// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "vehicles/slocum/mission_files/extctl_file.h"

#include "support/diagnostics/ids/vehicle.h"
#include "vehicles/slocum/mission_files/line_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <utility>

namespace glider::slocum {
namespace {

constexpr uint32_t kMostBaud = 921'600;
constexpr uint32_t kMostPacket = 725;

/// The words of a line without its comment, in lower case.
std::vector<std::string> wordsOf(std::string line) {
  line.erase(std::min(line.find('#'), line.size()));
  std::istringstream stream(lowerCase(line));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) {
    words.push_back(word);
  }
  return words;
}

/// Reads the file line by line.
class Reader {
 public:
  explicit Reader(std::string_view name) : name_(name) {}

  support::Result<ExtctlFile> read(std::string_view text) {
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
      ++line_;
      const std::vector<std::string> words = wordsOf(line);
      if (words.empty()) {
        continue;
      }
      if (auto taken = take(words); !taken) {
        return std::unexpected(taken.error());
      }
    }
    if (number_ != nullptr) {
      return fail("the file ends where a number is expected");
    }
    return std::move(file_);
  }

 private:
  std::unexpected<support::Failure> fail(const std::string& what) const {
    return support::fail(support::diagnostics::badExtctlFile, name_, line_, what);
  }

  support::Result<void> take(const std::vector<std::string>& words) {
    if (number_ != nullptr) {
      return takeNumber(words);
    }
    if (beginsSection(words.front())) {
      return words.size() == 1 ? support::Result<void>()
             : number_ != nullptr
                 ? takeNumber({words.begin() + 1, words.end()})
                 : fail(fmt::format("`{}` stands alone on its line", words.front()));
    }
    return takeSensor(words);
  }

  bool beginsSection(const std::string& word) {
    const std::pair<const char*, std::vector<ExtctlSensor>*> sections[] = {
        {"mp", &file_.parameters}, {"os", &file_.written}, {"is", &file_.reported}};
    for (const auto& [name, list] : sections) {
      if (word == name) {
        section_ = list;
        return true;
      }
    }
    number_ = word == "baud" ? &file_.baud : word == "packet_size" ? &file_.packet_bytes : nullptr;
    most_ = number_ == &file_.baud ? kMostBaud : kMostPacket;
    return number_ != nullptr;
  }

  support::Result<void> takeNumber(const std::vector<std::string>& words) {
    const std::string& word = words.front();
    uint32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (words.size() != 1 || error != std::errc() || end != word.data() + word.size() ||
        value == 0 || value > most_) {
      return fail(fmt::format("expected a whole number from 1 to {}, found {}", most_,
                              slocum::quoted(word)));
    }
    *std::exchange(number_, nullptr) = value;
    return {};
  }

  support::Result<void> takeSensor(const std::vector<std::string>& words) {
    if (section_ == nullptr) {
      return fail(fmt::format("{} is in no section: write `mp`, `os` or `is` above it",
                              slocum::quoted(words.front())));
    }
    if (words.size() > 2) {
      return fail(
          fmt::format("expected a sensor and its unit, found also {}", slocum::quoted(words[2])));
    }
    const auto all = file_.sensors();
    if (std::ranges::any_of(all, [&](const auto& one) { return one.name == words.front(); })) {
      return fail(fmt::format("{} is given twice", slocum::quoted(words.front())));
    }
    section_->push_back({words.front(), words.size() == 2 ? words[1] : "nodim"});
    return {};
  }

  std::string_view name_;
  uint32_t line_ = 0;
  ExtctlFile file_;
  std::vector<ExtctlSensor>* section_ = nullptr;
  uint32_t* number_ = nullptr;  ///< expected next
  uint32_t most_ = 0;
};

}  // namespace

std::vector<ExtctlSensor> ExtctlFile::sensors() const {
  std::vector<ExtctlSensor> all = parameters;
  all.insert(all.end(), written.begin(), written.end());
  all.insert(all.end(), reported.begin(), reported.end());
  return all;
}

support::Result<ExtctlFile> readExtctlFile(std::string_view name, std::string_view text) {
  return Reader(name).read(text);
}

std::string printExtctlFile(const ExtctlFile& file, std::string_view comment) {
  std::string text;
  std::istringstream lines{std::string(comment)};
  for (std::string line; std::getline(lines, line);) {
    text += line.empty() ? "#\n" : "# " + line + "\n";
  }
  const std::pair<const char*, const std::vector<ExtctlSensor>*> sections[] = {
      {"mp", &file.parameters}, {"os", &file.written}, {"is", &file.reported}};
  for (const auto& [name, list] : sections) {
    text += fmt::format("{}\n", name);
    for (const ExtctlSensor& sensor : *list) {
      text += fmt::format("{} {}\n", sensor.name, sensor.unit);
    }
  }
  return text + fmt::format("baud\n{}\npacket_size\n{}\n", file.baud, file.packet_bytes);
}

}  // namespace glider::slocum
