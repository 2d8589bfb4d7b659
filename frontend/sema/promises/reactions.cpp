// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/promises/pattern.h"

#include <fmt/format.h>

namespace glider::frontend {
namespace {

using ir::ExprId;
using ir::VariableId;

class Reaction {
 public:
  Reaction(const ast::ReactionPromise& node, const PromisedPlace& cause,
           const PromisedPlace& response, Pattern& pattern)
      : node_(node), cause_(cause), response_(response), p_(pattern), m_(pattern.monitor) {}

  void write(const PromiseTime& time) {
    switch (node_.timing) {
      case ast::Timing::AtOnce:
        return atOnce();
      case ast::Timing::Within:
        return within(time);
      case ast::Timing::For:
        return during(time);
      case ast::Timing::NextTick:
        return nextTick();
    }
  }

 private:
  [[nodiscard]] bool onlyThen() const { return node_.trigger == ast::Trigger::WheneverAndOnly; }

  /// Whether the cause asks for the response on this tick.
  ExprId asks() {
    const ExprId holds = p_.sight.holds(cause_);
    if (node_.trigger != ast::Trigger::When) {
      return holds;
    }
    const VariableId before = m_.flag("before");
    const ExprId is = m_.isTrue(holds);
    m_.atEnd([this_monitor = &m_, before, is] { this_monitor->set(before, is); });
    return m_.both(is, m_.negation(m_.read(before)));
  }

  void atOnce() {
    m_.violation(m_.both(asks(), p_.sight.fails(response_)),
                 fmt::format("{} holds without {}", cause_.words, response_.words));
    if (onlyThen()) {
      m_.violation(m_.both(p_.sight.holds(response_), p_.sight.fails(cause_)),
                   fmt::format("{} holds without {}", response_.words, cause_.words));
    }
  }

  void within(const PromiseTime& time) {
    m_.longest(time.seconds);
    const VariableId owed = m_.flag("owed");
    const VariableId since = m_.clock("since");
    m_.violation(
        m_.both(m_.read(owed), m_.passed(since, time.seconds)),
        fmt::format("{} did not follow {} within {}", response_.words, cause_.words, time.words),
        since, cause_.wasSo());
    const ExprId asked = asks();
    m_.when(m_.both(asked, m_.negation(m_.read(owed))), [&] {
      m_.set(owed, true);
      m_.set(since, m_.now());
    });
    m_.when(p_.sight.holds(response_), [&] { m_.set(owed, false); });
    m_.violation(m_.both(m_.read(owed), p_.over),
                 fmt::format("{} before {} followed {}", p_.ended, response_.words, cause_.words),
                 since, cause_.wasSo());
  }

  void during(const PromiseTime& time) {
    m_.longest(time.seconds);
    const VariableId owed = m_.flag("owed");
    const VariableId since = m_.clock("since");
    m_.when(asks(), [&] {
      m_.set(owed, true);
      m_.set(since, m_.now());
    });
    m_.when(m_.passed(since, time.seconds), [&] { m_.set(owed, false); });
    m_.violation(
        m_.both(m_.read(owed), p_.sight.fails(response_)),
        fmt::format("{} did not hold for {} after {}", response_.words, time.words, cause_.words),
        since, cause_.wasSo());
  }

  void nextTick() {
    m_.everyTick();
    const VariableId owed = m_.flag("owed");
    const ExprId holds = m_.isTrue(p_.sight.holds(response_));
    m_.violation(
        m_.both(m_.read(owed), m_.negation(holds)),
        fmt::format("{} did not hold on the tick after {}", response_.words, cause_.words));
    if (onlyThen()) {
      const VariableId not_owed = m_.flag("not owed");
      m_.violation(
          m_.both(m_.read(not_owed), holds),
          fmt::format("{} held without {} on the tick before", response_.words, cause_.words));
      m_.set(not_owed, m_.isTrue(p_.sight.fails(cause_)));
    }
    m_.set(owed, m_.isTrue(asks()));
    m_.violation(m_.both(m_.read(owed), p_.over),
                 fmt::format("{} before {} followed {}", p_.ended, response_.words, cause_.words));
  }

  const ast::ReactionPromise& node_;
  const PromisedPlace& cause_;
  const PromisedPlace& response_;
  Pattern& p_;
  ir::MonitorWriter& m_;
};

}  // namespace

void writeReaction(const ast::ReactionPromise& node, const PromisedPlace& cause,
                   const PromisedPlace& response, const PromiseTime& time, Pattern& pattern) {
  Reaction(node, cause, response, pattern).write(time);
}

}  // namespace glider::frontend
