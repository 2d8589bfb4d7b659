// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "tests/promises/formulas.h"

#include <utility>

namespace glider::tests::ltl {

Formula atom(std::function<bool(const Tick&)> is) {
  return [is = std::move(is)](const Flight& f, size_t i) { return is(f[i]); };
}

Formula no(Formula a) {
  return [a = std::move(a)](const Flight& f, size_t i) { return !a(f, i); };
}

Formula both(Formula a, Formula b) {
  return [a = std::move(a), b = std::move(b)](const Flight& f, size_t i) {
    return a(f, i) && b(f, i);
  };
}

Formula either(Formula a, Formula b) {
  return no(both(no(std::move(a)), no(std::move(b))));
}

Formula implies(Formula a, Formula b) {
  return either(no(std::move(a)), std::move(b));
}

Formula next(Formula a) {
  return [a = std::move(a)](const Flight& f, size_t i) { return i + 1 < f.size() && a(f, i + 1); };
}

Formula weakNext(Formula a) {
  return [a = std::move(a)](const Flight& f, size_t i) { return i + 1 >= f.size() || a(f, i + 1); };
}

Formula until(Formula a, Formula b) {
  return [a = std::move(a), b = std::move(b)](const Flight& f, size_t i) {
    for (; i < f.size(); ++i) {
      if (b(f, i)) {
        return true;
      }
      if (!a(f, i)) {
        return false;
      }
    }
    return false;
  };
}

Formula eventually(Formula a) {
  return until(atom([](const Tick&) { return true; }), std::move(a));
}

Formula globally(Formula a) {
  return no(eventually(no(std::move(a))));
}

Formula weakUntil(Formula a, Formula b) {
  const Formula always = globally(a);
  return either(until(std::move(a), std::move(b)), always);
}

Formula soon(double seconds, Formula a) {
  return [seconds, a = std::move(a)](const Flight& f, size_t i) {
    for (size_t k = i; k < f.size() && f[k].time - f[i].time <= seconds; ++k) {
      if (a(f, k)) {
        return true;
      }
    }
    return false;
  };
}

Formula during(double seconds, Formula a) {
  return no(soon(seconds, no(std::move(a))));
}

Formula all(const std::vector<Formula>& formulas) {
  return [formulas](const Flight& f, size_t i) {
    for (const Formula& a : formulas) {
      if (!a(f, i)) {
        return false;
      }
    }
    return true;
  };
}

}  // namespace glider::tests::ltl
