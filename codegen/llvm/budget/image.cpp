// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/budget/image.h"

#include "codegen/llvm/budget/disassembler.h"
#include "codegen/llvm/budget/pointer_jump.h"
#include "codegen/llvm/budget/taken.h"
#include "support/diagnostics/ids/target.h"

#include <llvm/DebugInfo/DWARF/DWARFContext.h>
#include <llvm/Demangle/Demangle.h>
#include <llvm/Object/ELFObjectFile.h>
#include <llvm/Support/MemoryBuffer.h>

#include <algorithm>
#include <cstring>
#include <set>
#include <tuple>
#include <utility>

namespace glider::codegen {
namespace {

using llvm::object::ELFObjectFileBase;
using support::Result;

/// A function by its symbol.
struct Symbol {
  uint64_t address = 0;
  uint64_t size = 0;
  std::string name;
};

/// Bytes of the file that are loaded.
struct Segment {
  uint64_t address = 0;
  uint64_t size = 0;
  const char* bytes = nullptr;
};

/// A part of a mangled name; a C name unchanged.
std::string demangled(const std::string& mangled,
                      char* (llvm::ItaniumPartialDemangler::*part)(char*, size_t*) const) {
  llvm::ItaniumPartialDemangler demangler;
  if (demangler.partialDemangle(mangled.c_str()) || !demangler.isFunction()) {
    return mangled;
  }
  size_t size = 0;
  char* name = (demangler.*part)(nullptr, &size);
  std::string found = name != nullptr ? name : mangled;
  std::free(name);
  return found;
}

/// "takeUpdates" for "_ZN6glider7runtime11takeUpdatesE…".
std::string baseName(const std::string& mangled) {
  return demangled(mangled, &llvm::ItaniumPartialDemangler::getFunctionBaseName);
}

/// The name of a template without its arguments.
std::string plain(const std::string& name) {
  return name.substr(0, name.find('<'));
}

std::string lastPart(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

/// What sections of code contain, by ARM's mapping symbols: `$a` (in 64 bits `$x`), `$t`, `$d`.
class Stretches {
 public:
  /// Whether `symbol` is a mapping symbol.
  bool add(llvm::StringRef symbol, uint64_t address) {
    const bool marks =
        symbol.size() > 1 && symbol[0] == '$' && llvm::StringRef("axtd").contains(symbol[1]);
    if (marks) {
      marks_.emplace_back(address, symbol[1]);
    }
    return marks;
  }
  void sort() { std::ranges::sort(marks_); }
  [[nodiscard]] bool isData(uint64_t address) const { return at(address) == 'd'; }
  [[nodiscard]] Encoding encoding(uint64_t address) const {
    return at(address) == 't' ? Encoding::Thumb : Encoding::Usual;
  }

 private:
  [[nodiscard]] char at(uint64_t address) const {
    const auto after = std::ranges::upper_bound(marks_, std::pair(address, '\x7f'));
    return after == marks_.begin() ? 'a' : std::prev(after)->second;
  }
  std::vector<std::pair<uint64_t, char>> marks_;
};

}  // namespace

struct Image::Parts {
  std::unique_ptr<llvm::MemoryBuffer> bytes;
  std::unique_ptr<llvm::object::ObjectFile> file;
  std::unique_ptr<llvm::DWARFContext> lines;
  std::vector<Symbol> symbols;  // functions, by address
  uint64_t context_bytes = 0;
  Stretches stretches;
  std::vector<Instruction> code;
  std::vector<Segment> segments;
  uint64_t loaded = 0;
  uint64_t writable = 0;
  uint64_t offsets =
      0;  // _GLOBAL_OFFSET_TABLE_, the base of offsets in x86's position-independent code
  std::vector<uint64_t> taken;

