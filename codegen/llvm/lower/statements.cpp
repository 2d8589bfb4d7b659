// SPDX-FileCopyrightText: 2026 The glidercc authors
// SPDX-License-Identifier: Apache-2.0

#include "codegen/llvm/lower/body.h"
#include "ir/core/pilot_name.h"
#include "runtime/abi/glider_abi.h"

#include <algorithm>
#include <iterator>

namespace glider::codegen {
namespace {

constexpr const char* kCommandSymbols[] = {
#define COMMAND(name, text, symbol, ...) symbol,
#include "ir/core/commands.def"
#undef COMMAND
};

/// Generates a note (gliderNote).
void lowerNote(Body& body, GliderNoteKind kind, const std::string& name, llvm::Value* values,
               size_t count) {
  body.call("gliderNote", {body.context(), body.builder.getInt32(kind), text(body.lowering, name),
                           values, body.builder.getInt32(static_cast<uint32_t>(count))});
}

void lowerSet(Body& body, const ir::Statement& statement) {
  llvm::IRBuilder<>& builder = body.builder;
  llvm::Value* value = body.expressions.asNumber(statement.value);
  llvm::BasicBlock* known = body.block("known");
  llvm::BasicBlock* unknown = body.block("unknown");
  llvm::BasicBlock* next = body.block("next");
  builder.CreateCondBr(body.expressions.isKnown(value), known, unknown);
  builder.SetInsertPoint(unknown);
  lowerNote(body, kGliderNoteUnknownSet, ir::pilotName(body.lowering.mission, statement.variable),
            llvm::ConstantPointerNull::get(builder.getPtrTy()), 0);
  builder.CreateBr(next);
  builder.SetInsertPoint(known);
  assign(body, statement.variable, value);
  builder.CreateBr(next);
  builder.SetInsertPoint(next);
}

/// Memory for the values of a note, in the function's frame.
llvm::Value* noteValues(Body& body, size_t count) {
  llvm::BasicBlock& entry = body.function->getEntryBlock();
  llvm::IRBuilder<> builder(&entry, entry.begin());
  return builder.CreateAlloca(llvm::ArrayType::get(builder.getDoubleTy(), count), nullptr,
                              "values");
}

void lowerLog(Body& body, const ir::Statement& statement) {
  llvm::IRBuilder<>& builder = body.builder;
  const size_t count = statement.values.size();
  llvm::Value* values =
      count == 0 ? static_cast<llvm::Value*>(llvm::ConstantPointerNull::get(builder.getPtrTy()))
                 : noteValues(body, count);
  for (size_t i = 0; i < count; ++i) {
    llvm::Value* value = body.expressions.asNumber(statement.values[i]);
    builder.CreateStore(value, builder.CreateConstInBoundsGEP1_32(builder.getDoubleTy(), values,
                                                                  static_cast<unsigned>(i)));
  }
  lowerNote(body, kGliderNoteLog, statement.text, values, count);
}

void lowerCommand(Body& body, const ir::Statement& statement) {
  std::vector<llvm::Value*> arguments{body.context()};
  for (const ir::ExprId value : statement.values) {
    arguments.push_back(body.expressions.number(value));
  }
  body.call(kCommandSymbols[static_cast<size_t>(statement.command)], arguments);
}

/// Generates nested blocks without recursion: a stack of what is still to be written, the next on
/// top.
class Blocks {
 public:
  explicit Blocks(Body& body) : body_(body) {}

  void run(ir::BlockId block) {
    open(block);
    while (!todo_.empty()) {
      const Task task = todo_.back();
      todo_.pop_back();
      if (task.statements != nullptr) {
        writeStatement(task);
      } else {
        moveOn(task);
      }
    }
  }

 private:
  /// Either: write statements from `next` on. Or: go to `join`, then write at `at`, where the
  /// expressions generated since `mark` are not available.
  struct Task {
    const std::vector<ir::Statement>* statements = nullptr;
    size_t next = 0;
    llvm::BasicBlock* join = nullptr;
    llvm::BasicBlock* at = nullptr;
    Expressions::Mark mark{};
  };

  void open(ir::BlockId block) {
    if (block.valid()) {
      todo_.push_back({.statements = &body_.lowering.mission[block].statements});
    }
  }

  void moveOn(const Task& task) {
    body_.builder.CreateBr(task.join);
    body_.builder.SetInsertPoint(task.at);
    body_.expressions.rollBack(task.mark);
  }

  void writeStatement(const Task& task) {
    if (task.next == task.statements->size()) {
      return;
    }
    todo_.push_back({.statements = task.statements, .next = task.next + 1});
    const ir::Statement& statement = (*task.statements)[task.next];
    body_.lowering.debug.locate(body_.builder, statement.range);
    switch (statement.kind) {
      case ir::StatementKind::Set:
        lowerSet(body_, statement);
        break;
      case ir::StatementKind::If:
        writeIf(statement);
        break;
      case ir::StatementKind::Log:
        lowerLog(body_, statement);
        break;
      case ir::StatementKind::Command:
        lowerCommand(body_, statement);
        break;
    }
  }

  /// An unknown condition takes neither branch.
  void writeIf(const ir::Statement& statement) {
    llvm::IRBuilder<>& builder = body_.builder;
    llvm::Value* is_true = body_.expressions.isTrue(statement.value);
    llvm::Value* is_false = body_.expressions.isFalse(statement.value);
    const Expressions::Mark mark = body_.expressions.mark();
    llvm::BasicBlock* then = body_.block("then");
    llvm::BasicBlock* not_true = statement.otherwise.valid() ? body_.block("not_true") : nullptr;
    llvm::BasicBlock* otherwise = not_true != nullptr ? body_.block("otherwise") : nullptr;
    llvm::BasicBlock* end = body_.block("end");
    if (not_true != nullptr) {
      builder.CreateCondBr(is_true, then, not_true);
      builder.SetInsertPoint(not_true);
      builder.CreateCondBr(is_false, otherwise, end);
      todo_.push_back({.join = end, .at = end, .mark = mark});
      open(statement.otherwise);
    } else {
      builder.CreateCondBr(is_true, then, end);
    }
    todo_.push_back({.join = end, .at = not_true != nullptr ? otherwise : end, .mark = mark});
    open(statement.then);
    builder.SetInsertPoint(then);
  }

  Body& body_;
  std::vector<Task> todo_;
};

}  // namespace

void assign(Body& body, ir::VariableId variable, llvm::Value* value) {
  body.builder.CreateStore(value, body.expressions.placeOf(variable));
  body.expressions.changed(variable);
}

void lowerBlock(Body& body, ir::BlockId block) {
  Blocks(body).run(block);
}

}  // namespace glider::codegen
