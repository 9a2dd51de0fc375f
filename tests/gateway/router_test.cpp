#include "gateway/routes/router.hpp"

#include <gtest/gtest.h>

namespace gateway {
namespace {

std::string found(std::string_view verb, std::string_view path) {
  const auto match = find_route(verb, path);
  return match ? std::string{match->route->method} : match.error().code;
}

TEST(Router, FindsTheRowOfAPath) {
  EXPECT_EQ(found("GET", "/api/v1/units"), "units");
  EXPECT_EQ(found("GET", "/api/v1/units/vcan0/5"), "status");
  EXPECT_EQ(found("PUT", "/api/v1/units/vcan0/5/parameters/p1120"), "parameter.write");
  EXPECT_EQ(found("HEAD", "/api/v1/units/vcan0/5/explain"), "explain");
}

TEST(Router, WordsStandBeforePlaceholders) {
  EXPECT_EQ(found("GET", "/api/v1/units/vcan0/5/parameters/diff"), "parameter.diff");
  EXPECT_EQ(found("GET", "/api/v1/units/vcan0/5/parameters/p1120"), "parameter.read");
  EXPECT_EQ(found("PUT", "/api/v1/units/vcan0/5/parameters/diff"), "method-not-allowed");
}

TEST(Router, GivesThePartsOfThePath) {
  const auto match = find_route("PUT", "/api/v1/units/unix-can-bus-1a2b3c4d/5/parameters/2%2Fp1070%5B1%5D");
  ASSERT_TRUE(match);
  EXPECT_EQ(unit_of(*match), "unix-can-bus-1a2b3c4d/5");
  EXPECT_EQ(match->value("parameter"), "2/p1070[1]");
  EXPECT_EQ(match->value("axis"), "");
}

TEST(Router, WhatIsNotThereIsNotFound) {
  for (const std::string_view path :
       {"", "*", "/api", "/api/v1/units/", "/api/v1/units/vcan0", "/api/v1/units/vcan0/", "/api/v1/units//5",
        "/api/v1/units/vcan0/5/", "/API/v1/units", "/api/v1/units%00", "/api/v1/../v1/units", "//api/v1/units"})
    EXPECT_EQ(found("GET", path), "no-such-path") << path;
}

TEST(Router, NamesTheVerbsThatThereAre) {
  const auto match = find_route("DELETE", "/api/v1/units/vcan0/5/supply");
  ASSERT_FALSE(match);
  EXPECT_EQ(match.error().allow, "GET, HEAD, PUT, OPTIONS");
  EXPECT_EQ(match.error().status, Status::MethodNotAllowed);
  EXPECT_EQ(verbs_of("/api/v1/units/vcan0/5/power/on"), "POST, OPTIONS");
  EXPECT_EQ(verbs_of("/nothing"), "");
}

}  // namespace
}  // namespace gateway
