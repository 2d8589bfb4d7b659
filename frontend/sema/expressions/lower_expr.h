// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/ast/ast.h"
#include "frontend/sema/expressions/lanes.h"
#include "frontend/sema/names/scope.h"
#include "frontend/sema/names/values.h"
#include "ir/core/mission_writer.h"

#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace glider::frontend {

/// A lowered expression. A position is two: latitude and longitude.
struct Value {
  ir::ExprId id;
  ir::Type type;
  ir::ExprId longitude{};  ///< valid for a position only
  Scale scale{};           ///< of a plain number
  /// Valid for `90 deg magnetic` itself: that angle, of which `id` is the true heading.
  ir::ExprId on_compass{};
  /// Valid for `energyleft` itself: the charge that it follows from.
  ir::ExprId charge{};
};

/// An array that a name refers to: a variable, a parameter or a constant.
struct Array {
  std::string name;
  DeclaredType type;  ///< of each element
  Scale scale;
  size_t size = 0;
  Named* named = nullptr;              ///< null for a constant
  const Constant* constant = nullptr;  ///< null for a variable or parameter
};

/// The array that `name` refers to in the scope's context; empty if there is none, or if its
/// declaration was refused.
std::optional<Array> findArray(std::string_view name, Scope& scope);

/// "an array of 8 elements"
std::string describe(const Array& array);

/// Which element of an array is meant.
struct ElementIndex {
  std::optional<size_t> known;  ///< known when the mission is compiled
  ir::ExprId written;
  ir::ExprId
      number;  ///< unless it is known: as written, but unknown where there is no such element
};

/// A constant that is a number without a unit, where a quantity is needed; or nothing.
struct MissingUnit {
  const Constant* constant = nullptr;
  std::string declaration = {};  ///< what to write: "deepest = 60 m"
  bool reported = false;         ///< for another use of it

  /// Adds the constant, and what to write there, to the report of its use.
  void explain(support::DiagnosticBuilder& report) const;
};

/// A sensor that an expression reads.
struct SensorRead {
  const platforms::PlatformSensor* sensor;
  std::string written;
  support::SourceRange range;
  bool implied =
      false;  ///< by a word with a meaning, such as `diving`: the mission does not name it
};

/// Checks the types of expressions and lowers them to IR. An error is reported once; the result is
/// then empty, and so is that of everything around it.
class ExprLowering {
 public:
  explicit ExprLowering(Scope& scope) : scope_(scope) {}

  /// `want` is the type that the context expects: a bare number takes its unit. The result may have
  /// another type.
  std::optional<Value> lower(const ast::Expr& expr, std::optional<ir::Type> want);
  /// As lower, but refuses a type other than `want`; `what` names it: "`top` of `yo`".
  std::optional<ir::ExprId> lowerAs(const ast::Expr& expr, const ir::Type& want,
                                    const std::string& what);
  /// As lowerAs, also for a position.
  std::optional<Value> lowerDeclared(const ast::Expr& expr, const DeclaredType& want,
                                     const std::string& what);
  /// The usual speed or pitch of the vehicle (lower_value.cpp); empty, and reported, if a
  /// command to go to a depth has the other.
  std::optional<Value> usualSlope(bool speed, const support::SourceRange& range);
  /// A list of positions, or the name of one; refuses anything else.
  std::optional<Path> lowerPath(const ast::Expr& expr);
  /// A guard or an operand of `&&`.
  std::optional<ir::ExprId> lowerCondition(const ast::Expr& expr);
  /// The index of an element of `array` (arrays/lower_array.cpp).
  std::optional<ElementIndex> lowerIndex(const ast::Expr& expr, const Array& array);

  /// Refuses the halves of a position in the wrong order, as far as numbers and letters show it,
  /// and then returns true (lower_longitude_first.cpp).
  bool longitudeFirst(const ast::Expr& first, const ast::Expr& second,
                      std::string_view between = ", ");

  /// Refuses a pair of numbers without letters that are certainly decimal degrees, as one of them
  /// cannot be minutes, and then returns true.
  bool decimalDegrees(const ast::Expr& first, const ast::Expr& second);

  /// Whether both are numbers without a letter or a unit: halves of one position. With `degrees`
  /// only if both may be meant as decimal degrees, so that one error says it of both.
  static bool areBareHalves(const ast::Expr& first, const ast::Expr& second, bool degrees);

  /// Refuses two plain numbers of which one is written in a unit that is not that of the other, and
  /// then returns true (scales.cpp). `op` is what they meet in.
  bool scalesDiffer(const Value& left, const support::SourceRange& left_where, const Value& right,
                    const support::SourceRange& right_where, std::string_view op);

