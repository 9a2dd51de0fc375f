// Objects over the control socket: what a client of the default SDO server reads, and its refusals.
#include <set>

#include <gtest/gtest.h>

#include "control/protocol.hpp"
#include "tests/daemon/control/controlled_unit.hpp"

namespace axisd {
namespace {

using control::ErrorCode;
using nlohmann::json;

struct ObjectMethods : ControlledUnit {
  json read(const json& index, const json& sub_index = nullptr) {
    return result_of("object.read", {{"index", index}, {"sub_index", sub_index}});
  }
  json write(const json& index, const json& value) {
    return result_of("object.write", {{"index", index}, {"value", value}});
  }
  control::Error refusal(const json& index, const json& value) {
    return error_of("object.write", {{"index", index}, {"value", value}});
  }
};

TEST_F(ObjectMethods, ReadNumbersAndTextsWithWhatTheyAre) {
  const json type = read("1000");
  EXPECT_EQ(type.at("object"), "1000h:00");
  EXPECT_EQ(type.at("value"), 0xFFFF0192);
  EXPECT_EQ(type.at("type"), "UNSIGNED32");
  EXPECT_EQ(type.at("access"), "ro");
  EXPECT_EQ(type.at("name"), "Device Type");
  EXPECT_TRUE(read("1008h").at("value").is_string());
}

TEST_F(ObjectMethods, TakeAnAddressInTheWaysPeopleWriteIt) {
  for (const json& index : {json("1018:04"), json("1018h:4"), json("0x1018:0x04")})
    EXPECT_EQ(read(index).at("object"), "1018h:04") << index;
  EXPECT_EQ(read(0x1018, 4).at("object"), "1018h:04");
  EXPECT_EQ(read("1018", "04h").at("object"), "1018h:04");
  for (const json& index : {json("xyz"), json(""), json(65536), json(-1), json(1.5), json::array(),
                            json("1018:400"), json("1018:04:1"), json()})
    EXPECT_EQ(error_of("object.read", {{"index", index}}).code, ErrorCode::BadParameter) << index;
  EXPECT_EQ(error_of("object.read", {{"index", 0x1018}, {"sub_index", 256}}).message,
            "sub_index: expected 0 to 255, or hexadecimal as 0x1F, got 256");
}

TEST_F(ObjectMethods, RefuseWithTheAbortCodeOfAServer) {
  const control::Error missing = error_of("object.read", {{"index", "1FFF"}});
  EXPECT_EQ(missing.code, ErrorCode::NotFound);
  EXPECT_EQ(missing.message, "1FFFh:00: no such object (06020000h)");
  EXPECT_EQ(missing.details.at("abort_code"), 0x06020000);
  EXPECT_EQ(missing.details.at("abort_text"), "no such object");
  EXPECT_EQ(error_of("object.read", {{"index", "1018:05"}}).details.at("abort_code"), 0x06090011);
  EXPECT_EQ(refusal("1000", 1).code, ErrorCode::ReadOnly);
  EXPECT_EQ(refusal("1000", 1).details.at("abort_code"), 0x06010002);
  EXPECT_EQ(refusal("1003", 1).details.at("abort_code"), 0x06090030);
}

TEST_F(ObjectMethods, WriteWhatAMasterReads) {
  EXPECT_EQ(write("60FF", -1000).at("value"), -1000);
  EXPECT_EQ(answer("605#40FF600000000000"), Lines{"585#43FF600018FCFFFF"});
  EXPECT_EQ(write("6040", "0x06").at("value"), 6);
  EXPECT_EQ(write("6040", "0Fh").at("value"), 15);
}

TEST_F(ObjectMethods, WriteAHeartbeatThatBeginsNow) {
  run(std::chrono::seconds{5});
  sent();

  write("1017", 100);
  run(std::chrono::milliseconds{350});

  EXPECT_EQ(sent(), Lines(4, "705#7F")) << "at once and every 100 ms, nothing made up for";
}

TEST_F(ObjectMethods, RefuseWhatATypeCannotHold) {
  const control::Error error = refusal("6040", 65536);
  EXPECT_EQ(error.code, ErrorCode::OutOfRange);
  EXPECT_EQ(error.message, "value: expected 0 to 65535, got 65536");
  EXPECT_EQ(error.details.at("limits"), (json{{"minimum", 0}, {"maximum", 65535}}));
  EXPECT_EQ(refusal("60FF", "-2147483649").code, ErrorCode::OutOfRange);
  EXPECT_EQ(refusal("60FF", 18446744073709551615U).code, ErrorCode::OutOfRange);
  for (const json& none : {json(1.5), json("one"), json(""), json::array(), json("--1")})
    EXPECT_EQ(refusal("6040", none).code, ErrorCode::BadParameter) << none;
}

TEST_F(ObjectMethods, ReachTheParametersOfTheWindow) {
  EXPECT_EQ(write("41B6:00", 2).at("parameter"), "p8630[0]");

  EXPECT_EQ(write("2460", 2.5).at("value"), 2.5);
  const json ramp = read("2460");
  EXPECT_EQ(ramp.at("parameter"), "p1120");
  EXPECT_EQ(ramp.at("axis"), 1);
  EXPECT_EQ(ramp.at("type"), "REAL32");
  EXPECT_EQ(refusal("2460", -1).code, ErrorCode::OutOfRange);
  EXPECT_EQ(refusal("203F", 1).details.at("abort_code"), 0x06010002) << "r0063";
  EXPECT_EQ(error_of("object.read", {{"index", "2FFF"}}).details.at("abort_code"), 0x06020000);
}

TEST_F(ObjectMethods, KeepTheRulesOfPdos) {
  const control::Error error = refusal("1600:01", 0x99990010);

  EXPECT_EQ(error.code, ErrorCode::Refused);
  EXPECT_TRUE(error.details.contains("abort_code"));
}

TEST_F(ObjectMethods, ListTheWholeDictionaryInPages) {
  switch_on(unit_of(8));
  std::set<std::string> objects;
  json params = json::object();
  for (bool more = true; more;) {
    const json page = result_of("object.list", params);
    EXPECT_LE(control::result_line(1, page).size(), control::kMaximumLine);
    for (const json& object : page.at("objects")) objects.insert(object.at("object").get<std::string>());
    more = page.contains("next");
    if (more) params["from"] = page.at("next");
  }

  EXPECT_EQ(objects.size(), unit().device().dictionary().entries().size());
  EXPECT_EQ(result_of("object.list", {{"text", "Device type"}}).at("objects").at(0).at("object"), "1000h:00");
  const json found = result_of("object.list", {{"text", "60f"}});
  for (const json& object : found.at("objects"))
    EXPECT_TRUE(object.at("object").get<std::string>().starts_with("60F")) << object;
}

}  // namespace
}  // namespace axisd
