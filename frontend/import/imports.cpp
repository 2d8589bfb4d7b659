// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/import/imports.h"

#include "frontend/frontend.h"
#include "frontend/import/waypoint_list.h"
#include "support/diagnostics/ids/meaning.h"
#include "support/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace glider::frontend {

using support::DiagnosticId;
namespace fs = std::filesystem;

namespace {

constexpr size_t kLongestChain = 8;

/// The text between the quotes, `\x` read as x.
std::string unquoted(const std::string& written) {
  std::string out;
  for (size_t i = 1; i + 1 < written.size(); ++i) {
    i += written[i] == '\\' ? 1U : 0U;
    out += written[i];
  }
  return out;
}

/// The same text for a file under any of its names.
std::string identity(const fs::path& path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(path, error);
  return error ? path.lexically_normal().string() : real.string();
}

/// The file that `name` refers to beside `importer`.
fs::path locate(const fs::path& importer, const std::string& name) {
  const fs::path plain = (importer.parent_path() / name).lexically_normal();
  if (plain.extension() == ".mission" || isWaypointList(plain)) {
    return plain;
  }
  fs::path full = plain;
  full += ".mission";
  std::error_code ignored;
  return !fs::exists(full, ignored) && fs::exists(plain, ignored) ? plain : full;
}

/// How an imported file is parsed: `parse`, or parseIntact.
using Parser = std::optional<ast::File> (*)(const support::SourceManager&, uint32_t,
                                            support::DiagnosticEngine&);

class Importer {
 public:
  Importer(support::SourceManager& sources, support::DiagnosticEngine& diagnostics, Parser parser)
      : sources_(sources), diagnostics_(diagnostics), parser_(parser) {}

  /// The depth is bounded by kLongestChain.
  void importAll(const ast::File& file) {
    const std::string path = sources_.name(file.file);
    chain_.push_back({path, identity(path), {}});
    for (const ast::Item& item : file.items) {
      if (const auto* import = std::get_if<ast::Import>(&item)) {
        chain_.back().import = import->where;
        importOne(path, *import);
      }
    }
    chain_.pop_back();
  }

  [[nodiscard]] bool whole() const { return whole_; }
  std::deque<ast::File> take() { return std::move(files_); }

 private:
  /// A file that is being read, and the import in it that is being followed.
  struct Link {
    std::string name;
    std::string identity;
    support::SourceRange import;
  };

  void importOne(const std::string& importer, const ast::Import& import) {
    const std::string name = unquoted(import.path);
    if (name.empty()) {
      noteChain(report(support::diagnostics::emptyImport, import.where));
      return;
    }
    const fs::path path = locate(importer, name);
    const std::string id = identity(path);
    const auto open = std::ranges::find(chain_, id, &Link::identity);
    if (open != chain_.end()) {
      refuseCycle(import, open);
      return;
    }
    if (isWaypointList(path)) {
      importWaypoints(path, import);
      return;
    }
    if (import.as) {
      noteChain(
          report(support::diagnostics::nameForMission, import.where, import.path, import.as->text));
      return;
    }
    if (known_.contains(id)) {
      return;
    }
    if (chain_.size() > kLongestChain) {
      noteChain(report(support::diagnostics::importsTooDeep, import.where, kLongestChain));
      return;
    }
    known_.insert(id);
    read(path, import);
  }

  /// Each import of a list declares a path of its own, also of a file that was read before.
  void importWaypoints(const fs::path& path, const ast::Import& import) {
    if (!import.as) {
      noteChain(report(support::diagnostics::waypointsNeedName, import.where, import.path));
      return;
    }
    const auto number = add(path, import);
    auto list = number ? readWaypointList(sources_, *number, *import.as, diagnostics_)
                       : std::optional<ast::File>();
    whole_ = whole_ && list;
    if (list) {
      files_.push_back(std::move(*list));
    }
  }

  /// The number of the file among the sources; empty, and reported, if it cannot be read.
  std::optional<uint32_t> add(const fs::path& path, const ast::Import& import) {
    auto text = support::readFile(path);
    if (!text) {
      noteChain(report(support::diagnostics::importUnreadable, import.where, import.path,
                       text.error().message));
      return std::nullopt;
    }
    return sources_.add(path.string(), std::move(*text));
  }

  void read(const fs::path& path, const ast::Import& import) {
    const auto number = add(path, import);
    if (!number) {
      return;
    }
    auto file = parser_(sources_, *number, diagnostics_);
    whole_ = whole_ && file;
    if (file) {
      importAll(*file);
      files_.push_back(std::move(*file));
    }
  }

  template <typename... Args>
  support::DiagnosticBuilder report(DiagnosticId id, const support::SourceRange& range,
                                    const Args&... args) {
    whole_ = false;
    return diagnostics_.report(id, range, args...);
  }

  void refuseCycle(const ast::Import& import, std::vector<Link>::const_iterator open) {
    std::string by;
    for (auto link = std::next(open); link != chain_.end(); ++link) {
      by += fmt::format("{}`{}`", by.empty() ? " through " : ", ", link->name);
    }
    noteChain(report(support::diagnostics::importCycle, import.where, open->name, by));
  }

  /// Adds notes on the imports that led to the file with the innermost import.
  void noteChain(support::DiagnosticBuilder report) {
    for (size_t i = chain_.size() - 1; i > 0; --i) {
      report.note(chain_[i - 1].import, fmt::format("`{}` is imported here", chain_[i].name));
    }
  }

  support::SourceManager& sources_;
  support::DiagnosticEngine& diagnostics_;
  Parser parser_;
  std::vector<Link> chain_;  ///< outermost first
  std::set<std::string> known_;
  std::deque<ast::File> files_;
  bool whole_ = true;
};

}  // namespace

std::optional<std::deque<ast::File>> loadImports(const ast::File& file,
                                                 support::SourceManager& sources,
                                                 support::DiagnosticEngine& diagnostics) {
  Importer importer(sources, diagnostics, parse);
  importer.importAll(file);
  return importer.whole() ? std::optional(importer.take()) : std::nullopt;
}

std::deque<ast::File> loadIntactImports(const ast::File& file, support::SourceManager& sources) {
  support::DiagnosticEngine quiet;
  Importer importer(
      sources, quiet,
      [](const support::SourceManager& all, uint32_t number, support::DiagnosticEngine&) {
        return std::optional(parseIntact(all, number));
      });
  importer.importAll(file);
  return importer.take();
}

}  // namespace glider::frontend
