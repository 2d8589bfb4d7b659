// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "analysis/brief/given.h"

#include <algorithm>

namespace glider::analysis {
namespace {

/// As the front end reads arguments (sema/expressions/named_arguments.cpp): those without a name
/// come first, in the order of the parameters.
class GivenReader {
 public:
  GivenReader(std::span<const ast::Formal> formals, std::span<const ast::Argument> arguments,
              const std::function<bool(const ast::Expr&)>& is_position)
      : formals_(formals),
        arguments_(arguments),
        is_position_(is_position),
        places_(formals.size()) {}

  std::vector<Given> run() {
    for (size_t at = 0; at < arguments_.size();) {
      at += arguments_[at].parameter ? takeNamed(arguments_[at]) : takeUnnamed(at);
    }
    std::erase_if(places_, [](const Given& given) { return given.values.empty(); });
    return std::move(places_);
  }

 private:
  /// Each returns how many arguments it has read.
  size_t takeNamed(const ast::Argument& argument) {
    const auto formal = std::ranges::find(
        formals_, argument.parameter->text,
        [](const ast::Formal& one) -> const std::string& { return one.name.text; });
    if (formal != formals_.end()) {
      places_[static_cast<size_t>(formal - formals_.begin())] = {{&*formal}, {&*argument.value}};
    }
    return 1;
  }

  size_t takeUnnamed(size_t at) {
    if (next_ >= formals_.size()) {
      return 1;
    }
    Given& given = places_[next_];
    given.formals = {&formals_[next_]};
    given.values = {&*arguments_[at].value};
    const size_t left = arguments_.size() - at;
    const bool position = is_position_(*arguments_[at].value);
    if (isOf(next_, "position") && !position && left > formals_.size() - next_) {
      given.values.push_back(&*arguments_[at + 1].value);
    }
    if (position && isOf(next_, "latitude") && isOf(next_ + 1, "longitude")) {
      given.formals.push_back(&formals_[next_ + 1]);
    }
    next_ += given.formals.size();
    return given.values.size();
  }

  [[nodiscard]] bool isOf(size_t formal, std::string_view type) const {
    return formal < formals_.size() && formals_[formal].type.text == type;
  }

  std::span<const ast::Formal> formals_;
  std::span<const ast::Argument> arguments_;
  const std::function<bool(const ast::Expr&)>& is_position_;
  std::vector<Given> places_;  ///< by parameter
  size_t next_ = 0;
};

}  // namespace

std::vector<Given> givenTo(std::span<const ast::Formal> formals,
                           std::span<const ast::Argument> arguments,
                           const std::function<bool(const ast::Expr&)>& is_position) {
  return GivenReader(formals, arguments, is_position).run();
}

}  // namespace glider::analysis
