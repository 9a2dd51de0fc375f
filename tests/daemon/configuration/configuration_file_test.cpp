#include "daemon/program/configuration_file.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/daemon/configuration/bad_file.hpp"
#include "tests/fakes/temporary_directory.hpp"

namespace axisd {
namespace {

TEST(DeepFiles, AreRefusedWithThePlaceWhereTheyAreTooDeep) {
  const std::string opened = R"({"axes":)" + std::string(100'000, '[');

  EXPECT_EQ(message_of([&] { parse_configuration(opened, "node.json"); }),
            "node.json: line 1, column 40: expected at most 32 levels of objects and arrays");
  EXPECT_EQ(message_of([&] { parse_configuration(opened + std::string(100'000, ']') + '}', "node.json"); }),
            "node.json: line 1, column 40: expected at most 32 levels of objects and arrays");
}

TEST(DeepFiles, AreNotMadeByBracketsInText) {
  const std::string text = R"({"axes": [{"name": ")" + std::string(100, '[') + R"(\"{"}]})";

  EXPECT_EQ(message_of([&] { parse_configuration(text, "node.json"); }), "accepted");
}

TEST(SpecialFiles, AreRefusedWithoutWaitingForThem) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("node.json");
  ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);

  EXPECT_EQ(read_text_file(path).error(), path + ": cannot be read: Not a regular file");
  EXPECT_EQ(read_text_file("/dev/zero").error(), "/dev/zero: cannot be read: Not a regular file");
}

TEST(LongFiles, AreRefused) {
  const fakes::TemporaryDirectory folder;
  const std::string path = folder.path("node.json");
  std::ofstream{path} << "{}";
  std::filesystem::resize_file(path, 17U << 20);

  EXPECT_EQ(read_text_file(path).error(), path + ": cannot be read: File too large");
}

}  // namespace
}  // namespace axisd
