// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/user_code/user_file.h"

#include "codegen/llvm/user_code/bitcode.h"
#include "codegen/llvm/user_code/machine_check.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"

#include <llvm/BinaryFormat/Magic.h>
#include <llvm/Object/Archive.h>
#include <llvm/Object/ELFObjectFile.h>
#include <llvm/Support/MemoryBuffer.h>

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

std::unexpected<support::Failure> refuse(const std::string& name, llvm::Error error) {
  return support::fail(support::diagnostics::notLinkable, name, llvm::toString(std::move(error)));
}

/// Checks one object and adds what it defines.
Result<void> readObject(llvm::MemoryBufferRef buffer, const Board& board, UserFile& file) {
  const std::string name = buffer.getBufferIdentifier().str();
  auto object = llvm::object::ObjectFile::createELFObjectFile(buffer);
  if (!object) {
    return refuse(name, object.takeError());
  }
  const auto& elf = llvm::cast<llvm::object::ELFObjectFileBase>(**object);
  if (auto fits = checkMachine(elf, name, board); !fits) {
    return fits;
  }
  for (const llvm::object::ELFSymbolRef symbol : elf.symbols()) {
    auto flags = symbol.getFlags();
    auto text = symbol.getName();
    if (!flags || !text) {
      return refuse(name, flags ? text.takeError() : flags.takeError());
    }
    using llvm::object::SymbolRef;
    if ((*flags & SymbolRef::SF_Undefined) == 0 && (*flags & SymbolRef::SF_Global) != 0) {
      file.defines.push_back(text->str());
    }
  }
  return {};
}

Result<void> readArchive(const Board& board, UserFile& file) {
  auto archive = llvm::object::Archive::create({file.content, file.name});
  if (!archive) {
    return refuse(file.name, archive.takeError());
  }
  llvm::Error error = llvm::Error::success();
  Result<void> result;
  for (const auto& child : (*archive)->children(error)) {
    auto buffer = child.getMemoryBufferRef();
    if (!buffer) {
      result = refuse(file.name, buffer.takeError());
    } else if (const std::string member =
                   file.name + "(" + buffer->getBufferIdentifier().str() + ")";
               llvm::identify_magic(buffer->getBuffer()) != llvm::file_magic::elf_relocatable) {
      result = support::fail(support::diagnostics::notLinkable, member,
                             "an archive can contain only objects for the board");
    } else {
      result = readObject({buffer->getBuffer(), member}, board, file);
    }
    if (!result) {
      break;
    }
  }
  if (error && result) {
    return refuse(file.name, std::move(error));
  }
  llvm::consumeError(std::move(error));
  return result;
}

}  // namespace

Result<UserFile> readUserFile(const std::filesystem::path& path, const Board& board,
                              const ScratchFolder& scratch) {
  auto content = support::readFile(path);
  if (!content) {
    return std::unexpected(content.error());
  }
  UserFile file{path.string(), std::move(*content), {}};
  const llvm::file_magic magic = llvm::identify_magic(file.content);
  if (magic == llvm::file_magic::bitcode) {
    auto object = compileBitcode(file.name, file.content, board, scratch);
    if (!object) {
      return std::unexpected(object.error());
    }
    file.content = std::move(*object);
  } else if (magic != llvm::file_magic::archive && magic != llvm::file_magic::elf_relocatable) {
    const bool linked =
        magic == llvm::file_magic::elf_executable || magic == llvm::file_magic::elf_shared_object;
    return support::fail(support::diagnostics::notLinkable, file.name,
                         linked ? "it is a program or a shared library"
                                : "it is not an object, an archive or bitcode");
  }
  const auto read = magic == llvm::file_magic::archive
                        ? readArchive(board, file)
                        : readObject({file.content, file.name}, board, file);
  return read ? Result<UserFile>(std::move(file)) : std::unexpected(read.error());
}

}  // namespace glider::codegen
