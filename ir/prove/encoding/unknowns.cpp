// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "ir/prove/encoding/unknowns.h"

#include <fmt/format.h>

namespace glider::ir::prove {

z3::expr Unknowns::real(const std::string& what, std::optional<uint32_t> of) {
  of_.push_back(of);
  made_.push_back(context_.real_const(fmt::format("{}{}!{}", prefix_, what, made_.size()).c_str()));
  return made_.back();
}

z3::expr Unknowns::whole(const std::string& what) {
  of_.push_back(std::nullopt);
  made_.push_back(context_.int_const(fmt::format("{}{}!{}", prefix_, what, made_.size()).c_str()));
  return made_.back();
}

z3::expr Unknowns::truth(const std::string& what, std::optional<uint32_t> of) {
  of_.push_back(of);
  made_.push_back(context_.bool_const(fmt::format("{}{}!{}", prefix_, what, made_.size()).c_str()));
  return made_.back();
}

std::string Unknowns::fullKey(const std::string& key, const std::vector<z3::expr>& terms) {
  std::string full = key;
  for (const z3::expr& term : terms) {
    full += fmt::format(" {}", term.id());
  }
  return full;
}

const NumberTerm* Unknowns::resultOf(const std::string& key,
                                     const std::vector<z3::expr>& terms) const {
  const auto found = results_.find(fullKey(key, terms));
  return found == results_.end() ? nullptr : &found->second.value;
}

void Unknowns::keepResult(const std::string& key, std::vector<z3::expr> terms,
                          const NumberTerm& result) {
  const std::string full = fullKey(key, terms);
  results_.emplace(full, Result{std::move(terms), result});
}

}  // namespace glider::ir::prove
