#include <cstdlib>
#include <iostream>

#include <gtest/gtest.h>

#include "tests/farm/agent/plan/told_farm.hpp"

namespace farm::agent {
namespace {

using namespace std::chrono_literals;
using told::Host;

constexpr int kUnits = 24;
constexpr int kSteps = 250;

std::uint32_t seed_of_test() {
  const char* const given = std::getenv("AXISD_TEST_SEED");
  return given != nullptr ? static_cast<std::uint32_t>(std::strtoul(given, nullptr, 10)) : std::random_device{}();
}

/// A farm of four hosts to which all sorts of things happen.
class Walk {
 public:
  explicit Walk(std::uint32_t seed) : farm{seed} {
    for (const char* const name : {"a", "b", "c", "d"}) farm.add(name, 10);
    for (int i = 0; i < kUnits; ++i) want(i);
  }

  /// Something happens, and some time passes.
  void step(bool may_lose_server) {
    Host& host = *std::next(farm.hosts.begin(), farm.below(4));
    const int i = farm.below(kUnits);
    const auto happens = [&](int what) {
      if (what == 0) want(i);
      if (what == 1) farm.remove(Bucket::Units, unit(i).key());
      if (what == 2) host.cut();
      if (what == 3 || what == 4) heal_all();
      if (what == 5) host.kill_agent();
      if (what == 6 || what == 7) start_all();
      if (what == 8) host.kill();
      if (what == 9) host.kill_unit(unit(i));
      if (what == 10) host.save(unit(i));
      if (what == 11) farm.put(Bucket::Hosts, host.name, R"({"drain":true})");
      if (what == 12) farm.remove(Bucket::Hosts, host.name);
      if (what == 13) farm.lose_server();
    };
    happens(farm.below(may_lose_server ? 14 : 13));
    farm.pass(farm.between(10ms, farm.below(3) == 0 ? 4s : 300ms));
  }
  /// Nothing happens any more, and all hosts are well.
  void end() {
    heal_all();
    start_all();
    farm.pass(3s);  // what the server has lost is back
    for (Host& host : farm.hosts) farm.remove(Bucket::Hosts, host.name);
    farm.pass(80s);
  }
  /// What is not as it is wanted, a line for each unit.
  std::vector<std::string> wrong() const {
    std::vector<std::string> lines;
    for (int i = 0; i < kUnits; ++i)
      if (const std::string line = wrong(unit(i)); !line.empty()) lines.push_back(unit(i).text() + ": " + line);
    return lines;
  }

  told::Farm farm;

 private:
  static UnitName unit(int i) { return {"line" + std::to_string(1 + i % 3), std::to_string(1 + i)}; }

  void heal_all() {
    for (Host& host : farm.hosts) host.heal();
  }
  void start_all() {
    for (Host& host : farm.hosts)
      if (host.plan == nullptr) host.boot();
  }
  void want(int i) {
    static const std::vector<std::string> kDocuments{
        R"({"configuration":{}})",
        R"({"configuration":{"axes":[{},{}]}})",
        R"({"configuration":{"bad":1}})",
        "nonsense",
        R"({"configuration":{},"host":"a"})",
        R"({"configuration":{},"host":["b","c"]})",
    };
    farm.want(unit(i), kDocuments.at(static_cast<std::size_t>(farm.below(static_cast<int>(kDocuments.size())))));
  }
  std::string wrong(const UnitName& unit) const {
    const auto hosts = farm.hosts_of(unit);
    const auto& wished = farm.server.keys(Bucket::Units);
    const auto entry = wished.find(unit.key());
    if (entry == wished.end() || entry->second.is_deleted)
      return hosts.empty() ? "" : "runs though nobody wants it";
    const auto wish = parse_wanted_unit(unit.key(), entry->second.value);
    if (!wish || wish->configuration.contains("bad"))
      return farm.place(unit).problem.empty() ? "has no problem" : "";
    if (hosts.size() != 1) return "runs on " + std::to_string(hosts.size()) + " hosts";
    if (farm.place(unit).host != hosts.front()) return "runs where it is not placed";
    return wish->allows(hosts.front()) ? "" : "runs where it may not be";
  }
};

void walk(bool may_lose_server) {
  const std::uint32_t seed = seed_of_test();
  std::cout << "AXISD_TEST_SEED=" << seed << '\n';
  SCOPED_TRACE("AXISD_TEST_SEED=" + std::to_string(seed));
  Walk walk{seed};
  for (int i = 0; i < kSteps && walk.farm.faults.empty(); ++i) walk.step(may_lose_server);
  walk.end();

  EXPECT_EQ(walk.farm.faults, std::vector<std::string>{});
  EXPECT_EQ(walk.wrong(), std::vector<std::string>{});
}

TEST(FarmWalk, NeverHasAUnitTwiceAndRunsAllThatAreWantedAtLast) {
  walk(false);
}

TEST(FarmWalk, DoesSoThoughTheServerLosesEverything) {
  walk(true);
}

}  // namespace
}  // namespace farm::agent
