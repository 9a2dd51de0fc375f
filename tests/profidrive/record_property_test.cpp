/// What holds of every answer, whatever is asked.
#include <initializer_list>
#include <random>

#include "profidrive/parameter/format.hpp"
#include "tests/profidrive/record_unit.hpp"
#include "tests/profidrive/well_formed.hpp"

namespace profidrive {
namespace {

/// A request that is nearly right: numbers that exist, formats and counts at random.
Bytes likely_request(std::mt19937& random) {
  const auto below = [&](unsigned limit) { return std::uniform_int_distribution<unsigned>{0, limit - 1}(random); };
  const auto byte = [](unsigned value) { return static_cast<std::uint8_t>(value); };
  constexpr std::array<std::uint8_t, 5> kAttributes{0x10, 0x10, 0x10, 0x20, 0x30};
  const bool writes = below(3) == 0;
  const unsigned count = 1 + below(below(4) == 0 ? 39 : 3);
  Bytes request{byte(below(256)), byte(writes ? 2 : 1), byte(below(4)), byte(count)};
  for (unsigned i = 0; i < count; ++i) {
    const auto rows = drive::parameter_rows();
    const drive::ParameterRow& row = *rows[below(static_cast<unsigned>(rows.size()))];
    const unsigned sub_index = below(4) == 0 ? below(row.count + 2U) : 0;
    for (const unsigned value : std::initializer_list<unsigned>{
             unsigned{kAttributes[below(5)]}, below(3) == 0 ? below(70) : 1U, unsigned{row.number} >> 8,
             row.number & 0xFFU, sub_index >> 8, sub_index & 0xFFU})
      request.push_back(byte(value));
  }
  for (unsigned i = 0; writes && i < count; ++i) {
    const FormatRow& format = kFormats[below(static_cast<unsigned>(kFormats.size()))];
    request.push_back(byte(below(20) == 0 ? below(256) : static_cast<unsigned>(format.format)));
    const unsigned values = below(4) == 0 ? below(5) : 1;
    request.push_back(byte(values));
    for (unsigned j = 0; j < values * format.size + values * format.size % 2; ++j)
      request.push_back(byte(below(256)));
  }
  return request;
}

class RecordProperty : public testing::Test {
 protected:
  const unsigned seed_ = std::random_device{}();
  std::mt19937 random_{seed_};
  RecordUnit unit_{std::vector<device::AxisSetup>(2)};

  unsigned below(unsigned limit) { return std::uniform_int_distribution<unsigned>{0, limit - 1}(random_); }
  void expect_well_formed(const Bytes& request) {
    const Bytes answer = unit_.serve(request);
    ASSERT_EQ(broken_rule(request, answer), "")
        << "seed " << seed_ << ", request " << digits_of(request) << ", answer " << digits_of(answer);
  }
};

TEST_F(RecordProperty, AnswersAnyBytesWellFormed) {
  for (int i = 0; i < 20'000; ++i) {
    Bytes request(below(300));
    for (std::uint8_t& byte : request) byte = static_cast<std::uint8_t>(below(256));
    expect_well_formed(request);
  }
}

TEST_F(RecordProperty, AnswersLikelyRequestsWellFormed) {
  for (int i = 0; i < 20'000; ++i) expect_well_formed(likely_request(random_));
}

TEST_F(RecordProperty, AnswersRequestsThatAreCutWellFormed) {
  for (int i = 0; i < 300; ++i) {
    Bytes request = likely_request(random_);
    for (; !request.empty(); request.pop_back()) expect_well_formed(request);
  }
}

TEST_F(RecordProperty, AnswersAnyWordsOfAChannel) {
  for (int i = 0; i < 100'000; ++i) {
    ParameterChannel::Words words{};
    for (std::uint16_t& word : words)
      word = static_cast<std::uint16_t>(below(3) == 0 ? below(0x10000) : below(0x10));
    words[0] = static_cast<std::uint16_t>(below(16) << 12 | below(0x800));
    const ParameterChannel::Words answer = unit_.device.access_parameters(
        unit_.now, [&](drive::ParameterAccess& access) { return unit_.channel.exchange(words, access); });
    ASSERT_EQ(broken_rule(words, answer), "") << "seed " << seed_ << ", request " << testing::PrintToString(words)
                                              << ", answer " << testing::PrintToString(answer);
  }
}

}  // namespace
}  // namespace profidrive
