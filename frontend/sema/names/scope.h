// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#pragma once

#include "frontend/frontend.h"
#include "frontend/sema/names/energy.h"
#include "frontend/sema/names/names.h"
#include "frontend/sema/names/paths.h"
#include "frontend/sema/names/types.h"
#include "frontend/spelling.h"
#include "ir/core/c_symbols.h"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace glider::frontend {

/// An `inside(…)` whose corners are all known at compile time.
struct KnownArea {
  support::SourceRange range;  ///< of the text
  ir::Geofence area;
};

/// An evaluated `const`.
struct Constant {
  const ast::Name* name = nullptr;
  const ast::Expr* untyped = nullptr;  ///< its value, if no type is declared
  ir::Type type;
  bool position = false;  ///< `number` is the latitude, `second` the longitude
  double number = 0;      ///< SI units or degrees; 1 and 0 for true and false
  double second = 0;
  Scale scale;
  Path path;                     ///< not empty: a path, and nothing else
  std::vector<double> elements;  ///< not empty: an array of values of `type`, and nothing else
  bool choice = false;           ///< `glidercc plan` chooses it: a line `choose`
  bool worked_out = false;       ///< its definition was reached
  bool valid = false;            ///< evaluated without errors; errors have been reported
  bool open = false;             ///< its value is that of a choice, or follows from one
};

/// One pass of a `for`, in which its index is a constant.
struct LoopPass {
  Constant index;
  bool again = false;  ///< its text was lowered before: warnings were given then
  const LoopPass* outer = nullptr;
};

/// What the loops of a mission have become so far.
struct LoopSizes {
  std::set<const ast::For*> seen;  ///< those whose text was lowered
  size_t statements = 0;           ///< lowered in passes of loops; each pass also counts as one
  size_t begin = 0;                ///< operations of the mission where the outermost loop begins
  /// If the outermost loop becomes too large: about how many operations the loop becomes that was
  /// lowered last.
  std::optional<double> too_large;
};

/// A flightprofile or flightroute that a mission may use.
struct BehaviourDeclaration {
  const ast::Name* name = nullptr;
  ir::BehaviourKind kind = ir::BehaviourKind::Profile;
  const ast::Behaviour* body = nullptr;  ///< null: a C function
  Signature signature;
  std::vector<const platforms::PlatformSensor*> reads;
  bool usable = true;  ///< false: its declaration was refused, which has been reported
  ir::BehaviourId id;  ///< once the mission uses it
};

/// A C function that expressions may call.
struct FunctionDeclaration {
  const ast::Name* name = nullptr;
  Signature signature;
  ir::Type result;
  double lowest = -ir::Variable::kEndless;  ///< a result outside is unknown
  double highest = ir::Variable::kEndless;
  bool usable = true;  ///< false: its declaration was refused, which has been reported
};

/// The names of what is received from other vehicles begin with it.
inline constexpr std::string_view kPeerPrefix = "peer.";

/// A sensor of the SBC's own, or what is received of a share.
struct OwnSensor {
  const ast::Name* name = nullptr;
  platforms::PlatformSensor sensor;  ///< in SI units or degrees; `unit` is left empty
  bool usable = true;  ///< false: its declaration was refused, which has been reported
};

/// What is received of a share from one vehicle.
struct NamedSensor {
  platforms::PlatformSensor sensor;  ///< "ada.top"
  std::string share;                 ///< "top"
  uint32_t address = 0;              ///< of the vehicle, from 1 on
  support::SourceRange where;        ///< of the share
};

/// A state, entered before any is lowered, so that cases may name later states.
struct StateDeclaration {
  const ast::State* node = nullptr;
  Signature signature;
  std::vector<ir::VariableId> parameters;
  Names names;  ///< its parameters and variables
};

/// The three clocks of the language: names that every mission has.
enum class Clock : uint8_t { MissionTime, StateTime, ResumeTime };
std::optional<Clock> findClock(std::string_view name);
/// Their names, in the order of Clock.
std::span<const std::string_view> clockNames();

/// The data of analysis: the names of a mission, and the mission as far as it is lowered.
class Scope {
 public:
  Scope(const AnalysisInputs& inputs, support::DiagnosticEngine& diagnostics)
      : inputs_(inputs), diagnostics_(diagnostics) {}