  void readSymbols();
  void readSegments();
  void readCode(Disassembler& disassembler);
  void makeRoom(Instruction& one) const;
  void doubtCounts();
  void doubtCounts(const std::set<uint64_t>& targets);
  void doubtPointers(const std::set<uint64_t>& held);
  void findTaken();
  [[nodiscard]] bool isThumbCode(uint64_t place) const;
  [[nodiscard]] std::set<uint64_t> words() const;
  [[nodiscard]] std::optional<uint32_t> wordAt(uint64_t address) const { return read(address, 4); }
  [[nodiscard]] std::optional<uint32_t> read(uint64_t address, uint32_t size) const;
  [[nodiscard]] const Symbol* symbolOf(uint64_t address) const;
  [[nodiscard]] std::optional<uint32_t> at(uint64_t address) const;
  [[nodiscard]] std::vector<uint64_t> tableTargets(const Instruction& jump) const;
};

void Image::Parts::readSymbols() {
  for (const llvm::object::ELFSymbolRef symbol : llvm::cast<ELFObjectFileBase>(*file).symbols()) {
    const auto name = llvm::expectedToOptional(symbol.getName());
    const auto address = llvm::expectedToOptional(symbol.getAddress());
    const auto section = llvm::expectedToOptional(symbol.getSection());
    if (!name || !address || !section || *section == file->section_end()) {
      continue;
    }
    if (*name == "_GLOBAL_OFFSET_TABLE_") {
      offsets = *address;
    }
    if (stretches.add(*name, *address)) {
      continue;
    }
    if (symbol.getELFType() == llvm::ELF::STT_FUNC) {
      symbols.push_back({*address, symbol.getSize(), name->str()});
    } else if (*name == "gliderContextMemory") {
      context_bytes = symbol.getSize();
    }
  }
  stretches.sort();
  // At the same address the largest comes first: aliases have the same size.
  std::ranges::sort(symbols, [](const Symbol& a, const Symbol& b) {
    return std::tuple(a.address, b.size, a.name) < std::tuple(b.address, a.size, b.name);
  });
}

void Image::Parts::readSegments() {
  auto take = [&](const auto& elf) {
    const auto headers = llvm::cantFail(elf.program_headers());
    for (const auto& segment : headers) {
      if (segment.p_type == llvm::ELF::PT_LOAD) {
        loaded += segment.p_memsz;
        writable += (segment.p_flags & llvm::ELF::PF_W) != 0 ? uint64_t{segment.p_memsz} : 0;
        const char* begin = bytes->getBufferStart() + segment.p_offset;
        segments.push_back({segment.p_vaddr, segment.p_filesz, begin});
      }
    }
  };
  if (const auto* small = llvm::dyn_cast<llvm::object::ELF32LEObjectFile>(file.get())) {
    take(small->getELFFile());
  } else if (const auto* large = llvm::dyn_cast<llvm::object::ELF64LEObjectFile>(file.get())) {
    take(large->getELFFile());
  }
}

/// Whether a word is instructions in Thumb: two of them may look like an address, as `movs r0, #1`
/// and `lsls r1, r0, #8` do.
bool Image::Parts::isThumbCode(uint64_t place) const {
  const auto after = std::ranges::upper_bound(code, place, {}, &Instruction::address);
  return after != code.begin() && place < std::prev(after)->address + std::prev(after)->size &&
         stretches.encoding(place) == Encoding::Thumb;
}

/// All loaded words, except instructions in Thumb, and distances from a place in the code: those
/// are not addresses, although the numbers may be the same.
std::set<uint64_t> Image::Parts::words() const {
  const std::set<uint64_t> distances = distancesIn(code);
  std::set<uint64_t> held;
  for (const Segment& segment : segments) {
    for (uint64_t place = 0; place + sizeof(uint32_t) <= segment.size; place += sizeof(uint32_t)) {
      uint32_t word = 0;  // the processors of both boards and of this machine are little-endian
      std::memcpy(&word, segment.bytes + place, sizeof word);
      if (!distances.contains(segment.address + place) && !isThumbCode(segment.address + place)) {
        held.insert(word);
      }
    }
  }
  return held;
}

void Image::Parts::readCode(Disassembler& disassembler) {
  for (const llvm::object::SectionRef section : file->sections()) {
    const auto content =
        section.isText() ? llvm::expectedToOptional(section.getContents()) : std::nullopt;
    if (!content) {
      continue;
    }
    for (uint64_t at = 0; at < content->size();) {
      const uint64_t address = section.getAddress() + at;
      if (stretches.isData(address) && !disassembler.isTrap(content->substr(at))) {
        at += sizeof(uint32_t);
        continue;
      }
      Instruction one =
          disassembler.read(content->substr(at), address, stretches.encoding(address));
      // The table of an ARM switch comes immediately after it.
      if (one.flow == Flow::JumpByTable && one.target == 0 &&
          stretches.isData(address + one.size)) {
        one.target = address + one.size;
      }
      makeRoom(one);
      code.push_back(one);
      at += one.size;
    }
  }
  std::ranges::sort(code, {}, &Instruction::address);
  doubtCounts();
}

/// What an instruction adds to the stack pointer, of which it names the place alone.
void Image::Parts::makeRoom(Instruction& one) const {
  const auto word = one.mentions.stack_word != 0 ? wordAt(one.mentions.stack_word) : std::nullopt;
  if (word) {
    one.stack.known = true;
    one.stack.to = one.stack.from = kArmStack.pointer;
    one.stack.bytes = -int64_t{static_cast<int32_t>(*word)};
  }
}

/// A jump to between the instruction that sets a count, chooses a table or loads a word, and the
/// one that uses it, may bring another value.
void Image::Parts::doubtCounts() {
  const std::set<uint64_t> held = words();
  std::set<uint64_t> targets = held;
  for (const Instruction& one : code) {
    if (one.flow == Flow::Jump || one.flow == Flow::JumpIf || one.flow == Flow::Call) {
      targets.insert(one.target);
    }
  }
  doubtCounts(targets);
  for (const Instruction& one : code) {
    if (one.flow == Flow::JumpByTable && one.entries.distances()) {
      const std::vector<uint64_t> chosen = tableTargets(one);
      targets.insert(chosen.begin(), chosen.end());
    }
  }
  doubtCounts(targets);
  doubtPointers(held);
}

void Image::Parts::doubtPointers(const std::set<uint64_t>& held) {
  const StartOf start_of = [this](uint64_t address) {
    const Symbol* symbol = symbolOf(address);
    return symbol == nullptr ? 0 : symbol->address;
  };
  std::vector<uint32_t> doubtful;
  const PointerJumps jumps(code, start_of, held);
  for (uint32_t i = 0; i < code.size(); ++i) {
    if (code[i].pointer != StackEffect::kNone && !jumps.leaves(i)) {
      doubtful.push_back(i);
    }
  }
  for (const uint32_t place : doubtful) {
    code[place].flow = Flow::Unknown;
  }
}

void Image::Parts::doubtCounts(const std::set<uint64_t>& targets) {
  const auto entered = [&](const Instruction& one) {
    const auto next = targets.upper_bound(one.counted_at);
    return next != targets.end() && *next <= one.address;
  };
  for (Instruction& one : code) {
    if (one.repeats >= 0 && entered(one)) {
      one.repeats = Instruction::kUncounted;
    }
    if (one.flow == Flow::JumpByTable && one.entries.distances() && entered(one)) {
      one.flow = Flow::Unknown;
    }
    if (one.choices > 0 && entered(one)) {
      one.choices = 0;
    }
    if (one.mentions.stack_word != 0 && entered(one)) {
      one.stack.known = false;
      one.stack.to = StackEffect::kNone;
    }
  }
}

/// From words that are loaded, and from the code.
void Image::Parts::findTaken() {
  std::set<uint64_t> addresses = addressesIn(
      code, offsets, [&](uint64_t address) { return wordAt(address); },
      [&](uint64_t address) {
        const Symbol* symbol = symbolOf(address);
        return symbol == nullptr ? 0 : symbol->address;
      });
  addresses.merge(words());
  for (const Symbol& symbol : symbols) {
    const bool odd = stretches.encoding(symbol.address) == Encoding::Thumb;  // its pointer
    if (addresses.contains(symbol.address + (odd ? 1 : 0)) &&
        (taken.empty() || taken.back() != symbol.address)) {
      taken.push_back(symbol.address);
    }
  }
}

/// The number of `size` bytes that is loaded at an address.
std::optional<uint32_t> Image::Parts::read(uint64_t address, uint32_t size) const {
  for (const Segment& segment : segments) {
    if (address >= segment.address && address + size <= segment.address + segment.size) {
      uint32_t word = 0;
      std::memcpy(&word, segment.bytes + (address - segment.address), size);
      return word;
    }
  }
  return std::nullopt;
}

const Symbol* Image::Parts::symbolOf(uint64_t address) const {
  auto after = std::ranges::upper_bound(symbols, address, {}, &Symbol::address);
  if (after == symbols.begin()) {
    return nullptr;
  }
  const uint64_t start = std::prev(after)->address;
  const auto first = std::ranges::lower_bound(symbols, start, {}, &Symbol::address);
  return first->size == 0 || address < first->address + first->size ? &*first : nullptr;
}

std::optional<uint32_t> Image::Parts::at(uint64_t address) const {
  const auto found = std::ranges::lower_bound(code, address, {}, &Instruction::address);
  if (found == code.end() || found->address != address) {
    return std::nullopt;
  }
  return static_cast<uint32_t>(found - code.begin());
}

std::vector<uint64_t> Image::Parts::tableTargets(const Instruction& jump) const {
  std::vector<uint64_t> targets;
  const Symbol* symbol = symbolOf(jump.address);
  const uint64_t zero = jump.entries.from_offsets ? offsets : 0;
  const auto base = static_cast<uint32_t>(jump.entries.base + zero);
  uint64_t at_entry = static_cast<uint32_t>(jump.target + zero);
  while (symbol != nullptr && (jump.choices == 0 || targets.size() < jump.choices)) {
    const auto entry = read(at_entry, jump.entries.bytes);
    const uint32_t target = (entry.value_or(0) << jump.entries.shift) + base;
    const bool inside =
        entry && target >= symbol->address && target < symbol->address + symbol->size;
    if (!inside || !at(target)) {
      return jump.choices == 0 ? targets : std::vector<uint64_t>{};
    }
    targets.push_back(target);
    at_entry += jump.entries.bytes;
  }
  return targets;
}

Image::Image(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
Image::Image(Image&&) noexcept = default;
Image::~Image() = default;

Result<Image> Image::read(const std::string& linked, const platforms::Board& board) {
  auto parts = std::make_unique<Parts>();
  parts->bytes = llvm::MemoryBuffer::getMemBufferCopy(linked, "linked");
  auto file = llvm::object::ObjectFile::createELFObjectFile(parts->bytes->getMemBufferRef());
  if (!file) {
    return support::fail(support::diagnostics::linkFailed, board.name,
                         llvm::toString(file.takeError()));
  }
  parts->file = std::move(*file);
  parts->lines = llvm::DWARFContext::create(*parts->file);
  parts->readSymbols();
  parts->readSegments();
  if (Disassembler::knows(board)) {
    auto disassembler = Disassembler::make(board);
    if (!disassembler) {
      return std::unexpected(disassembler.error());
    }
    parts->readCode(**disassembler);
    parts->findTaken();
  }
  return Image(std::move(parts));
}

const std::vector<Instruction>& Image::code() const {
  return parts_->code;
}

std::optional<uint32_t> Image::at(uint64_t address) const {
  return parts_->at(address);
}

std::optional<uint64_t> Image::function(const std::string& name) const {
  const auto found = std::ranges::find(parts_->symbols, name, &Symbol::name);
  return found == parts_->symbols.end() ? std::nullopt : std::optional(found->address);
}

std::vector<uint64_t> Image::functionsNamed(const std::string& prefix) const {
  std::vector<uint64_t> found;
  for (const Symbol& symbol : parts_->symbols) {
    if (symbol.name.starts_with(prefix)) {
      found.push_back(symbol.address);
    }
  }
  return found;
}

std::string Image::symbolAt(uint64_t address) const {
  const Symbol* symbol = parts_->symbolOf(address);
  return symbol == nullptr ? "" : symbol->name;
}

std::vector<Frame> Image::framesAt(uint64_t address) const {
  using Specifier = llvm::DILineInfoSpecifier;
  const llvm::DIInliningInfo inlined = parts_->lines->getInliningInfoForAddress(
      {address, llvm::object::SectionedAddress::UndefSection},
      Specifier(Specifier::FileLineInfoKind::RawValue, Specifier::FunctionNameKind::ShortName));
  std::vector<Frame> frames;
  for (uint32_t i = 0; i < inlined.getNumberOfFrames(); ++i) {
    const llvm::DILineInfo& frame = inlined.getFrame(i);
    const bool known = frame.FileName != llvm::DILineInfo::BadString;
    frames.push_back(
        {known ? lastPart(frame.FileName) : "",
         frame.FunctionName != llvm::DILineInfo::BadString ? plain(frame.FunctionName) : "",
         frame.Line});
  }
  if (frames.empty()) {
    frames.emplace_back();
  }
  // Line tables name only functions that were inlined and the functions they were inlined into.
  frames.back().function = plain(baseName(symbolAt(address)));
  return frames;
}

std::vector<uint64_t> Image::tableTargets(const Instruction& jump) const {
  return parts_->tableTargets(jump);
}

std::vector<uint64_t> Image::aheadTargets(const Instruction& jump) const {
  std::vector<uint64_t> targets;
  const uint64_t end =
      jump.choices > 0 ? jump.target + jump.choices * sizeof(uint32_t) : endOfSymbol(jump.address);
  for (uint64_t target = jump.target; target < end; target += sizeof(uint32_t)) {
    if (at(target)) {
      targets.push_back(target);
    }
  }
  return targets;
}

const std::vector<uint64_t>& Image::takenFunctions() const {
  return parts_->taken;
}

std::vector<uint64_t> Image::functionsCalled(const std::string& name) const {
  std::vector<uint64_t> found;
  for (const Symbol& symbol : parts_->symbols) {
    if (symbol.name == name) {
      found.push_back(symbol.address);
    }
  }
  return found;
}

std::string Image::baseNameAt(uint64_t address) const {
  return plain(baseName(symbolAt(address)));
}

std::string Image::fullNameAt(uint64_t address) const {
  return demangled(symbolAt(address), &llvm::ItaniumPartialDemangler::getFunctionName);
}

uint64_t Image::startOfSymbol(uint64_t address) const {
  const Symbol* symbol = parts_->symbolOf(address);
  return symbol == nullptr ? 0 : symbol->address;
}

uint64_t Image::endOfSymbol(uint64_t address) const {
  const Symbol* symbol = parts_->symbolOf(address);
  return symbol == nullptr ? 0 : symbol->address + symbol->size;
}

uint64_t Image::entry() const {
  const auto* elf = llvm::dyn_cast<ELFObjectFileBase>(parts_->file.get());
  const uint64_t start = llvm::cantFail(elf->getStartAddress());
  return parts_->at(start) ? start : start & ~uint64_t{1};  // odd in Thumb
}

uint64_t Image::contextBytes() const {
  return parts_->context_bytes;
}

uint64_t Image::loadedBytes() const {
  return parts_->loaded;
}

uint64_t Image::writableBytes() const {
  return parts_->writable;
}

}  // namespace glider::codegen
