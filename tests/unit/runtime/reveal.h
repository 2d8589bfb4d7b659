// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

/// Private members, for tests that damage them as broken memory does. An explicit instantiation may
/// name them. In the global namespace, as REVEAL is to be.
template <typename Tag, typename Tag::Member kMember>
struct Reveal {
  friend typename Tag::Member memberOf(Tag) { return kMember; }
};

/// Makes Tag{} the name of Owner::member, which is a Type: `object.*memberOf(Tag{})`.
#define REVEAL(Tag, Owner, Type, member) \
  struct Tag {                           \
    using Member = Type Owner::*;        \
    friend Member memberOf(Tag);         \
  };                                     \
  template struct Reveal<Tag, &Owner::member>
