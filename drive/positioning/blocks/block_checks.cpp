#include "drive/positioning/blocks/block_checks.hpp"

#include <algorithm>
#include <array>

namespace drive {
namespace {

using enum PositioningMessage;

constexpr std::int32_t kHighestClampingTorque = 65536;  // 0.01 N·m

/// What a task takes: the limits of its parameter, and which continuations and kinds of target, a bit each.
struct TaskRow {
  BlockTask task;
  std::int32_t lowest;
  std::int32_t highest;
  unsigned continuations;
  unsigned target_kinds;
};
constexpr unsigned of(Continuation continuation) noexcept {
  return 1U << static_cast<unsigned>(continuation);
}
constexpr std::int32_t kAnyLow = -2147483647 - 1;
constexpr std::int32_t kAnyHigh = 2147483647;
constexpr unsigned kSignals =
    of(Continuation::External) | of(Continuation::ExternalWait) | of(Continuation::ExternalAlarm);
constexpr unsigned kAll = of(Continuation::End) | of(Continuation::WithStop) | of(Continuation::Flying) | kSignals;
constexpr unsigned kStopping = of(Continuation::End) | of(Continuation::WithStop);
constexpr unsigned kNoMotion = kStopping | of(Continuation::Flying);
constexpr unsigned kAnyTarget = 0xFU;
constexpr unsigned kDirectTarget = 0x3U;
constexpr unsigned kNoTarget = ~0U;
constexpr std::array kTasks{
    TaskRow{BlockTask::Positioning, kAnyLow, kAnyHigh, kAll, kAnyTarget},
    TaskRow{BlockTask::FixedStop, 0, kHighestClampingTorque,
            kStopping | of(Continuation::External) | of(Continuation::ExternalWait), kDirectTarget},
    TaskRow{BlockTask::EndlessPositive, kAnyLow, kAnyHigh, kStopping | kSignals, kNoTarget},
    TaskRow{BlockTask::EndlessNegative, kAnyLow, kAnyHigh, kStopping | kSignals, kNoTarget},
    TaskRow{BlockTask::Wait, 0, kAnyHigh, kStopping | kSignals, kNoTarget},
    TaskRow{BlockTask::Goto, 0, static_cast<std::int32_t>(kTraversingBlocks) - 1, ~0U, kNoTarget},
    TaskRow{BlockTask::SetOutput, 1, 3, kNoMotion, kNoTarget},
    TaskRow{BlockTask::ResetOutput, 1, 3, kNoMotion, kNoTarget},
    TaskRow{BlockTask::Jerk, 0, 1, kNoMotion, kNoTarget},
};
static_assert([] {
  for (std::size_t i = 0; i < kTasks.size(); ++i)
    if (kTasks[i].task != static_cast<BlockTask>(i + 1)) return false;
  return true;
}());

bool has(unsigned set, unsigned code) noexcept {
  return code < 32 && (set >> code & 1U) != 0;
}

bool is_task_legal(const TraversingBlock& block) noexcept {
  const TaskRow& row = kTasks[static_cast<std::size_t>(block.task) - 1];
  return block.parameter >= row.lowest && block.parameter <= row.highest &&
         has(row.continuations, block.continuation_code()) && has(row.target_kinds, block.target_code());
}

bool has_target(const TraversingBlock& block) noexcept {
  return block.task == BlockTask::Positioning || block.task == BlockTask::FixedStop;
}

/// An absolute target below or above the limits, which ends the way there but is no inconsistency.
std::optional<PositioningMessage> beyond(const TraversingBlock& block, const BlockLimits& limits) noexcept {
  if (!has_target(block) || block.target_kind() == TargetKind::Relative) return std::nullopt;
  if (block.position < limits.lower) return BlockBelowLimit;
  if (block.position > limits.upper) return BlockAboveLimit;
  return std::nullopt;
}

}  // namespace

std::optional<PositioningMessage> inconsistency(const BlockTable& table, const TraversingBlock& block,
                                                const BlockLimits& limits) noexcept {
  if (table.is_twice(block.number)) return BlockNumberTwice;
  if (!is_task_legal(block)) return IllegalTaskParameter;
  if (block.task == BlockTask::Goto)
    return table.find(block.parameter) ? std::nullopt : std::optional{NoJumpDestination};
  const bool endless = block.task == BlockTask::EndlessPositive || block.task == BlockTask::EndlessNegative;
  const bool ends = block.continuation() == Continuation::End || (endless && !block.awaits_signal());
  if (!ends && !table.after(block.number)) return NoSubsequentBlock;
  if (!has_target(block)) return std::nullopt;
  const bool modulo = limits.modulo_range > 0.0;
  const TargetKind kind = block.target_kind();
  if (!modulo && (kind == TargetKind::AbsolutePositive || kind == TargetKind::AbsoluteNegative))
    return BlockNeedsModulo;
  const bool outside = block.position < 0.0 || block.position >= limits.modulo_range;
  return modulo && kind != TargetKind::Relative && outside ? std::optional{BlockOutsideModulo} : std::nullopt;
}

void check_blocks(const BlockTable& table, const BlockLimits& limits, PositioningMessages& messages) noexcept {
  struct Finding {
    PositioningMessage message = NoSubsequentBlock;
    int lowest = static_cast<int>(kTraversingBlocks);
  };
  std::array findings{Finding{NoSubsequentBlock},  Finding{BlockNumberTwice}, Finding{IllegalTaskParameter},
                      Finding{NoJumpDestination},  Finding{BlockBelowLimit},  Finding{BlockAboveLimit},
                      Finding{BlockOutsideModulo}, Finding{BlockNeedsModulo}};
  const auto note = [&](std::optional<PositioningMessage> message, int number) {
    if (!message) return;
    Finding& finding = *std::ranges::find(findings, *message, &Finding::message);
    finding.lowest = std::min(finding.lowest, number);
  };
  for (std::size_t entry = 0; entry < table.size(); ++entry) {
    const TraversingBlock block = table.at(entry);
    if (block.number < 0 || block.is_hidden()) continue;
    note(inconsistency(table, block, limits), block.number);
    note(beyond(block, limits), block.number);
  }
  for (const Finding& finding : findings) {
    const bool stands = finding.lowest < static_cast<int>(kTraversingBlocks);
    messages.show(finding.message, stands, stands ? static_cast<std::uint32_t>(finding.lowest) : 0U);
  }
}

}  // namespace drive
