// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/link/lld.h"

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

std::vector<std::string> arguments(const LinkJob& job, const Board& board,
                                   const std::string& object, const std::string& output) {
  const bool shared = job.kind == ProgramKind::SharedObject;
  std::vector<std::string> all{"ld.lld", "-o", output, "--gc-sections", "--threads=1",
                               "--build-id=none"};
  auto add = [&](std::initializer_list<std::string> more) { all.insert(all.end(), more); };
  if (shared) {
    add({"-shared", "-Bsymbolic", "-z", "defs"});
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
  all.push_back(object);
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

support::Failure explain(const std::string& said, const Board& board) {
  const std::string complaint = firstComplaint(said);
  if (complaint.starts_with(kUndefined)) {
    return support::fail(DiagnosticId::unboundSymbol, complaint.substr(kUndefined.size())).error();
  }
  return support::fail(DiagnosticId::linkFailed, board.name, complaint).error();
}

Result<void> runLld(const std::vector<std::string>& arguments, const Board& board) {
  static bool can_run = true;
  CHECK(can_run, "lld has failed in a way that it does not recover from");
  std::vector<const char*> pointers;
  std::ranges::transform(arguments, std::back_inserter(pointers),
                         [](const std::string& argument) { return argument.c_str(); });
  std::string said;
  llvm::raw_string_ostream stream(said);
  const lld::Result result =
      lld::lldMain(pointers, stream, stream, {{lld::Gnu, &lld::elf::link}});
  can_run = result.canRunAgain;
  if (result.retCode != 0) {
    return std::unexpected(explain(said, board));
  }
  return {};
}

}  // namespace

Result<std::string> link(const LinkJob& job, const Board& board) {
  auto scratch = ScratchFolder::make();
  if (!scratch) {
    return std::unexpected(scratch.error());
  }
  const std::filesystem::path object = scratch->path() / "mission.o";
  const std::filesystem::path output = scratch->path() / "linked";
  if (auto written = support::writeFileAtomically(object, job.object); !written) {
    return std::unexpected(written.error());
  }
  if (auto linked = runLld(arguments(job, board, object.string(), output.string()), board);
      !linked) {
    return std::unexpected(linked.error());
  }
  return support::readFile(output);
}

}  // namespace glider::codegen
