#include "tools/axisctl/fleet/store.hpp"

#include <gtest/gtest.h>

#include "tests/fakes/fake_key_value.hpp"

namespace fleet {
namespace {

using nlohmann::json;

/// A server that keeps nothing but what is put there; objects are not used.
struct FleetStore : testing::Test {
  class NoObjects final : public farm::ObjectStore {
   public:
    tl::expected<void, std::string> put(const std::string&, const std::string&, std::string_view) override {
      return tl::unexpected{std::string{"none"}};
    }
    tl::expected<std::optional<std::string>, std::string> get(const std::string&, const std::string&) override {
      return tl::unexpected{std::string{"none"}};
    }
    tl::expected<void, std::string> remove(const std::string&, const std::string&) override {
      return tl::unexpected{std::string{"none"}};
    }
  };
  /// What became of what @p text asks for.
  std::string apply_text(const std::string& text) {
    WantedFleet wanted;
    EXPECT_TRUE(read_fleet_file(json::parse(text), "f", wanted));
    const auto applied = apply(storage, "lab", wanted);
    if (!applied) return applied.error();
    std::string told;
    for (const auto& [name, effect] : applied->buses) told += name + ' ' + std::string{text_of(effect)} + ' ';
    for (const auto& [name, effect] : applied->units) told += name + ' ' + std::string{text_of(effect)} + ' ';
    return told;
  }

  fakes::FakeKeyValue keys;
  NoObjects objects;
  farm::Storage storage{keys, objects};
};

TEST_F(FleetStore, SaysWhatBecameOfWhatWasAskedFor) {
  EXPECT_EQ(
      apply_text(R"({"units": [{"bus": "a", "node_id": 1}, {"bus": "a", "node_id": 2}], "buses": {"a": {}}})"),
      "a created a/1 created a/2 created ");
  EXPECT_EQ(keys.buckets["axisd_lab_units"]["a.1"].value, R"({"configuration":{}})");
  const unsigned before = keys.writes;

  EXPECT_EQ(
      apply_text(R"({"units": [{"bus": "a", "node_id": 1}, {"bus": "a", "node_id": 2, "sdo_block": true}]})"),
      "a/1 unchanged a/2 changed ");

  EXPECT_EQ(keys.writes, before + 1);
  EXPECT_TRUE(keys.buckets["axisd_lab_buses"].contains("a")) << "what is not named stays";
}

TEST_F(FleetStore, ReadsWhatIsWantedAndWhereItIs) {
  apply_text(R"({"units": [{"bus": "a", "node_id": 1}, {"bus": "a", "node_id": 2}]})");
  static_cast<void>(keys.put("axisd_lab_units", "a.3", "hello"));
  static_cast<void>(keys.put("axisd_lab_units", "generation", "77"));
  static_cast<void>(
      keys.put("axisd_lab_places", "a.1", R"({"host": "h", "instance": 1, "term": 1, "problem": "no"})"));
  static_cast<void>(keys.put("axisd_lab_places", "b.9", R"({"term": 3})"));
  static_cast<void>(keys.put("axisd_lab_places", "c.9", R"({"host": "h", "instance": 1, "term": 3})"));

  const auto units = read(storage, "lab");

  ASSERT_TRUE(units);
  ASSERT_EQ(units->size(), 4U);
  EXPECT_EQ(units->at({"a", "1"}).place.problem, "no");
  EXPECT_EQ(units->at({"a", "2"}).place.host, "");
  EXPECT_NE(units->at({"a", "3"}).wrong, "");
  EXPECT_FALSE(units->at({"c", "9"}).wanted);
}

TEST_F(FleetStore, RemovesUnitsAndAllOfABus) {
  apply_text(
      R"({"units": [{"bus": "a", "node_id": {"from": 1, "to": 3}}, {"bus": "b", "node_id": {"from": 1, "to": 2}}]})");

  EXPECT_EQ(remove(storage, "lab", {{"a", "2"}, {"a", "9"}}, {"b"}).value(),
            (std::vector<std::string>{"a/2", "b/1", "b/2"}));

  EXPECT_EQ(read(storage, "lab")->size(), 2U);
}

TEST_F(FleetStore, MovesAUnitThatIsWanted) {
  apply_text(R"({"units": [{"bus": "a", "node_id": 1, "sdo_block": true}]})");

  EXPECT_TRUE(move(storage, "lab", {"a", "1"}, "h").value());
  EXPECT_FALSE(move(storage, "lab", {"a", "2"}, "h").value());

  EXPECT_EQ(keys.buckets["axisd_lab_units"]["a.1"].value, R"({"configuration":{"sdo_block":true},"host":"h"})");
}

TEST_F(FleetStore, DrainsAHost) {
  EXPECT_TRUE(drain(storage, "lab", "h", true));
  EXPECT_EQ(keys.buckets["axisd_lab_hosts"]["h"].value, R"({"drain":true})");
  EXPECT_TRUE(drain(storage, "lab", "h", false));
  EXPECT_TRUE(keys.buckets["axisd_lab_hosts"].empty());
}

TEST_F(FleetStore, HandsOnWhatTheServerSays) {
  keys.error = "no connection";
  EXPECT_EQ(apply_text(R"({"units": []})"), "no connection");
  EXPECT_EQ(read(storage, "lab").error(), "no connection");
  EXPECT_EQ(move(storage, "lab", {"a", "1"}, "h").error(), "no connection");
  EXPECT_EQ(remove(storage, "lab", {}, {"a"}).error(), "no connection");
  EXPECT_EQ(drain(storage, "lab", "h", true).error(), "no connection");
}

}  // namespace
}  // namespace fleet
