// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/link/lld.h"

#include <fmt/ranges.h>
#include <lld/Common/Driver.h>
#include <llvm/Support/raw_ostream.h>

#include <algorithm>

#include "codegen/link/scratch_folder.h"
#include "support/check.h"
#include "support/files.h"

LLD_HAS_DRIVER(elf)

namespace glider::codegen {
namespace {

using platforms::Board;
using support::DiagnosticId;
using support::Result;

constexpr std::string_view kUndefined = "undefined symbol: ";

/// What is not code that starts a program: a shared object takes only these of a board's inputs.
bool isLibrary(const std::string& name) {
  return name.ends_with(".a") || name.find(".so") != std::string::npos;
}

/// The files in our scratch folder.
struct ScratchFiles {
  std::filesystem::path object;
  std::filesystem::path exports;
  std::filesystem::path output;
};

/// A version script: what a shared object shows, so that --gc-sections can drop all else.
std::string exportList(const std::vector<std::string>& names) {
  return fmt::format("{{ {}local: *; }};\n",
                     names.empty() ? "" : fmt::format("global: {}; ", fmt::join(names, "; ")));
}

std::vector<std::string> arguments(const LinkJob& job, const Board& board,
                                   const ScratchFiles& files) {
  const bool shared = job.kind == ProgramKind::SharedObject;
  std::vector<std::string> all{"ld.lld", "-o", files.output.string(), "--gc-sections", "--threads=1",
                               "--build-id=none"};
  auto add = [&](std::initializer_list<std::string> more) { all.insert(all.end(), more); };
  if (shared) {
    add({"-shared", "-Bsymbolic", "-z", "defs", "--version-script", files.exports.string()});
  } else if (board.relocation == platforms::Relocation::PositionIndependent) {
    add({"-pie", "-z", "now", "--dynamic-linker", board.link.dynamic_linker});
  } else {
    add({"-static"});
  }
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
  all.push_back(files.object.string());
  for (const auto& input : job.further_inputs) {
    all.push_back(input.string());
  }
  addInputs(board.link.after);
  return all;
}

/// The first line of lld's complaint, without its own name.
std::string firstComplaint(const std::string& said) {
  constexpr std::string_view kError = "error: ";
  const size_t at = said.find(kError);
  const size_t begin = at == std::string::npos ? 0 : at + kError.size();
  return said.substr(begin, said.find('\n', begin) - begin);
}

support::Failure explain(const std::string& said, const Board& board,
                         const std::filesystem::path& output) {
  const std::string complaint = firstComplaint(said);
  const size_t reason = complaint.rfind(": ");
  if (complaint.find(output.string()) != std::string::npos && reason != std::string::npos) {
    return support::fail(DiagnosticId::cannotWrite, output.string(), complaint.substr(reason + 2))
        .error();
  }
  if (complaint.starts_with(kUndefined)) {
    return support::fail(DiagnosticId::unboundSymbol, complaint.substr(kUndefined.size())).error();
  }
  return support::fail(DiagnosticId::linkFailed, board.name, complaint).error();
}

Result<void> runLld(const LinkJob& job, const Board& board, const ScratchFiles& files) {
  static bool can_run = true;
  CHECK(can_run, "lld has failed in a way that it does not recover from");
  const std::vector<std::string> words = arguments(job, board, files);
  std::vector<const char*> pointers;
  std::ranges::transform(words, std::back_inserter(pointers),
                         [](const std::string& argument) { return argument.c_str(); });
  std::string said;
  llvm::raw_string_ostream stream(said);
  const lld::Result result =
      lld::lldMain(pointers, stream, stream, {{lld::Gnu, &lld::elf::link}});
  can_run = result.canRunAgain;
  if (result.retCode != 0) {
    return std::unexpected(explain(said, board, files.output));
  }
  return {};
}

}  // namespace

Result<std::string> link(const LinkJob& job, const Board& board) {
  auto scratch = ScratchFolder::make();
  if (!scratch) {
    return std::unexpected(scratch.error());
  }
  const auto object = scratch->write("mission.o", job.object);
  if (!object) {
    return std::unexpected(object.error());
  }
  const auto exports = scratch->write("exports", exportList(job.exports));
  if (!exports) {
    return std::unexpected(exports.error());
  }
  const std::filesystem::path output = scratch->path() / "linked";
  const auto linked = runLld(job, board, {*object, *exports, output});
  if (!linked) {
    return std::unexpected(linked.error());
  }
  return support::readFile(output);
}

}  // namespace glider::codegen
