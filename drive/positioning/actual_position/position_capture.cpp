#include "drive/positioning/actual_position/position_capture.hpp"

#include "drive/positioning/actual_position/whole_numbers.hpp"

namespace drive {
namespace {

constexpr std::int32_t kTerminals = 8;
/// p2517 and p2518 from here to eight further on: the probe at a terminal, measured in every cycle.
constexpr std::int32_t kFirstCyclic = 11;

constexpr unsigned input_of(std::int32_t terminal) noexcept {
  return static_cast<unsigned>(terminal - 1);
}

/// The first zero mark that @p motion comes to; one where it begins was come to before.
constexpr std::optional<std::int64_t> first_mark(const DiscMotion& motion) noexcept {
  const std::int64_t turn = motion.per_revolution;
  if (motion.to > motion.from) {
    const std::int64_t mark = (floor_divide(motion.from, turn) + 1) * turn;
    return mark <= motion.to ? std::optional{mark} : std::nullopt;
  }
  const std::int64_t mark = floor_divide(motion.from - 1, turn) * turn;
  return motion.to < motion.from && mark >= motion.to ? std::optional{mark} : std::nullopt;
}

}  // namespace

void PositionCapture::follow(const CaptureRequest& request, const CaptureTerminals& terminals,
                             bool possible) noexcept {
  const bool begins = (request.mark && !before_.mark) || (request.probe && !before_.probe);
  const bool waited = awaits();
  before_ = request;
  if (begins) {
    start(request, terminals);
  } else if (!request.mark && !request.probe) {
    state_ = State::Idle;
    withdrawn_ = withdrawn_ || waited;
  }
  const bool both = request.mark && request.probe;
  if (awaits() && (!possible || both)) state_ = State::Interrupted;
}

void PositionCapture::start(const CaptureRequest& request, const CaptureTerminals& terminals) noexcept {
  if (request.mark) {
    mark_selection_ = terminals.mark_selection;
    return wait_for(terminals.equivalent_mark, false);
  }
  const std::int32_t terminal = terminals.probes[request.second_probe ? 1 : 0];
  if (terminal >= 1 && terminal <= kTerminals) return wait_for(terminal, request.falling_edge);
  const bool cyclic = terminal >= kFirstCyclic && terminal < kFirstCyclic + kTerminals;
  refusal_ = terminal == 0 ? kNoTerminal : cyclic ? kCyclic : kNotPossible;
  state_ = State::Refused;
}

void PositionCapture::wait_for(std::int32_t terminal, bool falling) noexcept {
  terminal_ = terminal;
  falling_ = falling;
  state_ = State::Waiting;
}

std::optional<Captured> PositionCapture::look(const DiscMotion& motion, const InputEdges& edges) noexcept {
  if (!awaits()) return std::nullopt;
  const std::optional<Captured> captured = terminal_ == 0 ? look_for_mark(motion, edges) : look_for_edge(edges);
  if (captured) state_ = State::Captured;
  return captured;
}

std::optional<Captured> PositionCapture::look_for_mark(const DiscMotion& motion,
                                                       const InputEdges& edges) const noexcept {
  const std::optional<std::int64_t> mark = first_mark(motion);
  if (!mark) return std::nullopt;
  const double instant = static_cast<double>(*mark - motion.from) / static_cast<double>(motion.to - motion.from);
  if (mark_selection_ > 0 && !edges.level_at(input_of(mark_selection_), instant)) return std::nullopt;
  return Captured{.instant = instant, .mark = mark};
}

std::optional<Captured> PositionCapture::look_for_edge(const InputEdges& edges) const noexcept {
  const double instant = (falling_ ? edges.falling : edges.rising)[input_of(terminal_)];
  if (instant < 0.0) return std::nullopt;
  return Captured{.instant = instant};
}

}  // namespace drive
