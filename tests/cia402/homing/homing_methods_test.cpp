// Every method from every place of start, against the table of methods in words: where home is follows from the
// places of the switches alone.
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/cia402/homing/homing_axis.hpp"

namespace cia402 {
namespace {

/// Where the axis starts.
enum Start { kOnN, kInA, kInB, kInC, kOnP, kStarts };
constexpr std::string_view kStartNames = "NABCP";

/// What the table says. The edge is that of N, of P, the left one of H (L) or its right one (R); methods 3 to 6
/// have an H that goes on to the end of travel on one side.
struct Row {
  int method;
  char edge;
  bool falls;
  int direction;                       ///< of the final crossing
  std::array<int, kStarts> reversals;  ///< from N, A, B, C, P
};

constexpr std::array kRows{
    Row{1, 'N', true, +1, {0, 1, 1, 1, 1}},   Row{2, 'P', true, -1, {1, 1, 1, 1, 0}},
    Row{3, 'L', true, -1, {1, 1, 0, 0, 0}},   Row{4, 'L', false, +1, {0, 0, 1, 1, 1}},
    Row{5, 'R', true, +1, {0, 0, 0, 1, 1}},   Row{6, 'R', false, -1, {1, 1, 1, 0, 0}},
    Row{7, 'L', true, -1, {1, 1, 0, 1, 0}},   Row{8, 'L', false, +1, {0, 0, 1, 2, 1}},
    Row{9, 'R', false, -1, {1, 1, 1, 1, 0}},  Row{10, 'R', true, +1, {0, 0, 0, 2, 1}},
    Row{11, 'R', true, +1, {0, 1, 0, 1, 1}},  Row{12, 'R', false, -1, {1, 2, 1, 0, 0}},
    Row{13, 'L', false, +1, {0, 1, 1, 1, 1}}, Row{14, 'L', true, -1, {1, 2, 0, 0, 0}},
};

/// Places of the switches (load revolutions).
struct Layout {
  double negative_end = -4.0;
  double left = 2.0;
  double right = 4.0;
  double positive_begin = 8.0;
  std::array<double, kStarts> starts{-5.07, 0.13, 3.21, 6.31, 9.17};

  Layout shifted(double by) const {
    return {negative_end + by, left + by, right + by, positive_begin + by, starts};
  }
  double place_of(char edge) const {
    return edge == 'N' ? negative_end : edge == 'P' ? positive_begin : edge == 'L' ? left : right;
  }
  TravelSwitches switches(int method) const {
    const int kind = method % 16;
    TravelSwitches fitted;
    fitted.set(Signal::NegativeLimit, {.from = -kEndless, .to = negative_end});
    fitted.set(Signal::PositiveLimit, {.from = positive_begin, .to = kEndless});
    fitted.set(Signal::Home, {.from = kind == 5 || kind == 6 ? -kEndless : left,
                              .to = kind == 3 || kind == 4 ? kEndless : right});
    return fitted;
  }
};

/// The first index from @p edge (increments) on, where it is one itself included.
double index_from(double edge, int direction) {
  constexpr double kNothing = 1e-6;
  return direction > 0 ? std::ceil((edge - kNothing) / kTurn) * kTurn
                       : std::floor((edge + kNothing) / kTurn) * kTurn;
}

/// What the axis has come past last: signal, rising or falling, and which way.
struct Crossing {
  Signal signal{};
  bool falls = false;
  int direction = 0;
};

/// Homes, and looks at what the axis comes past until then: levels by comparison of places, cycle by cycle.
class WatchedHoming {
 public:
  WatchedHoming(HomingAxis& axis, const TravelSwitches& switches) : axis_{axis}, switches_{switches} {}

  void run() {
    former_ = axis_.load();
    for (int i = 0; i < 100'000 && axis_.homing.is_running(); ++i) {
      axis_.cycle();
      reversals_ = axis_.reversals();
      look();
    }
  }
  const Crossing& last_of(Signal signal) const { return last_[static_cast<std::size_t>(signal)]; }
  int reversals() const { return reversals_; }

 private:
  void look() {
    const double place = axis_.load();
    for (const Signal signal : TravelSwitches::kSignals) {
      const auto& fitted = switches_.of(signal);
      if (!fitted || fitted->is_on_at(place) == fitted->is_on_at(former_)) continue;
      last_[static_cast<std::size_t>(signal)] = {signal, fitted->is_on_at(former_), place > former_ ? 1 : -1};
    }
    former_ = place;
  }

