# SPDX-FileCopyrightText: 2026 The glidercc authors
# SPDX-License-Identifier: Apache-2.0
"""Missions of n states in the text form of the IR, by the shape of their structure."""

HEAD = """glider_ir 1
mission shape platform slocum
sensor depth: length vehicle m_depth id 3 encoding linear to_si 1 lowest 0 highest 1200 stale_after 20
behaviour profile surfaced symbol gliderProfileSurfaced () reads ()
behaviour route noheading symbol gliderRouteNoheading () reads ()
"""
GUARD = "(ge statetime 4:time)"
DEEP = "(ge (sensor depth) 9:length)"
EXIT = f"case {GUARD} exit"
RETURN = f"case {GUARD} return"


def states(cases):
    """One state for each list of cases."""
    return "".join(f"state s{i} route noheading () profile surfaced ()\n  " + "\n  ".join(c) + "\n"
                   for i, c in enumerate(cases))


def to(kind, target):
    return f"case {DEEP} {kind} s{target}"


def ring(n):
    """each state goes to the next, the last to the first"""
    return states([to("goto", (i + 1) % n), EXIT] for i in range(n))


def chain(n):
    """each state calls the next"""
    return states([EXIT if i == 0 else RETURN] + ([to("call", i + 1)] if i + 1 < n else []) for i in range(n))


def one_called(n):
    """a ring of which each state calls the same one"""
    return states([[to("goto", (i + 1) % (n - 1)), to("call", n - 1), EXIT] for i in range(n - 1)] + [[RETURN]])


def dense(n):
    """ten gotos a state, to states all over"""
    return states([to("goto", (i * 7919 + k * k * 31 + 1) % n) for k in range(10)] + [EXIT] for i in range(n))


def always_calls(n):
    """a ring of half the states; as many cases of `always`, each of which calls one of the other half"""
    half = n // 2
    always = "always\n" + "".join(f"  {to('call', half + k)}\n" for k in range(n - half))
    return always + states([[to("goto", (i + 1) % half), EXIT] for i in range(half)] + [[RETURN]] * (n - half))


def always_both(n):
    """a ring of a third; cases of `always` that call one of the second third and go to one of the last, in turn"""
    third = n // 3
    always = "always\n" + "".join(
        f"  {to('call', third + k)}\n  {to('goto', 2 * third + k)}\n" for k in range(third))
    return always + states([[to("goto", (i + 1) % third), EXIT] for i in range(third)] + [[RETURN]] * third +
                           [[to("goto", 0)]] * (n - 2 * third))


def always_nested(n):
    """a chain of calls; case k of `always` calls the state k from its end, which is in the chain too"""
    always = "always\n" + "".join(f"  {to('call', n - 1 - k)}\n" for k in range(n - 2))
    return always + chain(n)


def always_one(n):
    """a ring, and as many cases of `always` that all call one state"""
    always = "always\n" + f"  {to('call', n - 1)}\n" * n
    return always + states([[to("goto", (i + 1) % (n - 1)), EXIT] for i in range(n - 1)] + [[RETURN]])


def wrong_returns(n):
    """a ring of which each state returns with an empty stack: n errors"""
    return states([to("goto", (i + 1) % n), RETURN, EXIT] for i in range(n))


def wrong_calls(n):
    """a chain of calls of which each state calls the one before too: n errors"""
    return states([EXIT if i == 0 else RETURN] + ([to("call", i + 1)] if i + 1 < n else []) +
                  ([to("call", i - 1)] if i > 0 else []) for i in range(n))


def wrong_always(n):
    """a ring and cases of `always` that call states of it, which call on: errors"""
    half = n // 2
    always = "always\n" + "".join(f"  {to('call', half + k)}\n" for k in range(min(n - half, 100)))
    return always + states([[to("goto", (i + 1) % half), to("call", half + i % (n - half)), EXIT] for i in range(half)] +
                           [[RETURN, to("call", n - 1)] if i < n - 1 else [RETURN] for i in range(half, n)])


def no_exit(n):
    """a ring that only its first state leaves, for a ring without an exit"""
    half = n // 2
    return states([[to("goto", (i + 1) % half)] + ([EXIT, to("goto", half)] if i == 0 else []) for i in range(half)] +
                  [[to("goto", half + (i + 1) % (n - half))] for i in range(n - half)])


def unreached(n):
    """a chain of gotos that nothing leads to"""
    return states([[EXIT]] + [[to("goto", i + 1) if i + 1 < n else EXIT] for i in range(1, n)])


SHAPES = (ring, chain, one_called, dense, always_calls, always_both, always_nested, always_one, wrong_returns, wrong_calls,
          wrong_always, no_exit, unreached)


def mission(shape, n):
    return HEAD + shape(n)
