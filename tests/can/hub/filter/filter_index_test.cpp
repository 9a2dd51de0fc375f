#include "can/hub/filter/filter_index.hpp"

#include <iostream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>
#include <linux/can/error.h>

#include "tests/can/hub/told.hpp"

namespace hub {
namespace {

using Place = FilterIndex::Place;
using Places = std::vector<Place>;

constexpr canid_t kStandardOnly = CAN_EFF_FLAG | CAN_RTR_FLAG | CAN_SFF_MASK;
constexpr canid_t kExtendedOnly = CAN_EFF_FLAG | CAN_RTR_FLAG | CAN_EFF_MASK;

/// Who takes a frame with @p id.
Places takers(FilterIndex& index, canid_t id) {
  Places places;
  index.find(id);
  for (Place place = 0; place < index.words() * FilterIndex::kPlacesOfWord; ++place)
    if ((index.found(place / FilterIndex::kPlacesOfWord) >> place % FilterIndex::kPlacesOfWord & 1) != 0)
      places.push_back(place);
  return places;
}

FilterSet set_of(const std::vector<can_filter>& filters) {
  FilterSet set;
  set.assign(filters);
  return set;
}

TEST(FilterIndex, FindsNobodyAtFirst) {
  FilterIndex index;
  EXPECT_EQ(takers(index, 0x123), Places{});

  EXPECT_EQ(index.add(), 0u);

  for (const canid_t id : {0x123U, 0x123U | CAN_EFF_FLAG, CAN_ERR_FLAG | CAN_ERR_BUSOFF, 0x12345U})
    EXPECT_EQ(takers(index, id), Places{}) << std::hex << id;
}

TEST(FilterIndex, FindsWhoTakesAllWhateverTheFrame) {
  FilterIndex index;
  const Place place = index.add();

  index.take_all(place);

  for (const canid_t id : {0x123U, 0x123U | CAN_RTR_FLAG, 0x123U | CAN_EFF_FLAG, CAN_ERR_FLAG, 0x12345U})
    EXPECT_EQ(takers(index, id), Places{place}) << std::hex << id;

  index.take_nothing(place);
  EXPECT_EQ(takers(index, 0x123), Places{});
}

TEST(FilterIndex, FollowsFiltersThatAreReplaced) {
  FilterIndex index;
  const Place place = index.add();
  FilterSet filters = set_of({{0x123, kStandardOnly}, {0x18DA00F1 | CAN_EFF_FLAG, kExtendedOnly}});
  index.take(place, filters);
  EXPECT_EQ(takers(index, 0x123), Places{place});
  EXPECT_EQ(takers(index, 0x18DA00F1 | CAN_EFF_FLAG), Places{place});

  filters.assign(std::vector<can_filter>{{0x18DA00F2 | CAN_EFF_FLAG, kExtendedOnly & ~CAN_RTR_FLAG}});
  index.take(place, filters);

  EXPECT_EQ(takers(index, 0x123), Places{});
  EXPECT_EQ(takers(index, 0x18DA00F1 | CAN_EFF_FLAG), Places{});
  EXPECT_EQ(takers(index, 0x18DA00F2 | CAN_EFF_FLAG), Places{place});
  EXPECT_EQ(takers(index, 0x18DA00F2 | CAN_EFF_FLAG | CAN_RTR_FLAG), Places{place});
}

TEST(FilterIndex, HasAsManyPlacesAsAreWantedAndGivesThemAgain) {
  FilterIndex index;
  const FilterSet all;
  Places places;
  for (int i = 0; i < 200; ++i) {
    places.push_back(index.add());
    index.take(places.back(), all);
  }
  EXPECT_EQ(takers(index, 0x7FF), places);

  index.remove(70);
  EXPECT_EQ(takers(index, 0x7FF).size(), 199u);
  EXPECT_EQ(index.add(), 70u);
  EXPECT_EQ(takers(index, 0x7FF).size(), 199u) << "who is new takes nothing";
}

/// What the kernel makes of one filter, put as its lists of receivers are (net/can/af_can.c).
bool kernel_matches(const can_filter& filter, canid_t frame) {
  if ((filter.can_mask & CAN_ERR_FLAG) != 0)
    return (frame & CAN_ERR_FLAG) != 0 && (frame & filter.can_mask & CAN_ERR_MASK) != 0;
  if ((frame & CAN_ERR_FLAG) != 0) return false;
  const bool is_extended = (filter.can_id & CAN_EFF_FLAG) != 0;
  canid_t mask = filter.can_mask;
  if ((mask & CAN_EFF_FLAG) != 0 && !is_extended) mask &= kStandardOnly;
  const canid_t id = filter.can_id & mask;
  if ((filter.can_id & CAN_INV_FILTER) != 0) return (frame & mask) != id;
  const bool is_single = (id & CAN_RTR_FLAG) == 0 && mask == (is_extended ? kExtendedOnly : kStandardOnly);
  if (!is_single) return (frame & mask) == id;
  if ((frame & CAN_RTR_FLAG) != 0 || (frame & CAN_EFF_FLAG) != (id & CAN_EFF_FLAG)) return false;
  return is_extended ? frame == id : (frame & CAN_SFF_MASK) == id;
}

/// Somebody who takes frames, and a loop over what was asked for.
struct Taker {
  std::vector<can_filter> filters;
  std::uint32_t error_mask = 0;
  bool joined = false;
  FilterSet set;

