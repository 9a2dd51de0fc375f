// The handshake of bit 4 with bit 12 as a table: every sequence of controlwords.
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>

#include <gtest/gtest.h>

#include "tests/cia402/profile/positioned_axis.hpp"

namespace cia402 {
namespace {

/// What the standard says of two places, in words as short as they can be said.
struct Model {
  std::optional<double> running{}, waiting{};
  bool bit_4 = false, bit_12 = false, bit_10 = true;
  double last = 0.0;

  void write(bool new_set_point, bool immediately, double target) {
    const bool edge = new_set_point && !bit_4;
    bit_4 = new_set_point;
    const bool only_the_waiting_one_is_in_the_way = waiting && immediately;
    if (edge && (!bit_12 || only_the_waiting_one_is_in_the_way)) take(immediately, target);
    settle();
  }
  void take(bool immediately, double target) {
    bit_12 = true;
    if (running && !immediately) {
      waiting = target;
    } else {
      running = target;
      waiting.reset();
      bit_10 = false;
    }
  }
  /// Bit 12 falls with bit 4 as soon as there is a free place.
  void settle() {
    if (!bit_4 && !waiting) bit_12 = false;
  }
  void reach_all() {
    last = waiting.value_or(running.value_or(last));
    running.reset();
    waiting.reset();
    bit_10 = true;
    settle();
  }
};

/// What passes between two writes.
enum class Pause : std::uint8_t { None, OneCycle, UntilAllIsReached };

class Handshake : public testing::TestWithParam<std::tuple<Pause, bool>> {
 protected:
  static constexpr int kLength = 6;
  static constexpr double kFar = 1e6;   // of a set-point that is not reached
  static constexpr double kNear = 0.1;  // of one that soon is

  Pause pause() const { return std::get<0>(GetParam()); }
  void check(const PositionedAxis& axis, const Model& model, bool knows_target) {
    ASSERT_EQ(axis.acknowledges(), model.bit_12) << sequence_;
    ASSERT_EQ(axis.is_reached(), model.bit_10) << sequence_;
    if (!knows_target) return;
    ASSERT_EQ(axis.mode.target(), model.running.value_or(model.last)) << sequence_;
  }
  void let_pass(PositionedAxis& axis, Model& model) {
    if (pause() == Pause::OneCycle) axis.cycle();
    if (pause() != Pause::UntilAllIsReached) return;
    axis.run(40);
    model.reach_all();
    ASSERT_EQ(axis.position(), model.last) << sequence_;
  }
  /// All sequences that go on from here.
  void go_on(const PositionedAxis& before, const Model& model_before, int depth) {
    if (depth == kLength || HasFatalFailure()) return;
    const std::string sequence = sequence_;
    for (unsigned bits = 0; bits < 8; ++bits) {
      PositionedAxis axis = before;
      Model model = model_before;
      const bool bit_4 = (bits & 1U) != 0, bit_5 = (bits & 2U) != 0, bit_9 = (bits & 4U) != 0;
      sequence_ = sequence + (bit_4 ? " 4" : " -") + (bit_5 ? "5" : "-") + (bit_9 ? "9" : "-");
      const double step = pause() == Pause::UntilAllIsReached ? kNear : kFar;
      axis.settings.target = step * (depth + 2);
      axis.write(static_cast<std::uint16_t>(kEnabled | (bit_4 ? kNewSetPoint : 0) | (bit_5 ? kImmediately : 0) |
                                            (bit_9 ? kOnSetPoint : 0)));
      model.write(bit_4, bit_5, axis.settings.target);
      check(axis, model, false);
      let_pass(axis, model);
      if (pause() != Pause::None) check(axis, model, true);
      go_on(axis, model, depth + 1);
    }
    ++sequences_;
    sequence_ = sequence;
  }

  std::string sequence_;
  int sequences_ = 0;
};

TEST_P(Handshake, IsThatOfEverySequence) {
  PositionedAxis axis;
  Model model;
  if (std::get<1>(GetParam())) {
    axis.give(-kFar);
    axis.write(kEnabled);
    axis.run(10);
    model.write(true, false, -kFar);
    model.write(false, false, 0.0);
  }
  go_on(axis, model, 0);
  EXPECT_EQ(sequences_, (1 << 18) / 7);  // 1 + 8 + ... + 8^5
}

INSTANTIATE_TEST_SUITE_P(Idle, Handshake,
                         testing::Combine(testing::Values(Pause::None, Pause::OneCycle, Pause::UntilAllIsReached),
                                          testing::Values(false)));
INSTANTIATE_TEST_SUITE_P(Running, Handshake,
                         testing::Combine(testing::Values(Pause::None, Pause::OneCycle), testing::Values(true)));

}  // namespace
}  // namespace cia402
