// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "driver/output/symbols.h"

#include "compiler/symbols.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <optional>

namespace glider::driver {
namespace {

using frontend::Symbol;
using nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr uint32_t kMission = 0;

/// Null for an empty range.
ordered_json rangeOf(const support::SourceManager& sources, const support::SourceRange& range) {
  if (!range.valid()) {
    return nullptr;
  }
  const auto place = [&](uint32_t offset) {
    const support::LineColumn at = sources.place(range.file, offset);
    return ordered_json{{"line", at.line}, {"column", at.column}};
  };
  return {
      {"file", sources.name(range.file)}, {"begin", place(range.begin)}, {"end", place(range.end)}};
}

/// Null for an empty text: unknown, or not there.
ordered_json textOrNull(const std::string& text) {
  return text.empty() ? ordered_json(nullptr) : ordered_json(text);
}

ordered_json symbolOf(const compiler::Symbols& symbols, const Symbol& symbol) {
  ordered_json one = {{"kind", frontend::word(symbol.kind)},
                      {"name", symbol.name},
                      {"vehicle_name", textOrNull(symbol.vehicle_name)},
                      {"type", textOrNull(symbol.type)},
                      {"unit", textOrNull(symbol.unit)},
                      {"description", symbol.description},
                      {"declared", rangeOf(*symbols.sources, symbol.where)},
                      {"scope", rangeOf(*symbols.sources, symbol.scope)},
                      {"owner", nullptr}};
  if (symbol.owner) {
    one["owner"] = symbols.table.symbols()[*symbol.owner].name;
  }
  one["uses"] = ordered_json::array();
  for (const support::SourceRange& use : symbol.uses) {
    one["uses"].push_back(rangeOf(*symbols.sources, use));
  }
  return one;
}

/// A description may quote bytes that are not UTF-8.
std::string dump(const ordered_json& document) {
  return document.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

/// The byte at `place` of the mission; for a column past the end of a line, that end.
uint32_t offsetOf(const support::SourceManager& sources, support::LineColumn place) {
  const std::string& text = sources.text(kMission);
  const std::string_view line = sources.line(kMission, place.line);
  const char* begin = line.data() == nullptr ? text.data() + text.size() : line.data();
  const auto isContinuation = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
  };
  size_t at = 0;
  for (uint32_t column = 1; column < place.column && at < line.size(); ++column) {
    do {
      ++at;
    } while (at < line.size() && isContinuation(line[at]));
  }
  return static_cast<uint32_t>(static_cast<size_t>(begin - text.data()) + at);
}

/// Empty if `text` is not a line and a column.
std::optional<support::LineColumn> parsePlace(const std::string& text) {
  support::LineColumn place{0, 0};
  const char* end = text.data() + text.size();
  const auto line = std::from_chars(text.data(), end, place.line);
  if (line.ec != std::errc() || line.ptr == end || *line.ptr != ':') {
    return std::nullopt;
  }
  const auto column = std::from_chars(line.ptr + 1, end, place.column);
  const bool right = column.ec == std::errc() && column.ptr == end;
  return right && place.line > 0 && place.column > 0 ? std::optional(place) : std::nullopt;
}

std::string allToJson(const compiler::Symbols& symbols) {
  ordered_json all = ordered_json::array();
  for (const Symbol& symbol : symbols.table.symbols()) {
    all.push_back(symbolOf(symbols, symbol));
  }
  return dump({{"version", kVersion}, {"symbols", std::move(all)}});
}

std::string placeToJson(const compiler::Symbols& symbols, support::LineColumn place) {
  const uint32_t offset = offsetOf(*symbols.sources, place);
  const Symbol* symbol = symbols.table.at(kMission, offset);
  ordered_json visible = ordered_json::array();
  for (const Symbol* one : symbols.table.visibleAt(kMission, offset)) {
    visible.push_back({{"kind", frontend::word(one->kind)},
                       {"name", one->name},
                       {"type", textOrNull(one->type)},
                       {"description", one->description}});
  }
  return dump({{"version", kVersion},
               {"symbol", symbol == nullptr ? ordered_json(nullptr) : symbolOf(symbols, *symbol)},
               {"visible", std::move(visible)}});
}

}  // namespace

std::string checkPlace(const std::string& text) {
  return parsePlace(text) ? "" : "`" + text + "` is not a line and a column, as in 7:12";
}

support::Result<std::string> printSymbols(const compiler::Compilation& compilation,
                                          const std::string& place) {
  const auto symbols = compiler::symbolsOf(compilation);
  if (!symbols) {
    return std::unexpected(symbols.error());
  }
  const auto at = parsePlace(place);
  return at ? placeToJson(*symbols, *at) : allToJson(*symbols);
}

}  // namespace glider::driver