  void apply() {
    set.assign(filters);
    set.set_error_mask(error_mask);
    set.set_joined(joined);
  }
  [[nodiscard]] bool takes(canid_t frame) const {
    std::size_t matches = (frame & CAN_ERR_FLAG) != 0 && (frame & error_mask) != 0 ? 1U : 0U;
    for (const can_filter& filter : filters) matches += kernel_matches(filter, frame) ? 1U : 0U;
    return matches > 0 && (!joined || matches >= filters.size());
  }
};

/// Filters and frames of which many meet.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_{seed} {}

  unsigned number(unsigned below) { return static_cast<unsigned>(random_() % below); }
  bool in(unsigned so_many) { return number(so_many) == 0; }
  canid_t frame() {
    if (in(16)) return static_cast<canid_t>(random_());
    const canid_t flags[]{0,           0, 0, CAN_RTR_FLAG, CAN_EFF_FLAG, CAN_EFF_FLAG, CAN_EFF_FLAG | CAN_RTR_FLAG,
                          CAN_ERR_FLAG};
    const canid_t flag = flags[number(std::size(flags))];
    const bool is_short = flag == 0 || flag == CAN_RTR_FLAG;
    const canid_t id = in(2) ? kSome[number(std::size(kSome))] : static_cast<canid_t>(random_()) & CAN_EFF_MASK;
    return flag | (is_short && !in(32) ? id & CAN_SFF_MASK : id);
  }
  can_filter filter() {
    constexpr canid_t kMasks[]{0,
                               CAN_SFF_MASK,
                               CAN_EFF_MASK,
                               kStandardOnly,
                               kStandardOnly,
                               kExtendedOnly,
                               kExtendedOnly,
                               kExtendedOnly & ~CAN_RTR_FLAG,
                               CAN_EFF_FLAG,
                               CAN_RTR_FLAG,
                               0x780,
                               0x1FFFF00 | CAN_EFF_FLAG,
                               CAN_ERR_FLAG | CAN_ERR_MASK,
                               CAN_ERR_FLAG | CAN_ERR_CRTL};
    const canid_t mask = in(8) ? static_cast<canid_t>(random_()) : kMasks[number(std::size(kMasks))];
    return {.can_id = frame() | (in(8) ? CAN_INV_FILTER : 0U), .can_mask = mask};
  }
  void change(Taker& taker) {
    taker.filters.clear();
    const unsigned most = in(20) ? CAN_RAW_FILTER_MAX : 5;
    for (unsigned left = number(most); left > 0; --left) taker.filters.push_back(filter());
    taker.error_mask = in(4) ? static_cast<std::uint32_t>(random_()) & CAN_ERR_MASK : 0;
    taker.joined = in(4);
    taker.apply();
  }

 private:
  static constexpr canid_t kSome[]{0, 1, 0x7F, 0x80, 0x181, 0x7FF, 0x800, 0x18DA00F1, 0x18FEF100, 0x1FFFFFFF};

  std::mt19937 random_;
};

TEST(FilterIndex, FindsExactlyThoseWhoseFiltersTheKernelWouldLetTheFramePass) {
  const unsigned seed = told::seed();
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  Dice dice{seed};
  FilterIndex index;
  std::map<Place, std::unique_ptr<Taker>> takers_of;  // none: takes nothing
  std::size_t met = 0;
  for (int round = 0; round < 1000; ++round) {
    if (takers_of.size() < 150 && !dice.in(3)) takers_of[index.add()] = nullptr;
    if (takers_of.empty()) continue;
    const auto chosen = std::next(takers_of.begin(), dice.number(static_cast<unsigned>(takers_of.size())));
    if (dice.in(12)) {
      index.remove(chosen->first);
      takers_of.erase(chosen);
    } else if (dice.in(12)) {
      index.take_nothing(chosen->first);
      chosen->second = nullptr;
    } else {
      if (!chosen->second) chosen->second = std::make_unique<Taker>();
      dice.change(*chosen->second);
      index.take(chosen->first, chosen->second->set);
    }
    for (int i = 0; i < 20; ++i) {
      const canid_t frame = dice.frame();
      Places expected;
      for (const auto& [place, taker] : takers_of)
        if (taker && taker->takes(frame)) expected.push_back(place);
      met += expected.size();
      ASSERT_EQ(takers(index, frame), expected)
          << "frame " << std::hex << frame << " in round " << std::dec << round;
    }
  }
  EXPECT_GT(met, 10'000u) << "frames and filters that do not meet show nothing";
}

TEST(FilterIndex, FindsEveryStandardFrameThatASetLetsPass) {
  const unsigned seed = told::seed();
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  Dice dice{seed};
  for (int round = 0; round < 50; ++round) {
    FilterIndex index;
    const Place place = index.add();
    Taker taker;
    dice.change(taker);
    index.take(place, taker.set);
    for (canid_t id = 0; id <= CAN_SFF_MASK; ++id)
      for (const canid_t frame : {id, id | CAN_RTR_FLAG})
        ASSERT_EQ(takers(index, frame) == Places{place}, taker.takes(frame)) << std::hex << frame;
  }
}

}  // namespace
}  // namespace hub
