#include "farm/naming/subjects.hpp"

#include <gtest/gtest.h>

namespace farm {
namespace {

const UnitName kUnit{"line1", "5"};

TEST(Subjects, AreThoseOfTheProtocol) {
  EXPECT_EQ(rpc_subject("lab", kUnit), "axisd.lab.line1.5.rpc");
  EXPECT_EQ(event_subject("lab", kUnit), "axisd.lab.line1.5.event");
  EXPECT_EQ(status_subject("lab", kUnit), "axisd.lab.line1.5.status");
  EXPECT_EQ(all_events_subject("lab"), "axisd.lab.*.*.event");
  EXPECT_EQ(all_statuses_subject("lab"), "axisd.lab.*.*.status");
  EXPECT_EQ(door_subject("lab", "a"), "axisd_host.lab.a.door");
  EXPECT_EQ(agent_subject("lab", "a"), "axisd_host.lab.a.agent");
  EXPECT_EQ(all_doors_subject("lab"), "axisd_host.lab.*.door");
  EXPECT_EQ(all_agents_subject("lab"), "axisd_host.lab.*.agent");
  EXPECT_EQ(who_subject("lab"), "axisd_host.lab.who");
}

TEST(Buckets, AreThoseOfTheProtocol) {
  EXPECT_EQ(units_bucket("lab"), "axisd_lab_units");
  EXPECT_EQ(places_bucket("lab"), "axisd_lab_places");
  EXPECT_EQ(buses_bucket("lab"), "axisd_lab_buses");
  EXPECT_EQ(hosts_bucket("lab"), "axisd_lab_hosts");
  EXPECT_EQ(state_bucket("lab"), "axisd_lab_state");
  EXPECT_EQ(state_object(kUnit, "parameters.bin"), "line1.5/parameters.bin");
}

TEST(Subject, NamesItsUnit) {
  EXPECT_EQ(unit_of_subject("lab", "axisd.lab.line1.5.event"), kUnit);
  EXPECT_EQ(unit_of_subject("lab", "axisd.other.line1.5.event"), std::nullopt);
  EXPECT_EQ(unit_of_subject("lab", "axisd.lab.line1"), std::nullopt);
  EXPECT_EQ(unit_of_subject("lab", "axisd.lab"), std::nullopt);
}

}  // namespace
}  // namespace farm
