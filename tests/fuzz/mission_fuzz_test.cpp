// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

// Mutations of every mission and golden of the project, the same on every run: bytes changed, words
// moved, doubled, dropped and exchanged between files. GLIDER_FUZZ_ROUNDS sets how many (default
// 10,000).

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

std::vector<std::string> seeds() {
  constexpr size_t kLargest = 6000;
  std::vector<std::filesystem::path> paths;
  for (const char* folder : {"missions", "tests/golden"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(
             std::filesystem::path(GLIDER_SOURCE_DIR) / folder)) {
      if (entry.path().extension() == ".mission" && entry.file_size() < kLargest) {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> texts;
  for (const auto& path : paths) {
    std::ifstream in(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(in), {});
    const size_t expectation = text.find("\n//|");
    texts.push_back(text.substr(0, expectation));
  }
  return texts;
}

class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  size_t pick(size_t n) { return n == 0 ? 0 : random_() % n; }

  void mutate(std::string& text, const std::string& other) {
    const size_t at = pick(text.size() + 1);
    switch (pick(7)) {
      case 0:
        text.insert(at, 1, static_cast<char>(pick(256)));
        break;
      case 1:
        text.erase(at, pick(4) + 1);
        break;
      case 2:
        text.insert(at, word(other));
        break;
      case 3:
        text.erase(at, word(text).size());
        break;
      case 4:
        text = text.substr(0, at);
        break;
      case 5:
        text.insert(at, " " + word(other) + " " + word(text) + " ");
        break;
      default:
        text.insert(at, line(other));
    }
  }

 private:
  std::string word(const std::string& text) { return piece(text, " \n\t(),"); }
  std::string line(const std::string& text) { return piece(text, "\n"); }
  std::string piece(const std::string& text, const char* separators) {
    const size_t begin = text.find_first_not_of(separators, pick(text.size()));
    if (begin == std::string::npos) {
      return {};
    }
    return text.substr(begin, text.find_first_of(separators, begin) - begin);
  }

  std::mt19937 random_;
};

TEST(MissionFuzz, NothingBreaksTheFrontend) {
  const std::vector<std::string> all = seeds();
  ASSERT_GT(all.size(), 20U);
  const char* rounds = std::getenv("GLIDER_FUZZ_ROUNDS");
  const unsigned count =
      rounds != nullptr ? static_cast<unsigned>(std::strtoul(rounds, nullptr, 10)) : 10000;
  for (unsigned round = 0; round < count; ++round) {
    Mutator mutator(round);
    std::string text = all[mutator.pick(all.size())];
    for (size_t i = mutator.pick(5) + 1; i > 0; --i) {
      mutator.mutate(text, all[mutator.pick(all.size())]);
    }
    SCOPED_TRACE(round);
    LLVMFuzzerTestOneInput(reinterpret_cast<const uint8_t*>(text.data()), text.size());
  }
}

}  // namespace
