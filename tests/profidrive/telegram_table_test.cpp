#include <algorithm>
#include <array>

#include <gtest/gtest.h>

#include "drive/catalogue/table.hpp"
#include "profidrive/telegram/telegrams.hpp"

namespace profidrive {
namespace {

struct Size {
  unsigned number;
  std::size_t received, sent;
};
constexpr std::array kSizes{
    Size{1, 2, 2},     Size{2, 4, 4},    Size{3, 5, 9},     Size{4, 6, 14},    Size{5, 9, 9},    Size{6, 10, 14},
    Size{7, 2, 2},     Size{9, 10, 5},   Size{20, 2, 6},    Size{102, 6, 10},  Size{103, 7, 15}, Size{105, 10, 10},
    Size{106, 11, 15}, Size{110, 12, 7}, Size{111, 12, 12}, Size{116, 11, 19}, Size{350, 4, 4},  Size{352, 6, 6},
    Size{353, 2, 2},   Size{354, 6, 6},  Size{390, 2, 2},   Size{391, 3, 7},   Size{394, 3, 3},
};

TEST(TelegramTable, HasTelegramsOfTheLengthsThatTheFieldKnows) {
  ASSERT_EQ(telegrams::kAll.size(), kSizes.size());
  for (std::size_t i = 0; i < kSizes.size(); ++i) {
    const Telegram& telegram = telegrams::kAll[i];
    SCOPED_TRACE(telegram.number);
    EXPECT_EQ(telegram.number, kSizes[i].number);
    EXPECT_EQ(words_of(telegram.received), kSizes[i].received);
    EXPECT_EQ(words_of(telegram.sent), kSizes[i].sent);
  }
}

TEST(TelegramTable, LeadsBitsOfTheFirstFourWordsOnly) {
  for (const Telegram& telegram : telegrams::kAll) {
    std::size_t place = 0;
    for (const ReceivedWord* const word : telegram.received) {
      for (const auto& group : word->sinks)
        for (const Sink& sink : group)
          EXPECT_TRUE(sink.part != Sink::Part::Bit || place < 4)
              << telegram.number << " " << word->name << " p" << sink.input;
      place += word->words;
    }
  }
}

/// Of the parameters that a telegram speaks of all that the unit has exist as inputs and outputs.
TEST(TelegramTable, SpeaksOfInputsAndOutputs) {
  for (const Telegram& telegram : telegrams::kAll) {
    const auto kind = drive::contains(telegram.kinds, drive::ObjectKind::ControlUnit)
                          ? drive::ObjectKind::ControlUnit
                      : drive::contains(telegram.kinds, drive::ObjectKind::Servo) ? drive::ObjectKind::Servo
                                                                                  : drive::ObjectKind::Vector;
    for (const ReceivedWord* const word : telegram.received)
      for (const auto& group : word->sinks)
        for (const Sink& sink : group) {
          const drive::PlacedRow* const placed = drive::find_parameter(kind, sink.input);
          if (placed == nullptr) continue;
          const bool is_bit = sink.part == Sink::Part::Bit || sink.part == Sink::Part::FirstConverter;
          EXPECT_EQ(placed->row->type, is_bit ? drive::DataType::BinectorInput : drive::DataType::ConnectorInput)
              << "p" << sink.input;
        }
    for (const SentWord* const word : telegram.sent) {
      if (word->bits == nullptr) continue;
      for (const StatusBit& bit : *word->bits) {
        const drive::PlacedRow* const placed = drive::find_parameter(kind, bit.number);
        EXPECT_TRUE(bit.number == 0 || placed == nullptr || drive::has_bits(*placed->row)) << "r" << bit.number;
      }
    }
  }
}

}  // namespace
}  // namespace profidrive
