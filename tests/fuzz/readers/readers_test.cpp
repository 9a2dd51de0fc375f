// What the fuzzer begins with, and what it has found, read by the rules; and the same cut short and with bytes
// changed.
#include "tests/fuzz/readers/readers.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "control/methods.hpp"
#include "control/protocol.hpp"
#include "control/request_check.hpp"

namespace fuzz {
namespace {

struct Reader : testing::TestWithParam<ReaderRow> {
  static std::string broken(const std::string& text) {
    return GetParam().broken_rule(std::as_bytes(std::span{text}));
  }
};

TEST_P(Reader, KeepsItsRulesWithWhatItBeginsWith) {
  const std::vector<std::string> inputs = inputs_of(GetParam());
  EXPECT_FALSE(inputs.empty());
  for (const std::string& input : inputs) EXPECT_EQ(broken(input), "") << input.substr(0, 200);
}

TEST_P(Reader, KeepsItsRulesWhenBytesAreOthers) {
  constexpr int kInputs = 1000;
  constexpr std::size_t kLongest = 4096;
  constexpr unsigned kSeed = 27;
  SCOPED_TRACE("seed " + std::to_string(kSeed));
  const std::vector<std::string> inputs = inputs_of(GetParam());
  std::mt19937 random{kSeed};
  for (int i = 0; i < kInputs; ++i) {
    std::string input = inputs[random() % inputs.size()].substr(0, kLongest);
    if (i % 4 == 0) input.resize(random() % (input.size() + 1));
    for (unsigned change = 0; change <= random() % 4 && !input.empty(); ++change)
      input[random() % input.size()] = static_cast<char>(random());
    ASSERT_EQ(broken(input), "") << "input " << i;
  }
}

TEST(ReaderOfConfigurations, BeginsWithSomeThatAreTaken) {
  for (const std::string& text : made_configurations()) EXPECT_TRUE(takes_configuration(text)) << text;
}

TEST(ReaderOfRequests, BeginsWithSomeThatAreTaken) {
  const std::vector<std::string> lines = made_control();
  for (const char* const name : {"parameter.read", "parameter.write", "object.read", "inject.add"})
    EXPECT_TRUE(std::ranges::any_of(lines, [&](const std::string& line) {
      const auto request = control::parse_request(line);
      return request && request->method == name &&
             control::check(*control::find_method(name), request->params, 1).has_value();
    })) << name;
}

INSTANTIATE_TEST_SUITE_P(Readers, Reader, testing::ValuesIn(readers().begin(), readers().end()),
                         [](const auto& row) { return std::string{row.param.name}; });

}  // namespace
}  // namespace fuzz