  /// The sensors read since this was made.
  [[nodiscard]] const std::vector<SensorRead>& reads() const { return reads_; }

 private:
  using Result = std::optional<Value>;

  Result visit(const ast::Literal& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::Position& node, const ast::Expr& expr, std::optional<ir::Type> want);
  // Times (lower_time.cpp).
  Result visit(const ast::Duration& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::Instant& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::Truth& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::NameUse& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::Invocation& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::List& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::Index& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::Unary& node, const ast::Expr& expr, std::optional<ir::Type> want);
  Result visit(const ast::Binary& node, const ast::Expr& expr, std::optional<ir::Type> want);

  // Literals (lower_literal.cpp).
  Result bareLiteral(const ast::Literal& node, const support::SourceRange& range,
                     std::optional<ir::Type> want, bool negative);
  /// Reports `-10 deg magnetic`: the minus would turn the true heading round.
  Result refuseMagnetic(const ast::Literal& node, const support::SourceRange& range);
  /// Reports a unit that does not exist; that of `26 degrees` follows from the type that is
  /// expected.
  void refuseUnit(const ast::Literal& node, std::optional<ir::Type> want);
  void checkBareAngle(const ast::Literal& node, const support::SourceRange& range, double si,
                      bool negative);
  void checkBareEnergy(const ast::Literal& node, const support::SourceRange& range, double si);
  Result barePosition(const ast::Literal& node, const support::SourceRange& range, ir::Type want,
                      bool negative);
  Result letterLiteral(const ast::Literal& node, const support::SourceRange& range,
                       std::optional<ir::Type> want);
  Result compass(const ast::Literal& node, const support::SourceRange& range, bool latitude,
                 double sign);
  std::optional<double> number(const ast::Literal& node, const support::SourceRange& range);
  bool checkOnEarth(const support::SourceRange& range, bool latitude, double degrees);

  // Operators (lower_operator.cpp).
  Result condition(ir::Op op, const ast::Binary& node, const ast::Expr& expr);
  Result comparison(ir::Op op, const ast::Binary& node, const ast::Expr& expr);
  Result sum(ir::Op op, const ast::Binary& node, const ast::Expr& expr,
             std::optional<ir::Type> want);
  /// Whether three whole numbers look like a date, which is reported.
  bool isDate(const ast::Binary& node, const ast::Expr& expr);
  /// Whether `clock` is the time since 1970 and `value` is a constant below a year, which is
  /// reported.
  bool tooSoonAfter1970(const Value& clock, const ast::Expr& clock_expr, const Value& value,
                        const ast::Expr& value_expr);
  /// Refuses `3910.6 -7349.9`, a position that would be a difference.
  bool sideBySide(const ast::Binary& node, const ast::Expr& expr);
  Result scaling(ir::Op op, const ast::Binary& node, const ast::Expr& expr);
  /// Refuses `5 m < depth < 10 m` and `!depth > 5 m`.
  bool chained(const ast::Binary& node, const ast::Expr& expr);
  void warnOfBareHours(const ast::Expr& clock, const ast::Expr& time);
  void warnOfEquality(ir::Op op, const Value& left, const Value& right, const ast::Binary& node);
  /// Both sides with one type; bare numbers take the type of the other side.
  struct Pair {
    Value left;
    Value right;
  };
  Result comparedByCharge(ir::Op op, const Pair& pair, size_t before,
                          const support::SourceRange& range);
  std::optional<Pair> alike(const ast::Expr& left, const ast::Expr& right,
                            std::optional<ir::Type> want, std::string_view op);
  /// The constant whose unit is missing where its plain number should be a `want`.
  MissingUnit missingUnitOf(const ast::Expr& expr, const DeclaredType& want);
  /// Adds the unit to write, if `value` is a number with a unit of another quantity than `other`.
  static void suggestUnit(const ast::Expr& value, const ir::Type& other, std::string_view op,
                          support::DiagnosticBuilder& report);
  /// Refuses a condition, a position and, unless `earth`, a latitude or longitude where `op` needs
  /// numbers.
  bool numeric(const Value& value, const ast::Expr& expr, std::string_view op, bool earth);

