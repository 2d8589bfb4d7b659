// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
#include "ir/naps/wake.h"
#include "runtime/abi/glider_abi.h"

#include <string>

namespace glider::codegen {
namespace {

/// Generates the code of the trees of ir/naps, a function whose last parameter is the GliderNap.
class Foresee {
 public:
  explicit Foresee(Body& body) : body_(body), builder_(body.builder) {}

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void lower(const ir::Wake& wake) {
    switch (wake.kind) {
      case ir::WakeKind::Nothing:
        return;
      case ir::WakeKind::Awake:
        return body_.call("gliderNapAwake", {nap()});
      case ir::WakeKind::All:
        for (const ir::Wake& part : wake.parts) {
          lower(part);
        }
        return;
      case ir::WakeKind::Branch:
        return branch(wake);
      case ir::WakeKind::Until:
        return body_.call("gliderNapUntil", {nap(), secondsUntil(wake)});
      case ir::WakeKind::Crossed:
        return body_.call("gliderNapCrossed", {nap(), body_.context(), sensor(wake),
                                               body_.expressions.number(wake.right)});
      case ir::WakeKind::Known:
        return body_.call("gliderNapKnown", {nap(), body_.context(), sensor(wake)});
      case ir::WakeKind::Lost:
        return body_.call("gliderNapLost", {nap(), body_.context(), sensor(wake)});
      case ir::WakeKind::Repeats:
        return awakeUnless(builder_.CreateICmpEQ(body_.contextField(fieldOf(wake.list)),
                                                 builder_.getInt32(wake.number)));
      case ir::WakeKind::Keeps:
        return awakeUnless(keeps(wake));
    }
  }

 private:
  llvm::Value* nap() { return body_.function->getArg(1); }
  llvm::Value* sensor(const ir::Wake& wake) { return builder_.getInt32(wake.sensor.index); }

  llvm::Value* secondsUntil(const ir::Wake& wake) {
    llvm::Value* right = body_.expressions.number(wake.right);
    return builder_.CreateFSub(right, body_.expressions.number(wake.left));
  }

  /// Not if it is unknown: then the statement would leave a note.
  llvm::Value* keeps(const ir::Wake& wake) {
    llvm::Value* held =
        builder_.CreateLoad(builder_.getDoubleTy(), body_.expressions.placeOf(wake.variable));
    llvm::Value* becomes = wake.right.valid() ? body_.expressions.asNumber(wake.right)
                                              : llvm::ConstantFP::get(builder_.getDoubleTy(), 1.0);
    return builder_.CreateFCmpOEQ(held, becomes);
  }

  static unsigned fieldOf(ir::ListKind list) {
    switch (list) {
      case ir::ListKind::Always:
        return field::GliderContext::fired_always;
      case ir::ListKind::State:
        return field::GliderContext::fired_state;
      case ir::ListKind::Profile:
        return field::GliderContext::fired_profile;
      case ir::ListKind::Route:
        break;
    }
    return field::GliderContext::fired_route;
  }

  void awakeUnless(llvm::Value* condition) {
    llvm::BasicBlock* differs = body_.block("differs");
    llvm::BasicBlock* same = body_.block("same");
    builder_.CreateCondBr(condition, same, differs);
    builder_.SetInsertPoint(differs);
    body_.call("gliderNapAwake", {nap()});
    builder_.CreateRetVoid();
    builder_.SetInsertPoint(same);
  }

  // NOLINTNEXTLINE(misc-no-recursion): as deep as the mission's text nests
  void branch(const ir::Wake& wake) {
    llvm::Value* test =
        wake.of_false ? body_.expressions.isFalse(wake.test) : body_.expressions.isTrue(wake.test);
    llvm::BasicBlock* yes = body_.block("yes");
    llvm::BasicBlock* no = body_.block("no");
    llvm::BasicBlock* then = body_.block("then");
    builder_.CreateCondBr(test, yes, no);
    const Expressions::Mark mark = body_.expressions.mark();
    for (const bool first : {true, false}) {
      builder_.SetInsertPoint(first ? yes : no);
      lower(wake.parts[first ? 0 : 1]);
      builder_.CreateBr(then);
      body_.expressions.rollBack(mark);
    }
    builder_.SetInsertPoint(then);
  }

  Body& body_;
  llvm::IRBuilder<>& builder_;
};

}  // namespace

llvm::Function* lowerForesee(Lowering& lowering, uint32_t index) {
  if (!lowering.mission.nap_s) {
    return nullptr;
  }
  const ir::Wake wake = ir::wakeOf(lowering.mission, ir::StateId{index});
  if (!ir::maySleep(lowering.mission, wake)) {
    return nullptr;
  }
  const ir::State& state = lowering.mission.states[index];
  Body body(lowering, "foresee." + state.name, Body::Result::None, 0, state.name + " may sleep",
            state.range, true);
  Foresee(body).lower(wake);
  body.builder.CreateRetVoid();
  return body.function;
}

}  // namespace glider::codegen
