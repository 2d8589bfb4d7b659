#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""What the operators of scripts/mutants_code plant in a few lines, and where they plant nothing."""

import pathlib
import sys
import unittest

sys.dont_write_bytecode = True
ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "scripts"))

from mutants_code_parts import planting_code  # noqa: E402
from mutants_code_parts.operators import OPERATORS  # noqa: E402
from mutants_code_parts.source import Source  # noqa: E402


def planted(operator, text, path="hooks/x.cpp"):
    """What the one operator makes of the text, line by line of the change."""
    source = Source(path, text)
    return sorted(" ".join((text[:b] + new + text[e:]).split()) for b, e, new in OPERATORS[operator](source))


class Names(unittest.TestCase):
    def test_a_table_that_names_what_is_gone(self):
        named = [("hooks/hookbeh/guard.c", "mayGoOn"), ("hooks/hookbeh/guard.cpp", "mayGoOn"),
                 ("hooks/hookbeh/guard.cpp", "mayStay"), ("hooks/hookbeh/guard.c", "mayStay")]
        self.assertEqual(list(planting_code.unknown_names("t.csv", named)),
                         ["t.csv: hooks/hookbeh/guard.c has no function mayStay", "t.csv: there is no file hooks/hookbeh/guard.cpp"])


class Operators(unittest.TestCase):
    def check(self, operator, text, *expected):
        self.assertEqual(planted(operator, text), sorted(" ".join(e.split()) for e in expected))

    def test_boundary(self):
        self.check("boundary", "if (a < b) x();", "if (a <= b) x();")
        self.check("boundary", "if (a >= b) x();", "if (a > b) x();")
        self.check("boundary", "std::vector<int> a; b << 3; template <typename T> c;")

    def test_equality_and_logic(self):
        self.check("equality", "return a == b;", "return a != b;")
        self.check("logic", "return a && b;", "return a || b;")
        self.check("logic", "void f(T&& a);")

    def test_operand(self):
        self.check("operand", "if (a && f(b, c)) x();", "if ( f(b, c)) x();", "if (a ) x();")
        self.check("operand", "return a || b || c;", "return b || c;", "return a || c;", "return a || b ;")

    def test_arithmetic_and_sign(self):
        self.check("arithmetic", "x = a + b;", "x = a - b;")
        self.check("arithmetic", "x -= b * c;", "x += b * c;", "x -= b / c;")
        self.check("sign", "f(-1, b);", "f(1, b);")
        self.check("term", "x = a + b_;", "x = a;")

    def test_constant(self):
        self.check("constant", "x = 6;", "x = 7;", "x = 0;", "x = 5;")
        self.check("constant", "x = 0.5;", "x = 0.0;", "x = 1.0;")
        self.check("power", "if (x > 0x1p53) y();", "if (x > (0x1p53 * 2)) y();")
        self.check("power", "x = 1e15;", "x = (1e15 * 2);", "x = (1e15 + 1);")
        self.check("power", "x = 1e16;", "x = (1e16 * 2);")

    def test_statements(self):
        self.check("delete", "void f() {\n  a = b;\n  const int c = d;\n  g(a,\n    c);\n  return c;\n}",
                   "void f() { ; const int c = d; g(a, c); return c; }",
                   "void f() { a = b; const int c = d; ; return c; }")
        self.check("order", "void f() {\n  x = y;\n  y = z;\n}", "void f() { y = z; x = y; }")
        self.check("key", "return std::tuple(a, b.c);", "return std::tuple(b.c);", "return std::tuple(a);")
        self.check("join", "r = join(then, otherwise);", "r = then;", "r = otherwise;")
        self.check("element", "for (auto* l : {&a, &b}) {\n}", "for (auto* l : {&b}) { }", "for (auto* l : {&a}) { }")
        self.check("leave", "switch (x) {\n case 1:\n  a();\n  break;\n default:\n  b();\n  break;\n}",
                   "switch (x) { case 1: a(); ; default: b(); break; }")
        self.check("case", "switch (x) { case A::B: return 1; }", "switch (x) { return 1; }")
        self.check("swap", "f(a, b);", "f(b, a);")
        self.check("negate", "if (a < f(b)) {", "if (!(a < f(b))) {")
        self.check("negate", "if (const auto* x = f()) {")

    def test_numbers(self):
        self.check("check-of-number", "x = std::abs(a - b);", "x = (a - b);")
        self.check("check-of-number", "if (std::isnan(x) || y) {", "if (false || y) {")
        self.check("extremes", "x = std::min(a, b);", "x = std::max(a, b);")

    def test_nothing_is_planted_in_comments_texts_and_checks(self):
        for text in ("// a < b\n", "/* a < b */", 'log("a < b");', "static_assert(a < b);", "CHECK(a < b, 3);",
                     "#if A < 3\n#endif\n", "#ifndef NDEBUG\nif (a < b) x();\n#endif\n", 'f(R"(a < b)");'):
            self.check("boundary", text)

    def test_tags_hold_for_their_line_or_the_statement_below(self):
        source = Source("x.cpp", "f();  // HB-4\ng();\n// HB-7: why.\nif (a) {\n  b();\n}\nc();\n")
        self.assertEqual(source.tags, {1: {"HB-4"}, 4: {"HB-7"}, 5: {"HB-7"}, 6: {"HB-7"}})

    def test_keys_name_the_fault_without_a_line_number(self):
        text = "void f() {\n  if (a < b) {\n    x();\n  }\n}\n"
        one = [m.key for m in planting_code.mutants_of(Source("hooks/x.cpp", text))]
        other = [m.key for m in planting_code.mutants_of(Source("hooks/x.cpp", "// more\n\n" + text))]
        self.assertEqual(one, other)
        self.assertEqual(len(one), len(set(one)))
        self.assertTrue(all(" | f | " in key for key in one))

    def test_the_choice_hangs_on_the_seed_alone(self):
        found = list(planting_code.mutants_of(Source("hooks/hookbeh/guard.c")))
        first = [m.key for m in planting_code.pick(found, 20, 1)]
        self.assertEqual(first, [m.key for m in planting_code.pick(list(reversed(found)), 20, 1)])
        self.assertNotEqual(first, [m.key for m in planting_code.pick(found, 20, 2)])
        self.assertEqual(len(first), 20)

    def test_exempt_faults_have_a_verdict_and_a_reason(self):
        for key, (verdict, reason) in planting_code.exempt().items():
            self.assertIn(verdict, ("equivalent", "accepted"), key)
            self.assertGreater(len(reason), 10, key)


if __name__ == "__main__":
    unittest.main()