  // Functions (lower_function.cpp).
  Result callOf(const ir::Type& type, ir::Op op, const ast::Invocation& node,
                const ast::Expr& expr);
  bool inOrder(const std::vector<ir::ExprId>& operands, const ast::Invocation& node,
               const ast::Expr& expr);
  Result callMany(ir::Op op, const ast::Invocation& node, const ast::Expr& expr,
                  std::optional<ir::Type> want);
  Result callOne(ir::Op op, const ast::Invocation& node, const ast::Expr& expr,
                 std::optional<ir::Type> want);
  /// Refuses `10 m of depth` where the function does not accept it.
  bool stretched(const ast::Invocation& node);
  Result inC(const ast::Invocation& node, const ast::Expr& expr);
  Result ageOf(const ast::Invocation& node, const ast::Expr& expr);

  // Over time (lower_temporal.cpp).
  bool timeFirst(const ast::Invocation& node);
  bool lengthFirst(const ast::Invocation& node);
  Result overTime(ir::TemporalKind kind, const ast::Invocation& node, const ast::Expr& expr);

  // Windows (lower_window.cpp).
  struct WindowLength {
    double length;
    ir::ExprId along;              ///< of a stretch
    support::Dimension dimension;  ///< of the unit of the length
  };
  Result window(const ast::Invocation& node, const ast::Expr& expr);
  std::optional<WindowLength> windowLength(const ast::Argument& over, std::string_view function);
  Result emitWindow(std::string_view name, const Value& operand, const WindowLength& length,
                    const support::SourceRange& range);

  // Windows over a leg, and the number of the yo (lower_window.cpp).
  struct LegWords {
    ir::Leg leg;
    bool dives;
    bool climbs;
  };
  static std::optional<LegWords> legOf(const ast::Expr& length);
  Result legWindow(const ast::Invocation& node, const LegWords& leg, const ast::Expr& expr);
  /// The depth of `depth_of_highest(x, leg)`.
  Result depthOf(const ast::Invocation& node, const ast::Expr& expr);
  /// Adds the temporal over the legs of the vehicle; `written` is what needs them.
  Result emitLeg(ir::Temporal temporal, const LegWords& leg, const std::string& written,
                 const support::SourceRange& range);
  Result yoNumber(const support::SourceRange& range);

  // Places (lower_earth.cpp, lower_inside.cpp).
  Result onEarth(const ast::Invocation& node, const ast::Expr& expr);
  Result betweenPlaces(ir::Op op, const ast::Invocation& node, const ast::Expr& expr);
  /// The vehicle's position: the platform's `lat` and `lon`.
  Result here(const support::SourceRange& range);
  /// The arguments as positions, of one or two arguments each; a path gives all its positions.
  std::optional<std::vector<Value>> places(const ast::Invocation& node);
  /// `position(…)` and `offset(…)` (lower_place.cpp).
  Result placeOf(const ast::Invocation& node, const ast::Expr& expr);
  Result offset(const Value& from, const ast::Invocation& node, const ast::Expr& expr);
  /// `place` with both halves unknown where one is.
  Value wholePlace(const Value& place, const support::SourceRange& range);
  Result inside(const std::vector<Value>& corners, const support::SourceRange& range);
  friend class InsideLowering;

  // Magnetic headings (lower_magnetic.cpp).
  Result magnetic(const ast::Invocation& node, const ast::Expr& expr);
  Result variationInForce(const support::SourceRange& range);
  /// The true heading in [0, 2 pi) of a magnetic one in [0, 2 pi).
  Result fromMagnetic(ir::ExprId heading, const support::SourceRange& range);
  /// What the vehicle's compass shows on this heading, in [0, 2 pi).
  ir::ExprId onCompass(const Value& heading, const support::SourceRange& range);
  /// Replaces both sides of `heading > 90 deg magnetic`, but not of `==`, by what the compass
  /// shows.
  void compareOnCompass(ir::Op op, Pair& pair, const ast::Binary& node);
  /// In [0, 2 pi), of an angle that is less than a turn outside it.
  ir::ExprId wrapped(ir::ExprId sum, const support::SourceRange& range);

  // Arrays (arrays/lower_array.cpp, arrays/lower_array_function.cpp).
  Result element(const Array& array, const ast::Index& node, const ast::Expr& expr);
  Value elementAt(const Array& array, size_t i, const support::SourceRange& range);
  std::vector<Value> elements(const Array& array, const support::SourceRange& range);
  /// The one of `all` with that number; unknown where there is none.
  Value oneOf(const std::vector<Value>& all, ir::ExprId number, const support::SourceRange& range);
  void warnOfIndex(ir::ExprId number, const ast::Expr& expr, const Array& array);
  void refuseArray(const Array& array, const support::SourceRange& range);
  /// The array that is the only argument.
  std::optional<Array> onlyArray(const ast::Invocation& node);
  /// The same, for one whose declaration was refused or comes later; null: it is another argument.
  Named* onlyRefusedArray(const ast::Invocation& node);
  /// `mean(temps)`, `lowest(temps)` and so on.
  Result ofArray(const Array& array, const ast::Invocation& node, const ast::Expr& expr);

