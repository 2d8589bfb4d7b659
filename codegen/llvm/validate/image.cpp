// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/validate/image.h"

#include <fmt/format.h>
#include <llvm/ADT/STLExtras.h>
#include <llvm/Object/ELFObjectFile.h>
#include <llvm/Support/MemoryBuffer.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

namespace glider::codegen {
namespace {

using llvm::object::ELFObjectFileBase;
using llvm::object::SectionRef;

constexpr const char* kWhat = "the linked program";

/// What a symbol names.
struct Piece {
  SectionRef section;
  uint64_t offset = 0;  ///< in the section's content
  uint64_t size = 0;
  std::string_view bytes;
};

/// The bits that linking fills in, of a relocation that is 32 bits wide; all for types that are not
/// distinguished.
uint32_t filledBits(std::string_view type) {
  constexpr uint32_t kAll = UINT32_MAX;
  struct Row {
    std::string_view type;
    uint32_t bits;
  };
  // An ARM's `bl` may become a `blx` for a function in Thumb: its first byte is compared apart.
  constexpr Row kRows[] = {{"R_ARM_CALL", 0x00FF'FFFF},        {"R_ARM_JUMP24", 0x00FF'FFFF},
                           {"R_ARM_MOVW_ABS_NC", 0x000F'0FFF}, {"R_ARM_MOVT_ABS", 0x000F'0FFF},
                           {"R_AARCH64_CALL26", 0x03FF'FFFF},  {"R_AARCH64_JUMP26", 0x03FF'FFFF}};
  for (const Row& row : kRows) {
    if (row.type == type) {
      return row.bits;
    }
  }
  return kAll;
}

/// Whether two instructions of a call on ARM differ only as linking may make them.
bool isSameCall(uint32_t in_object, uint32_t in_image) {
  constexpr uint32_t kBl = 0xEB00'0000;
  constexpr uint32_t kBlx = 0xFA00'0000;  // with one bit of the target
  return (in_object & 0xFF00'0000) == kBl && (in_image & 0xFE00'0000) == kBlx;
}

uint32_t wordAt(std::string_view bytes, uint64_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, sizeof word);
  return word;
}

/// The content of a file with its symbols.
class Elf {
 public:
  explicit Elf(const std::string& bytes) {
    auto made = llvm::object::ObjectFile::createObjectFile(llvm::MemoryBufferRef(bytes, "program"));
    if (made) {
      file_ = std::move(*made);
    } else {
      llvm::consumeError(made.takeError());
    }
  }

  [[nodiscard]] const ELFObjectFileBase* file() const {
    return llvm::dyn_cast_or_null<ELFObjectFileBase>(file_.get());
  }

  /// All functions and named constants, except for names that linking may drop.
  [[nodiscard]] std::multimap<std::string, Piece> pieces() const {
    std::multimap<std::string, Piece> found;
    for (const llvm::object::ELFSymbolRef& symbol : file()->symbols()) {
      const bool named = symbol.getELFType() == llvm::ELF::STT_FUNC ||
                         symbol.getELFType() == llvm::ELF::STT_OBJECT;
      auto name = symbol.getName();
      auto section = symbol.getSection();
      auto address = symbol.getAddress();
      if (!name || !section || !address) {
        llvm::consumeError(name.takeError());
        llvm::consumeError(section.takeError());
        llvm::consumeError(address.takeError());
        continue;
      }
      if (named && *section != file()->section_end() && !name->starts_with(".L")) {
        add(**section, name->str(), *address, symbol.getSize(), found);
      }
    }
    return found;
  }

 private:
  void add(const SectionRef& section, const std::string& name, uint64_t address, uint64_t size,
           std::multimap<std::string, Piece>& found) const {
    auto content = section.getContents();
    if (!content) {
      llvm::consumeError(content.takeError());
      return;
    }
    const uint64_t offset = address - section.getAddress();
    if (!section.isBSS() && offset + size <= content->size()) {
      found.emplace(name,
                    Piece{section, offset, size, std::string_view(content->data() + offset, size)});
    }
  }

