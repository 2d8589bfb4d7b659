// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "frontend/sema/expressions/evaluate.h"
#include "frontend/sema/expressions/lower_expr.h"
#include "ir/eval/arithmetic.h"

namespace glider::frontend {

namespace {

/// A plain number: known at compile time, or an expression.
struct Term {
  std::optional<double> number;
  ir::ExprId id;
};

/// A corner or the vehicle, in degrees from the first corner.
struct CornerPoint {
  Term north;
  Term east;
};

}  // namespace

/// `inside`: an area's edges are straight in latitude and longitude; a ray to the east of the
/// vehicle crosses them an odd number of times from inside (Shimrat, Communications of the ACM 5
/// (1962), 434, algorithm 112). Longitudes count from the first corner, -180 to 180 degrees. What
/// is known at compile time is computed at compile time.
class InsideLowering {
 public:
  InsideLowering(ExprLowering& lowering, const support::SourceRange& range)
      : lowering_(lowering), range_(range) {}

  Value run(const std::vector<Value>& corners, const Value& vehicle) {
    const CornerPoint here = relative(vehicle, corners.front());
    std::vector<CornerPoint> points;
    for (const Value& corner : corners) {
      points.push_back(relative(corner, corners.front()));
    }
    Term odd = known(1);  // changes its sign at each crossing
    for (size_t i = 0; i < points.size(); ++i) {
      const auto crossing = crosses(points[i], points[(i + 1) % points.size()], here);
      if (crossing) {
        odd = apply(ir::Op::Multiply, odd, select(*crossing, known(-1), known(1)));
      }
    }
    return lowering_.emit(ir::Op::Less, boolean(), range_, {idOf(odd), idOf(known(0))});
  }

 private:
  static Term known(double number) { return {number, {}}; }

  ir::ExprId idOf(const Term& term) {
    return term.number ? lowering_.emitNumber(*term.number, plainNumber(), range_).id : term.id;
  }

  Term apply(ir::Op op, const Term& a, const Term& b) {
    if (a.number && b.number) {
      return known(ir::binary(op, *a.number, *b.number));
    }
    if ((op == ir::Op::Subtract && b.number == 0) || (op == ir::Op::Multiply && a.number == 1)) {
      return op == ir::Op::Subtract ? a : b;
    }
    const ir::ExprId left = idOf(a);
    return {{}, lowering_.emit(op, plainNumber(), range_, {left, idOf(b)}).id};
  }

  ir::ExprId compare(ir::Op op, const Term& a, const Term& b) {
    const ir::ExprId left = idOf(a);
    return lowering_.emit(op, boolean(), range_, {left, idOf(b)}).id;
  }

  ir::ExprId both(ir::ExprId a, ir::ExprId b) {
    return lowering_.emit(ir::Op::And, boolean(), range_, {a, b}).id;
  }

  Term select(ir::ExprId condition, const Term& yes, const Term& no) {
    const ir::ExprId first = idOf(yes);
    const ir::ExprId second = idOf(no);
    return {{},
            lowering_.emit(ir::Op::Select, plainNumber(), range_, {condition, first, second}).id};
  }

  /// Degrees from `origin` to `place`, both latitudes or both longitudes.
  Term degrees(ir::ExprId place, ir::ExprId origin, const ir::Type& type) {
    const ir::Mission& mission = lowering_.scope_.mission;
    const auto a = evaluate(mission, place);
    const auto b = evaluate(mission, origin);
    if (a && b) {
      return known(ir::binary(ir::Op::Subtract, *a, *b));
    }
    const Value one = lowering_.emitNumber(1, type, range_);
    const Value difference = lowering_.emit(ir::Op::Subtract, type, range_, {place, origin});
    return {{}, lowering_.emit(ir::Op::Divide, plainNumber(), range_, {difference.id, one.id}).id};
  }

  CornerPoint relative(const Value& place, const Value& origin) {
    return {degrees(place.id, origin.id, latitude()),
            wrapped(degrees(place.longitude, origin.longitude, longitude()))};
  }

  Term wrapped(const Term& east) {
    if (east.number) {
      const double turn = *east.number >= 180 ? -360 : *east.number < -180 ? 360 : 0;
      return known(*east.number + turn);
    }
    const Term back = apply(ir::Op::Subtract, east, known(360));
    const Term forth = apply(ir::Op::Add, east, known(360));
    const Term lower = select(compare(ir::Op::Less, east, known(-180)), forth, east);
    return select(compare(ir::Op::GreaterEqual, east, known(180)), back, lower);
  }

  /// Whether the ray crosses the edge from `a` to `b`; empty if no ray can.
  std::optional<ir::ExprId> crosses(const CornerPoint& a, const CornerPoint& b,
                                    const CornerPoint& here) {
    const bool decided = a.north.number && b.north.number;
    if (decided && *a.north.number == *b.north.number) {
      return std::nullopt;
    }
    const Term side = apply(ir::Op::Subtract,
                            apply(ir::Op::Multiply, apply(ir::Op::Subtract, here.east, a.east),
                                  apply(ir::Op::Subtract, b.north, a.north)),
                            apply(ir::Op::Multiply, apply(ir::Op::Subtract, here.north, a.north),
                                  apply(ir::Op::Subtract, b.east, a.east)));
    const auto up = [&] { return way(a, b, here, compare(ir::Op::Less, side, known(0))); };
    const auto down = [&] { return way(b, a, here, compare(ir::Op::Greater, side, known(0))); };
    if (decided) {
      return *a.north.number < *b.north.number ? up() : down();
    }
    const ir::ExprId first = up();
    return lowering_.emit(ir::Op::Or, boolean(), range_, {first, down()}).id;
  }

  /// Whether the vehicle's latitude is that of an edge from `low` up to `high`, and the edge is to
  /// its east.
  ir::ExprId way(const CornerPoint& low, const CornerPoint& high, const CornerPoint& here,
                 ir::ExprId east) {
    const ir::ExprId above = compare(ir::Op::LessEqual, low.north, here.north);
    return both(both(above, compare(ir::Op::Less, here.north, high.north)), east);
  }

  ExprLowering& lowering_;
  support::SourceRange range_;
};

namespace {

/// The area, if all its corners are known at compile time.
std::optional<ir::Geofence> areaOf(const ir::Mission& mission, const std::vector<Value>& corners) {
  ir::Geofence area;
  for (const Value& corner : corners) {
    const auto north = evaluate(mission, corner.id);
    const auto east = evaluate(mission, corner.longitude);
    if (!north || !east) {
      return std::nullopt;
    }
    area.corners.push_back({*north, *east});
  }
  return area;
}

}  // namespace

ExprLowering::Result ExprLowering::inside(const std::vector<Value>& corners,
                                          const support::SourceRange& range) {
  const Result vehicle = here(range);
  if (!vehicle) {
    return std::nullopt;
  }
  const Value truth = InsideLowering(*this, range).run(corners, *vehicle);
  if (auto area = areaOf(scope_.mission, corners)) {
    scope_.areas.insert_or_assign(truth.id.index, KnownArea{range, std::move(*area)});
  }
  return truth;
}

}  // namespace glider::frontend
