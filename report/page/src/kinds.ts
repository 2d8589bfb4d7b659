// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

/** How each kind of event looks. Unknown kinds are shown like "log". */

export interface Kind {
  /** A custom property of style.css. */
  colour: string;
  glyph: string;
  /** Drawn on the depth chart. */
  marked: boolean;
  /** Drawn as a flag over the whole height. */
  flagged: boolean;
}

const log: Kind = { colour: "kind-log", glyph: "·", marked: false, flagged: false };

const kinds = new Map<string, Kind>(Object.entries({
  transition: { colour: "kind-transition", glyph: "▼", marked: true, flagged: false },
  control: { colour: "kind-control", glyph: "⚑", marked: true, flagged: true },
  steering: { colour: "kind-behaviour", glyph: "·", marked: false, flagged: false },
  hook: { colour: "kind-hook", glyph: "◆", marked: false, flagged: false },
  behaviour: { colour: "kind-behaviour", glyph: "●", marked: false, flagged: false },
  abort: { colour: "kind-abort", glyph: "✖", marked: true, flagged: true },
  bottom: { colour: "kind-abort", glyph: "⊥", marked: true, flagged: true },
  surface: { colour: "kind-control", glyph: "▲", marked: true, flagged: false },
  dive: { colour: "kind-control", glyph: "▼", marked: true, flagged: false },
  guard: { colour: "kind-hook", glyph: "∿", marked: true, flagged: false },
  link: { colour: "kind-link", glyph: "≈", marked: true, flagged: false },
}));

export function kindOf(name: string): Kind {
  return kinds.get(name) ?? log;
}
