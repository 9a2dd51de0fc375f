#include "cia402/modes/homing/homing_search.hpp"

#include <cmath>

namespace cia402 {
namespace {

constexpr Signal limit_of(Direction direction) noexcept {
  return direction == Direction::Positive ? Signal::PositiveLimit : Signal::NegativeLimit;
}

constexpr Direction direction_of(const InputEvent& event) noexcept {
  return event.is_upward ? Direction::Positive : Direction::Negative;
}

}  // namespace

void HomingSearch::begin(const HomingMethod& method, const InputLevels& levels, double position) noexcept {
  method_ = &method;
  levels_ = levels;
  start_ = position;
  has_edge_ = is_turned_ = false;
  const bool goes_ahead = method.way == HomingMethod::Way::Ahead;
  step_ = Step::Edge;
  direction_ = goes_ahead ? method.final_direction : method.initial;
  // An index is met in the speed for it from the beginning.
  if (method.signal == Signal::Index) step_ = Step::Index;
  if (!goes_ahead && levels.at(method.signal)) turn_at(Edge::Rising);
  look_ahead();
}

bool HomingSearch::follow(const InputEvent& event) noexcept {
  if (step_ == Step::Found || step_ == Step::Failed) return false;
  if (event.edge != Edge::Pulse) levels_.set(event.signal, event.edge == Edge::Rising);
  bool matters = is_final(event);
  if (matters) {
    cross(event.position);
  } else if (step_ == Step::Edge && event.signal == method_->signal && method_->way == HomingMethod::Way::Switch) {
    has_edge_ = matters = true;
    turn_at(event.edge);
  }
  return look_ahead() || matters;
}

/// Whether it is the edge, or the index, that is searched for.
bool HomingSearch::is_final(const InputEvent& event) const noexcept {
  if (direction_of(event) != method_->final_direction) return false;
  if (step_ == Step::Edge) return event.signal == method_->signal && event.edge == method_->edge;
  // The axis may have started on an index, which then is not the next one.
  return event.signal == Signal::Index && std::abs(event.position - start_) > 0.0;
}

/// The final edge or the index is at @p position (increments).
void HomingSearch::cross(double position) noexcept {
  home_ = position;
  direction_ = method_->final_direction;
  const bool goes_on = step_ == Step::Edge && method_->home == HomingMethod::Place::Index;
  step_ = goes_on ? Step::Index : Step::Found;
}

/// The switch is met or left, but not for the last time: to the side from which the final edge is crossed.
void HomingSearch::turn_at(Edge edge) noexcept {
  const bool has_crossed = edge == Edge::Rising && method_->edge == Edge::Rising;
  direction_ = has_crossed ? opposite(method_->final_direction) : method_->final_direction;
}

/// Whether a limit switch stands in the way; then it turns the motion round, or ends it.
bool HomingSearch::look_ahead() noexcept {
  bool matters = false;
  while ((step_ == Step::Edge || step_ == Step::Index) && levels_.at(limit_of(direction_))) {
    matters = true;
    if (step_ == Step::Edge && !is_turned_ && method_->reverses == limit_of(direction_)) {
      is_turned_ = true;
      direction_ = opposite(direction_);
    } else {
      step_ = Step::Failed;
    }
  }
  return matters;
}

}  // namespace cia402
