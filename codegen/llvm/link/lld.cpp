// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/link/lld.h"

#include "codegen/scratch_folder.h"
#include "ir/core/c_symbols.h"
#include "support/diagnostics/ids/files.h"
#include "support/diagnostics/ids/target.h"
#include "support/files.h"

#include <fmt/ranges.h>
#include <lld/Common/Driver.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <sys/wait.h>
#include <unistd.h>

LLD_HAS_DRIVER(elf)

namespace glider::codegen {
namespace {

using platforms::Board;
using support::Result;

constexpr std::string_view kUndefined = "undefined symbol: ";

/// Whether it is a library, not code that starts a program: a shared object takes only these of a
/// board's inputs.
bool isLibrary(const std::string& name) {
  return name.ends_with(".a") || name.find(".so") != std::string::npos;
}

/// The files in the scratch folder.
struct ScratchFiles {
  std::vector<std::filesystem::path> objects;
  std::filesystem::path exports;
  std::filesystem::path output;
};

/// A version script: the exports of a shared object, so that --gc-sections can drop everything
/// else.
std::string exportList(const std::vector<std::string>& names) {
  return fmt::format("{{ {}local: *; }};\n",
                     names.empty() ? "" : fmt::format("global: {}; ", fmt::join(names, "; ")));
}

std::vector<std::string> arguments(const LinkJob& job, const Board& board,
                                   const ScratchFiles& files) {
  const bool shared = job.kind == ProgramKind::SharedObject;
  std::vector<std::string> all{"ld.lld",        "-o",          files.output.string(),
                               "--gc-sections", "--threads=1", "--build-id=none"};
  auto add = [&](std::initializer_list<std::string> more) { all.insert(all.end(), more); };
  if (shared) {
    add({"-shared", "-Bsymbolic", "-z", "defs", "--version-script", files.exports.string()});
  } else if (board.relocation == platforms::Relocation::PositionIndependent) {
    add({"-pie", "-z", "now", "--dynamic-linker", board.link.dynamic_linker});
  } else {
    // Beyond every number that code is likely to contain: what bounds the stack takes a number that
    // is a function's address for a pointer to it.
    // None is made read-only when it starts, so nothing is apart for that.
    add({"-static", "--image-base=0x2000000", "-z", "norelro"});
  }
  all.insert(all.end(), board.link.options.begin(), board.link.options.end());
  if (!job.keep_debug) {
    add({"--strip-all"});
  }
  auto addInputs = [&](const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      if (!shared || isLibrary(name)) {
        all.push_back((board.folder / name).string());
      }
    }
  };
  addInputs(board.link.before);
  for (const auto& object : files.objects) {
    all.push_back(object.string());
  }
  for (const auto& input : job.further_inputs) {
    all.push_back(input.string());
  }
  addInputs(board.link.after);
  return all;
}

/// The first line of lld's message, without its own name.
std::string firstComplaint(const std::string& said) {
  constexpr std::string_view kError = "error: ";
  const size_t at = said.find(kError);
  const size_t begin = at == std::string::npos ? 0 : at + kError.size();
  return said.substr(begin, said.find('\n', begin) - begin);
}

/// Names an undefined symbol as the mission's text does, if it comes from there.
support::Failure unbound(const std::string& symbol) {
  const auto declared = ir::readSymbol(symbol);
  return support::fail(
             support::diagnostics::unboundSymbol, declared ? declared->declaration : symbol,
             declared ? "write it in C or C++ with the header from `glidercc build --emit header`, "
                        "and add its object with `--link FILE`"
                      : "add the object or archive that defines it with `--link FILE`; a board has "
                        "a C library, but no C++ library")
      .error();
}

support::Failure explain(const std::string& said, const Board& board,
                         const std::filesystem::path& output) {
  const std::string complaint = firstComplaint(said);
  const size_t reason = complaint.rfind(": ");
  if (complaint.find(output.string()) != std::string::npos && reason != std::string::npos) {
    return support::fail(support::diagnostics::cannotWrite, output.string(),
                         complaint.substr(reason + 2))
        .error();
  }
  if (complaint.starts_with(kUndefined)) {
    return unbound(complaint.substr(kUndefined.size()));
  }
  return support::fail(support::diagnostics::linkFailed, board.name, complaint).error();
}

/// Runs lld, which writes its messages to `said`; true if it has linked.
bool runHere(const std::vector<std::string>& words, const std::filesystem::path& said) {
  std::vector<const char*> pointers;
  std::ranges::transform(words, std::back_inserter(pointers),
                         [](const std::string& word) { return word.c_str(); });
  std::error_code error;
  llvm::raw_fd_ostream stream(said.string(), error);
  const lld::Result result = lld::lldMain(pointers, stream, stream, {{lld::Gnu, &lld::elf::link}});
  stream.close();
  stream.clear_error();  // a full disk: the result is still valid
  return result.retCode == 0 && !error;
}

/// The same in a child of this process, which lld may end in any way.
bool runInChild(const std::vector<std::string>& words, const std::filesystem::path& said) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(runHere(words, said) ? EXIT_SUCCESS : EXIT_FAILURE);
  }
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return child > 0 && WIFEXITED(status) && WEXITSTATUS(status) == EXIT_SUCCESS;
}

/// lld keeps pointers into its last run in static variables and writes through them in the next
/// (`_GLOBAL_OFFSET_TABLE_` and similar symbols), so a process may run it only once.
Result<void> runLld(const LinkJob& job, const Board& board, const ScratchFiles& files) {
  const std::vector<std::string> words = arguments(job, board, files);
  const std::filesystem::path said = files.output.parent_path() / "said";
  if (job.last ? runHere(words, said) : runInChild(words, said)) {
    return {};
  }
  const std::string text = support::readFile(said).value_or("");
  if (!text.empty()) {
    return std::unexpected(explain(text, board, files.output));
  }
  return support::fail(support::diagnostics::linkFailed, board.name,
                       "the linker ended without a message");
}

}  // namespace

Result<std::string> link(const LinkJob& job, const Board& board) {
  auto scratch = ScratchFolder::make();
  if (!scratch) {
    return std::unexpected(scratch.error());
  }
  std::vector<std::filesystem::path> objects;
  for (const std::string& object : job.objects) {
    auto file = scratch->write(fmt::format("mission{}.o", objects.size()), object);
    if (!file) {
      return std::unexpected(file.error());
    }
    objects.push_back(std::move(*file));
  }
  const auto exports = scratch->write("exports", exportList(job.exports));
  if (!exports) {
    return std::unexpected(exports.error());
  }
  const std::filesystem::path output = scratch->path() / "linked";
  const auto linked = runLld(job, board, {objects, *exports, output});
  if (!linked) {
    return std::unexpected(linked.error());
  }
  return support::readFile(output);
}

}  // namespace glider::codegen
