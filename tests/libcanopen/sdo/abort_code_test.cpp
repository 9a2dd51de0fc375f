#include <fstream>
#include <map>
#include <regex>

#include "tests/libcanopen/fixture/node_fixture.hpp"
#include "tests/libcanopen/fixture/sdo_client.hpp"

namespace {

using canopen::AbortCode;
using Bytes = SdoClient::Bytes;
using Outcome = SdoClient::Outcome;

std::vector<std::string> lines_of(const char* path) {
  std::ifstream file{std::string{SOURCE_FOLDER} + '/' + path};
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

/// The codes that the library has, eight digits each, with their names.
std::map<std::string, std::string> codes() {
  static const std::regex row{R"(\s+(\w+) = 0x([0-9A-F]{8}),)"};
  std::map<std::string, std::string> names;
  std::smatch match;
  for (const std::string& line : lines_of("libcanopen/od/abort_code.hpp"))
    if (std::regex_match(line, match, row)) names[match[2]] = match[1];
  return names;
}

/// The rows of the documentation: name and tests by code.
std::map<std::string, std::pair<std::string, std::string>> documented() {
  static const std::regex row{R"(\| ([0-9A-F]{8})h \| (\w+) \|.*\| ([^|]+) \|)"};
  std::map<std::string, std::pair<std::string, std::string>> rows;
  std::smatch match;
  for (const std::string& line : lines_of("docs/reference/abort-codes.md"))
    if (std::regex_match(line, match, row)) rows[match[1]] = {match[2], match[3]};
  return rows;
}

bool is_test(const std::string& name) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int suite = 0; suite < all.total_test_suite_count(); ++suite) {
    const testing::TestSuite& tests = *all.GetTestSuite(suite);
    for (int test = 0; test < tests.total_test_count(); ++test)
      if (std::string{tests.name()} + '.' + tests.GetTestInfo(test)->name() == name) return true;
  }
  return false;
}

/// Refuses everything with one code.
class Refusing final : public canopen::EntryOwner {
 public:
  canopen::Result<std::int64_t> read(const canopen::Entry&, std::int64_t) override {
    return canopen::refuse(code);
  }
  canopen::Result<void> write(const canopen::Entry&, std::int64_t) override { return canopen::refuse(code); }
  canopen::Result<std::span<const std::uint8_t>> read_text(const canopen::Entry&,
                                                           std::span<const std::uint8_t>) override {
    return canopen::refuse(code);
  }
  canopen::Result<void> write_text(const canopen::Entry&, std::span<const std::uint8_t>) override {
    return canopen::refuse(code);
  }
  AbortCode code{};
};

class AbortCodes : public NodeTest {
 protected:
  void SetUp() override { start(); }
  SdoClient client{*node, bus};
};

TEST_F(AbortCodes, AreAllDocumentedWithTestsThatExist) {
  const auto rows = documented();
  ASSERT_GE(codes().size(), 31U) << "the header was not understood";
  for (const auto& [code, name] : codes()) {
    const auto row = rows.find(code);
    ASSERT_NE(row, rows.end()) << code << ' ' << name;
    EXPECT_EQ(row->second.first, name) << code;
    static const std::regex test{"`([^`]+)`"};
    const std::string& tests = row->second.second;
    std::sregex_iterator at{tests.begin(), tests.end(), test};
    EXPECT_NE(at, std::sregex_iterator{}) << code << " has no test";
    for (; at != std::sregex_iterator{}; ++at) EXPECT_TRUE(is_test((*at)[1])) << code << ": " << (*at)[1];
  }
  EXPECT_EQ(rows.size(), codes().size());
}

TEST_F(AbortCodes, ReachTheClientFromEveryHook) {
  Refusing owner;
  for (const std::uint16_t index : {std::uint16_t{0x2018}, std::uint16_t{0x2023}, std::uint16_t{0x201D}}) {
    dictionary.own_read(index, 0, owner);
    dictionary.own_write(index, 0, owner);
  }
  const Bytes eight(8, 0);
  for (const auto& [digits, name] : codes()) {
    SCOPED_TRACE(name);
    owner.code = static_cast<AbortCode>(std::stoul(digits, nullptr, 16));
    const Outcome refused{owner.code};

    EXPECT_EQ(client.upload({0x2018, 0}), refused);  // a number in one frame
    EXPECT_EQ(writes_u32(0x2018, 0, 0), static_cast<std::uint32_t>(owner.code));
    EXPECT_EQ(client.upload({0x201D, 0}), refused);  // one in segments
    EXPECT_EQ(client.download({0x201D, 0}, eight), refused);
    EXPECT_EQ(client.upload({0x2023, 0}), refused);  // a text
    EXPECT_EQ(client.download({0x2023, 0}, eight), refused);
    EXPECT_EQ(client.block_upload({0x2023, 0}), refused);
    EXPECT_EQ(client.block_download({0x2023, 0}, eight), refused);
  }
}

TEST_F(AbortCodes, SayThatATextIsTooLongToBeSent) {
  class Talkative final : public canopen::EntryOwner {
   public:
    canopen::Result<std::span<const std::uint8_t>> read_text(const canopen::Entry&,
                                                             std::span<const std::uint8_t>) override {
      return text;
    }
    Bytes text = Bytes(100'000, 'a');
  } owner;
  dictionary.own_read(0x2023, 0, owner);

  EXPECT_EQ(client.upload({0x2023, 0}), Outcome{AbortCode::OutOfMemory});
  owner.text.resize(25);
  EXPECT_EQ(client.upload({0x2023, 0}), Outcome{owner.text});  // what the owner says counts
}

}  // namespace