  std::unique_ptr<llvm::object::ObjectFile> file_;
};

/// The content of a piece of an object, without what linking fills in.
class Expected {
 public:
  explicit Expected(const Piece& piece) : piece_(piece), compared_(piece.size, '\xFF') {
    for (const llvm::object::RelocationRef& relocation : relocationsOf(piece.section)) {
      const uint64_t at = relocation.getOffset();
      if (at >= piece.offset && at < piece.offset + piece.size) {
        llvm::SmallString<32> type;
        relocation.getTypeName(type);
        fill(at - piece.offset, type.str());
      }
    }
  }

  /// The first byte that differs.
  [[nodiscard]] std::optional<uint64_t> differsAt(std::string_view image) const {
    for (uint64_t i = 0; i < compared_.size(); ++i) {
      if (((piece_.bytes[i] ^ image[i]) & compared_[i]) != 0 && !isCall(i, image)) {
        return i;
      }
    }
    return {};
  }

 private:
  static std::vector<llvm::object::RelocationRef> relocationsOf(const SectionRef& section) {
    std::vector<llvm::object::RelocationRef> all;
    for (const SectionRef& other : section.getObject()->sections()) {
      auto relocated = other.getRelocatedSection();
      if (!relocated) {
        llvm::consumeError(relocated.takeError());
      } else if (*relocated != section.getObject()->section_end() && **relocated == section) {
        llvm::append_range(all, other.relocations());
      }
    }
    return all;
  }

  void fill(uint64_t at, std::string_view type) {
    const bool wide = type == "R_X86_64_64" || type == "R_AARCH64_ABS64";
    const uint32_t bits = filledBits(type);
    for (uint64_t i = 0; i < (wide ? 8U : 4U) && at + i < compared_.size(); ++i) {
      compared_[at + i] = static_cast<char>(~(bits >> 8 * (i % 4)));
    }
    if (type == "R_ARM_CALL") {
      calls_.push_back(at);
    }
    constexpr uint64_t kMostOpcode = 3;
    if (type.find("GOTPCRELX") != std::string_view::npos) {  // a load that linking may spare
      for (uint64_t i = 1; i <= kMostOpcode && i <= at; ++i) {
        compared_[at - i] = 0;
      }
    }
  }

  /// Whether byte `i` is the first of a call that linking has changed as it may.
  [[nodiscard]] bool isCall(uint64_t i, std::string_view image) const {
    return i >= 3 && llvm::is_contained(calls_, i - 3) &&
           isSameCall(wordAt(piece_.bytes, i - 3), wordAt(image, i - 3));
  }

  const Piece& piece_;
  std::string compared_;  ///< the bits that are compared
  std::vector<uint64_t> calls_;
};

/// Empty if one of the pieces of that name in the image is as the object has it.
std::string difference(const std::string& name, const Piece& piece,
                       const std::multimap<std::string, Piece>& image) {
  const Expected expected(piece);
  const auto [first, last] = image.equal_range(name);
  std::string words = fmt::format("`{}` is missing", name);
  for (auto one = first; one != last; ++one) {
    if (one->second.size != piece.size) {
      words = fmt::format("`{}` has another size", name);
      continue;
    }
    const auto at = expected.differsAt(one->second.bytes);
    if (!at) {
      return "";
    }
    words = fmt::format("`{}` differs at byte {} from what was compiled", name, *at);
  }
  return words;
}

}  // namespace

Validated compareImage(const std::vector<std::string>& objects, const std::string& image) {
  const Elf linked(image);
  if (linked.file() == nullptr) {
    return {kWhat, Verdict::Undecided, "it cannot be read"};
  }
  const auto pieces = linked.pieces();
  for (const std::string& object : objects) {
    const Elf compiled(object);
    if (compiled.file() == nullptr) {
      return {kWhat, Verdict::Undecided, "an object cannot be read"};
    }
    for (const auto& [name, piece] : compiled.pieces()) {
      if (std::string words = difference(name, piece, pieces); !words.empty()) {
        return {kWhat, Verdict::Differs, words};
      }
    }
  }
  return {kWhat, Verdict::Same, {}};
}

}  // namespace glider::codegen