  /// Reports. In the body of a behaviour that is lowered for a use of it, and in a later pass of a
  /// loop, a warning is dropped (it was given before) and an error names the use or the pass.
  template <typename... Args>
  support::DiagnosticBuilder report(support::DiagnosticId id, const support::SourceRange& range,
                                    Args&&... args) {
    const bool again = context.pass != nullptr && context.pass->again;
    if (!context.use && !again) {
      return diagnostics_.report(id, range, std::forward<Args>(args)...);
    }
    if (support::catalogueRow(id).severity != support::Severity::Error) {
      return support::DiagnosticBuilder(dropped_ = {});
    }
    auto builder = diagnostics_.report(id, range, std::forward<Args>(args)...);
    if (again) {
      notePass(builder);
    }
    if (context.use) {
      builder.note(*context.use, "with what is given here");
    }
    return builder;
  }
  /// Reports an unknown name at `range`; the suggestion is the last argument of the message.
  template <typename... Args>
  support::DiagnosticBuilder reportUnknown(support::DiagnosticId id,
                                           const support::SourceRange& range,
                                           const Suggestion& suggestion, Args&&... args) {
    auto builder = report(id, range, std::forward<Args>(args)..., suggestion.hint);
    if (!suggestion.fix.empty()) {
      builder.fix(range, suggestion.fix);
    }
    return builder;
  }
  /// Reports that `what` watches something over time where that is not possible.
  support::DiagnosticBuilder refuseOverTime(const support::SourceRange& range,
                                            std::string_view what);
  /// "states: down, fix"; empty if there are none.
  [[nodiscard]] std::string listedStates() const;
  [[nodiscard]] const std::string& fileName(uint32_t file) const {
    return inputs_.sources.name(file);
  }
  [[nodiscard]] std::string_view fileText(uint32_t file) const {
    return inputs_.sources.text(file);
  }
  /// The source text of `range` on one line, without comments.
  [[nodiscard]] std::string wholeText(const support::SourceRange& range) const;
  /// The word of letters and `_` after `range` on its line; empty if there is none.
  [[nodiscard]] std::string wordAfter(const support::SourceRange& range) const;
  /// The same, shortened.
  [[nodiscard]] std::string text(const support::SourceRange& range) const;
  [[nodiscard]] const platforms::Platform& platform() const { return inputs_.platform; }
  [[nodiscard]] support::DiagnosticEngine& diagnostics() { return diagnostics_; }

  /// The sensor that `name` refers to in `context`, the vehicle's or the SBC's own; null if there
  /// is none, or if its declaration was refused (`refused_names`).
  [[nodiscard]] const platforms::PlatformSensor* findSensor(std::string_view name);
  /// The mission's entry of a C function, made on first use.
  ir::FunctionId function(const FunctionDeclaration& declaration);
  /// The mission's subscription of a sensor, made on first use; `written` is its name in the
  /// mission.
  ir::SensorId subscribe(const platforms::PlatformSensor& sensor, std::string_view written);
  /// The same if the mission has subscribed it; else invalid.
  [[nodiscard]] ir::SensorId subscribed(const platforms::PlatformSensor& sensor) const;
  /// The mission's table of these values, made on first use.
  ir::TableId table(ir::Table table);
  /// The mission's use of a behaviour, made on first use.
  ir::BehaviourId use(BehaviourDeclaration& declaration);
  /// Everything that is declared in C.
  [[nodiscard]] ir::CInterface declaredInC() const;
  /// "did you mean `temp`?" over sensors, clocks and constants.
  [[nodiscard]] Suggestion suggestName(std::string_view wrong) const;
  [[nodiscard]] Suggestion suggestSensor(std::string_view wrong) const;
  /// What this name already means in every mission, such as "a clock"; empty: nothing.
  [[nodiscard]] std::string takenBy(std::string_view name) const;
  /// True, and reported, if `name` is a value that is not visible from `context`.
  bool refuseUnseen(std::string_view name, const support::SourceRange& range);
  /// True, and reported, if `name` is of a vehicle that there is not: `adda.top`.
  bool refuseVehicle(std::string_view name, const support::SourceRange& range);
  /// True, and reported, if `name` cannot be used for a value because it is a unit, sensor, clock
  /// or function.
  bool refuseName(const ast::Name& name, std::string_view owner);
  /// True, and reported, if a constant, parameter, variable or `extern` visible from `context`
  /// already has this name.
  bool refuseSecond(const ast::Name& name);
  /// The parameter or variable that `name` refers to in `context`; null if there is none.
  Named* findNamed(std::string_view name);
  /// Whether the text that has `name` at `where` uses it for a value or function, there or
  /// elsewhere: then the name means nothing else in it.
  [[nodiscard]] bool declares(std::string_view name, const support::SourceRange& where);
  /// Whether a place is in the standard library.
  [[nodiscard]] bool inStandardLibrary(const support::SourceRange& range) const;
  /// The profile or route that `name` refers to where it is written; null if there is none.
  BehaviourDeclaration* findBehaviour(const ast::Name& name);
  /// The constant that `name` refers to in `context`, which may be the index of a loop; null if
  /// there is none.
  const Constant* findConstant(std::string_view name) const;
  /// The pass of the loop around `context` whose index is called `name`; null if there is none.
  [[nodiscard]] const LoopPass* findPass(std::string_view name) const;
  /// The parameters and variables visible from `context`.
  [[nodiscard]] std::vector<const Names*> visibleNames() const;
  /// `wish`, or if a variable already has that name, a similar unused name.
  std::string freshName(std::string wish);
  /// The type with this name; empty, and reported, if there is none, or if it is a path, which
  /// `holder` ("a variable") cannot be. An empty holder can.
  std::optional<DeclaredType> declaredType(const ast::TypeName& name, std::string_view holder);
  /// Resolves the types of the parameters of `name`, each a `holder`; they must outlive the
  /// signature. Their names are checked where they are entered. A usual argument is reported and
  /// refused if `holder` is not empty: only profiles and routes have some.
  Signature signatureOf(const ast::Name& name, std::span<const ast::Formal> formals,
                        std::string_view holder);