  // Paths (lower_path.cpp).
  std::optional<Path> lanes(const ast::Invocation& node, const ast::Expr& expr);
  void refuseLanes(const LaneProblem& problem, const ast::Expr& area);
  Result countOfPath(const ast::Invocation& node, const ast::Expr& expr);
  Result chosen(const Path& path, const Value& index, const support::SourceRange& range);
  Value emitPlace(const Place& place, const support::SourceRange& range);
  void refusePath(const ast::Expr& expr);
  /// For an index of what is neither a path nor an array.
  void refuseIndexed(const ast::Name& name);
  std::optional<Place> constantPlace(const ast::Expr& expr);

  // Names with a meaning of their own (lower_value.cpp).
  Result meantValue(const std::string& name, const support::SourceRange& range);
  Result inState(const SensorState& state, const support::SourceRange& range);
  Result utc(const support::SourceRange& range);
  Result turned(const support::SourceRange& range);
  Result ofWater(ir::Op op, const support::SourceRange& range);

  // The vehicles of the line `vehicles` (lower_earth.cpp).
  bool hasPositions(std::string_view words, const support::SourceRange& range);
  /// The distance to each of them; empty, and reported, if their positions are not shared.
  std::optional<std::vector<ir::ExprId>> neighbours(std::string_view words,
                                                    const support::SourceRange& range);
  Result peersWithin(const ast::Invocation& node, const ast::Expr& expr);
  Result energyValue(const std::string& name, const support::SourceRange& range);
  Result nearest(const support::SourceRange& range);

  // Names (lower_name.cpp).
  Result variable(Named& named, const support::SourceRange& range);
  /// False, and reported, if its value is not known where it is read.
  bool readable(Named& named, const support::SourceRange& range);
  Result sensor(const platforms::PlatformSensor& sensor, const std::string& written,
                const support::SourceRange& range);
  Result finished(const ast::NameUse& node, const support::SourceRange& range);
  Result unknown(const ast::NameUse& node, const support::SourceRange& range);
  Result constant(const Constant& constant, const support::SourceRange& range);
  Result clock(Clock clock, const support::SourceRange& range);

  // IR.
  /// The number or truth value that this expression gives.
  [[nodiscard]] Value valueOf(ir::ExprId id) const { return {id, scope_.mission[id].type, {}}; }
  /// Adds a temporal; its value.
  Value watch(const ir::Temporal& temporal);
  Value emit(ir::Op op, const ir::Type& type, const support::SourceRange& range,
             std::initializer_list<ir::ExprId> operands);
  /// Has the type from the operation's row; the operands must fit.
  Value emitOf(ir::Op op, const support::SourceRange& range, std::span<const ir::ExprId> operands);
  Value emitNumber(double value, const ir::Type& type, const support::SourceRange& range);

  // Values that must be known when the mission is compiled (lower_constant.cpp).
  // The value of `expr`, a `type` above 0, for `what`; 1 in a behaviour that is checked on its own.
  // An error is reported where the value is written or, in a behaviour, where the argument is given
  // for the parameter that causes it: `role` says what the value is for in the behaviour,
  // `not_positive` is the diagnostic for a value that is not above 0.
  struct ConstantRole {
    std::string what;
    std::string_view role;
    support::DiagnosticId not_positive;
  };
  bool refuseStretch(const ast::Argument& over, std::string_view function);
  std::optional<double> positiveConstant(const ast::Expr& expr, const ir::Type& type,
                                         const ConstantRole& role);

  Scope& scope_;
  std::vector<SensorRead> reads_;
};

/// Whether a name at `where` means a value of its own, such as `here` or `diving`: the mission does
/// not use it.
bool meansValue(std::string_view name, const support::SourceRange& where, Scope& scope);

/// The scale of a sum, or of the greater, of two numbers.
Scale commonScale(const Scale& a, const Scale& b);

/// Whether an expression is certainly a position: a literal, the name of one, or a function.
bool isPosition(const ast::Expr& expr, Scope& scope);

/// Whether an expression is certainly a path: a list, the name of one, or lanes.
bool isPath(const ast::Expr& expr, Scope& scope);

/// Whether the unit of a literal is that of a magnetic heading: "deg magnetic".
bool isMagneticUnit(std::string_view unit);

/// Whether an expression is a bare number, or a sum of bare numbers: it has no unit of its own.
bool takesUnitOfContext(const ast::Expr& expr);

}  // namespace glider::frontend