  HomingAxis& axis_;
  TravelSwitches switches_;
  double former_ = 0.0;
  int reversals_ = 0;
  std::array<Crossing, TravelSwitches::kSignals.size()> last_{};
};

/// An axis that is quick enough to overshoot every switch by revolutions.
void hurry(HomingSettings& settings) {
  settings.switch_speed = 60.0 * kTurn;
  settings.zero_speed = 7.0 * kTurn;
  settings.acceleration = 400.0 * kTurn;
}

struct Case {
  const Row& row;
  Layout layout;
  int start;
  bool to_index;
  double gear = 1.0;
  bool hurries = false;
  bool is_narrow = false;

  int method() const { return row.method + (to_index ? 0 : 16); }
  double home() const {
    const double edge = layout.place_of(row.edge) * gear * kTurn;
    return to_index ? index_from(edge, row.direction) : edge;
  }
  std::string text() const {
    return "method " + std::to_string(method()) + " from " + kStartNames[static_cast<std::size_t>(start)] +
           ", L at " + std::to_string(layout.left) + ", gear " + std::to_string(gear) + (hurries ? ", quick" : "");
  }
};

void expect_home(const Case& the) {
  SCOPED_TRACE(the.text());
  const TravelSwitches switches = the.layout.switches(the.method());
  HomingAxis axis{switches, the.layout.starts[static_cast<std::size_t>(the.start)], the.gear};
  if (the.hurries) hurry(axis.settings);
  axis.start(the.method());
  EXPECT_EQ(axis.bits(), "000");
  WatchedHoming watched{axis, switches};
  watched.run();

  ASSERT_TRUE(axis.home());
  EXPECT_NEAR(*axis.home(), the.home(), 1e-6);
  EXPECT_EQ(watched.reversals(), the.row.reversals[static_cast<std::size_t>(the.start)]);
  EXPECT_EQ(axis.demand().velocity < 0.0 ? -1 : 1, the.row.direction);
  if (!the.is_narrow) {
    const Signal signal = the.row.edge == 'N'   ? Signal::NegativeLimit
                          : the.row.edge == 'P' ? Signal::PositiveLimit
                                                : Signal::Home;
    const Crossing& last = watched.last_of(signal);
    EXPECT_EQ(last.direction, the.row.direction);
    EXPECT_EQ(last.falls, the.row.falls);
  }
  EXPECT_EQ(axis.run(), "010 011");
}

/// Places of the edges in the revolution of the motor: index at the edge, close to either side of it, between.
constexpr std::array kOffsets{0.0, 1.0 / 65536.0, -1.0 / 65536.0, 0.004, 0.25, 0.5, 0.777, 0.996};

TEST(HomingMethods, ComeToTheIndexBehindTheEdgeFromEveryPlace) {
  for (const double gear : {1.0, 3.0})
    for (const Row& row : kRows)
      for (int start = 0; start < kStarts; ++start)
        for (const double offset : kOffsets) expect_home({row, Layout{}.shifted(offset), start, true, gear});
}

TEST(HomingMethods, ComeToTheEdgeFromEveryPlace) {
  for (const double gear : {1.0, 3.0})
    for (const Row& row : kRows)
      for (int start = 0; start < kStarts; ++start)
        for (const double offset : kOffsets) expect_home({row, Layout{}.shifted(offset), start, false, gear});
}

TEST(HomingMethods, ComeToTheSamePlaceWithOvershoot) {
  for (const Row& row : kRows)
    for (int start = 0; start < kStarts; ++start)
      for (const double offset : kOffsets)
        for (const bool to_index : {true, false})
          expect_home({row, Layout{}.shifted(offset), start, to_index, 1.0, true});
}

TEST(HomingMethods, SeeACamThatLiesWithinACycle) {
  Layout layout{.right = 2.01, .starts = {-5.07, 0.13, 2.0051, 6.31, 9.17}};
  for (const Row& row : kRows) {
    if (row.method < 7) continue;
    for (int start = 0; start < kStarts; ++start)
      for (const bool to_index : {true, false}) expect_home({row, layout, start, to_index, 1.0, true, true});
  }
}

TEST(HomingMethods, SeeLimitSwitchesThatAreOvershot) {
  for (const Row& row : kRows) {
    if (row.method >= 3 && row.method <= 6) continue;
    TravelSwitches switches = Layout{}.switches(row.method);
    switches.set(Signal::NegativeLimit, {.from = -4.01, .to = -4.0});
    switches.set(Signal::PositiveLimit, {.from = 8.0, .to = 8.01});
    for (const int start : {kInA, kInB, kInC}) {
      HomingAxis axis{switches, Layout{}.starts[static_cast<std::size_t>(start)]};
      hurry(axis.settings);
      axis.start(row.method + 16);
      EXPECT_EQ(axis.run(), "000 010 011");
      ASSERT_TRUE(axis.home()) << row.method;
      EXPECT_NEAR(*axis.home(), Layout{}.place_of(row.edge) * kTurn, 1e-6) << row.method << ' ' << start;
    }
  }
}

TEST(HomingMethods, 33And34ComeToTheNextIndexInTheirDirection) {
  for (int start = kInA; start <= kInC; ++start)
    for (const double offset : {0.0, 0.001, 0.3, 0.9999})
      for (const int direction : {-1, 1}) {
        const double place = std::floor(Layout{}.starts[static_cast<std::size_t>(start)]) + offset;
        HomingAxis axis{Layout{}.switches(33), place};
        axis.start(direction < 0 ? 33 : 34);
        const std::string seen = axis.run();
        EXPECT_TRUE(seen == "000 010 011" || seen == "000 011")
            << seen << ": an index that is near needs no braking";
        ASSERT_TRUE(axis.home());
        const double expected = direction < 0 ? std::ceil(place - 1e-6) - 1.0 : std::floor(place + 1e-6) + 1.0;
        EXPECT_EQ(*axis.home(), expected * kTurn) << place << ' ' << direction;
        EXPECT_EQ(axis.reversals(), 0);
      }
}

TEST(HomingMethods, 33And34LeaveTheirOtherLimitSwitch) {
  for (const int method : {33, 34}) {
    HomingAxis axis{Layout{}.switches(method), method == 33 ? 9.17 : -5.07};
    axis.start(method);
    EXPECT_EQ(axis.run(), "000 010 011");
    ASSERT_TRUE(axis.home());
    EXPECT_EQ(*axis.home(), (method == 33 ? 9.0 : -5.0) * kTurn);
  }
}

TEST(HomingMethods, 35And37AreHomeWhereTheyStand) {
  for (const int method : {35, 37})
    for (int start = 0; start < kStarts; ++start) {
      HomingAxis axis{Layout{}.switches(method), Layout{}.starts[static_cast<std::size_t>(start)]};
      const std::int64_t counts = axis.counts();
      axis.start(method);
      EXPECT_EQ(axis.bits(), "000") << "in the update of the start";
      axis.cycle();
      EXPECT_EQ(axis.bits(), "011") << "1 ms later";
      ASSERT_TRUE(axis.home());
      EXPECT_EQ(*axis.home(), static_cast<double>(counts));
      axis.cycles(100);
      EXPECT_EQ(axis.counts(), counts);
    }
}

TEST(HomingMethods, 36ComesToTheRisingEdgeOfProbe1Upwards) {
  for (const double place : {0.13, 1.999, 2.5, -5.07}) {
    TravelSwitches switches = Layout{}.switches(36);
    switches.set(Signal::Probe1, {.from = 2.0, .to = 3.123, .inverted = true});
    HomingAxis axis{switches, place};
    axis.start(36);
    EXPECT_EQ(axis.run(), "000 010 011");
    ASSERT_TRUE(axis.home());
    EXPECT_NEAR(*axis.home(), 3.123 * kTurn, 1e-6);
    EXPECT_EQ(axis.reversals(), 0);
  }
}

TEST(HomingMethods, AreThirtyThree) {
  std::set<int> numbers;
  for (const HomingMethod& method : kHomingMethods) numbers.insert(method.number);
  EXPECT_EQ(numbers.size(), 33U);
  EXPECT_EQ(kHomingMethods.size(), 33U);
  for (int number = -128; number < 128; ++number) {
    const bool exists =
        (number >= 1 && number <= 14) || (number >= 17 && number <= 30) || (number >= 33 && number <= 37);
    const HomingMethod* const found = find_homing_method(number);
    EXPECT_EQ(found != nullptr, exists) << number;
    EXPECT_EQ(found != nullptr ? found->number : number, number);
  }
}

}  // namespace
}  // namespace cia402