  /// Lowers into an empty mission during its lifetime: what is only checked is not compiled.
  class Scratch {
   public:
    explicit Scratch(Scope& scope) : scope_(scope) { swap(); }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    ~Scratch() { swap(); }

   private:
    void swap() {
      std::swap(scope_.mission, mission_);
      std::swap(scope_.subscribed_, subscribed_);
      std::swap(scope_.variable_names_, variable_names_);
    }
    Scope& scope_;
    ir::Mission mission_;
    std::map<uint16_t, ir::SensorId> subscribed_;
    std::set<std::string, std::less<>> variable_names_;
  };

  /// Lowers into a copy of the mission during its lifetime: for text that names what the mission
  /// declares, but is not compiled.
  class Trial {
   public:
    explicit Trial(Scope& scope)
        : scope_(scope),
          mission_(scope.mission),
          subscribed_(scope.subscribed_),
          variable_names_(scope.variable_names_) {}
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;
    ~Trial() {
      scope_.mission = std::move(mission_);
      scope_.subscribed_ = std::move(subscribed_);
      scope_.variable_names_ = std::move(variable_names_);
    }

   private:
    Scope& scope_;
    ir::Mission mission_;
    std::map<uint16_t, ir::SensorId> subscribed_;
    std::set<std::string, std::less<>> variable_names_;
  };

  /// Changes the context during its lifetime.
  class Within {
   public:
    Within(Scope& scope, Context context)
        : scope_(scope), before_(std::exchange(scope.context, std::move(context))) {}
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;
    ~Within() { scope_.context = std::move(before_); }

   private:
    Scope& scope_;
    Context before_;
  };

  ir::Mission mission;
  std::optional<double> declination;    ///< rad, east positive; empty: no line gives it
  std::optional<Energy> energy;         ///< of the line `pack`; empty: there is none
  std::map<uint32_t, KnownArea> areas;  ///< by the expression that checks whether it is kept
  Context context;
  LoopSizes loops;
  /// How often a constant was looked up whose value is open.
  mutable size_t open_reads = 0;
  std::map<std::string, Constant, std::less<>> constants;
  Names names;  ///< the mission's parameters and variables
  std::set<std::string, std::less<>>
      refused_names;  ///< declared, but refused: uses are not reported again
  /// The constants without a unit that were reported, each with the type that it is used as.
  std::set<std::string, std::less<>> unitless;
  std::map<std::string, FunctionDeclaration, std::less<>> functions;
  static constexpr size_t kMostOwnSensors = 64;
  std::map<std::string, OwnSensor, std::less<>> own_sensors;
  std::map<std::string, OwnSensor, std::less<>> heard_sensors;  ///< of other vehicles: "peer.top"
  std::vector<std::string> vehicles;  ///< of the line `vehicles`, by address, from 1 on
  /// As many have numbers of their own.
  static constexpr size_t kMostNamedSensors =
      ir::kFirstOwnSensor - ir::kFirstHeardSensor - ir::kMostShares;
  std::map<std::string, NamedSensor, std::less<>> named_sensors;  ///< "ada.top": those used so far
  std::map<std::string, ir::StateId, std::less<>> states;
  std::map<std::string, const ast::PlaceDeclaration*, std::less<>> places;
  std::set<const ast::PlaceDeclaration*> used_places;  ///< lowered, and so checked
  std::vector<StateDeclaration> state_declarations;    ///< by StateId
  std::map<std::string, BehaviourDeclaration, std::less<>> behaviours;
  /// Those of the standard library whose names the mission uses itself: the library still means
  /// them.
  std::map<std::string, BehaviourDeclaration, std::less<>> replaced_behaviours;

 private:
  /// The sensor `ada.top`, made on first use; null if there is none.
  const platforms::PlatformSensor* findNamedSensor(std::string_view name);
  /// Says what the indices of the loops around are.
  void notePass(support::DiagnosticBuilder& report) const;
  /// The `extern sensor` or `extern function` that already has the name `name`.
  [[nodiscard]] const ast::Name* findExternal(std::string_view name) const;

  const AnalysisInputs& inputs_;
  support::DiagnosticEngine& diagnostics_;
  support::Diagnostic dropped_;
  std::map<uint16_t, ir::SensorId> subscribed_;
  std::set<std::string, std::less<>> variable_names_;
};

}  // namespace glider::frontend
