#include "farm/naming/farm_url.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

TEST(FarmUrl, HasTheUsualPortUnlessAnotherIsGiven) {
  const auto usual = parse_farm_url("nats://example/plant");
  const auto other = parse_farm_url("tls://[::1]:5222/plant-2");

  ASSERT_TRUE(usual && other);
  EXPECT_EQ(usual->server.url, "nats://example:4222");
  EXPECT_EQ(usual->host, "example");
  EXPECT_EQ(usual->name, "plant");
  EXPECT_EQ(other->server.url, "tls://[::1]:5222");
  EXPECT_EQ(other->host, "::1");
  EXPECT_EQ(other->name, "plant-2");
}

TEST(FarmUrl, WithoutAFarmIsNone) {
  for (const char* const text :
       {"nats://example", "nats://example/", "nats://example/a.b", "http://example/a", ""})
    EXPECT_FALSE(parse_farm_url(text)) << text;
}

}  // namespace
}  // namespace farm
