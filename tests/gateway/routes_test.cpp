#include "gateway/routes/routes.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "gateway/base/percent.hpp"

namespace gateway {
namespace {

/// The rows that reach @p method; one that shows a part of its result is another matter.
std::vector<const Route*> rows_of(std::string_view method) {
  std::vector<const Route*> rows;
  for (const Route& route : routes())
    if ((route.method == method || route.ends_with == method) && route.kind != Kind::Axis) rows.push_back(&route);
  return rows;
}

TEST(Routes, ReachEveryMethodOfTheControlSocketOnce) {
  for (const control::Method& method : control::kMethods) {
    const auto rows = rows_of(method.name);
    // The list of units is put together of its pages.
    const auto is_whole = [](const Route* route) { return route->without.empty() || route->kind == Kind::Units; };
    EXPECT_EQ(std::ranges::count_if(rows, is_whole), 1) << method.name;
    EXPECT_LE(rows.size(), 2U) << method.name;
  }
}

TEST(Routes, OfAMethodWithTwoOneOnlyLooks) {
  for (const Route& route : routes()) {
    if (route.without.empty()) continue;
    EXPECT_FALSE(route.is_write()) << route.path;
    EXPECT_NE(control::parameter_of(route.method, route.without).key, "") << route.path;
    for (const Route* const other : rows_of(route.method))
      EXPECT_TRUE(other == &route || other->is_write()) << route.path;
  }
}

TEST(Routes, TakeEveryPartOfTheirPaths) {
  for (const Route& route : routes()) {
    if (route.kind == Kind::Axis || route.method.empty()) continue;
    for (const std::string_view part : segments_of(route.path)) {
      if (!part.starts_with('{') || part == "{bus}" || part == "{node}") continue;
      const std::string_view name = part.substr(1, part.size() - 2);
      const std::string_view key = name == route.alias_of ? route.alias : name;
      EXPECT_EQ(control::parameter_of(route.method, key).key, key) << route.path;
      EXPECT_EQ(source_of(route, key), ArgumentSource::Path) << route.path;
    }
  }
}

TEST(Routes, StandOnce) {
  std::set<std::string> seen;
  for (const Route& route : routes())
    EXPECT_TRUE(seen.insert(std::string{route.verb} + ' ' + std::string{route.path}).second) << route.path;
}

TEST(Routes, WhatReadsIsNoMethodThatSets) {
  for (const Route& route : routes())
    for (const std::string_view word :
         {".set", ".write", ".start", ".stop", ".on", ".off", "quit", "store", ".ack", ".clear", ".inject",
          ".fail", "restore", ".restart", ".analog", ".record"})
      EXPECT_FALSE(route.verb == "GET" && route.method.ends_with(word)) << route.path;
}

}  // namespace
}  // namespace gateway
