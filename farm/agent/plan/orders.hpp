#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "farm/documents/place.hpp"
#include "farm/naming/unit_name.hpp"

namespace farm::agent {

/// Buckets that an agent watches.
enum class Bucket : std::uint8_t { Units, Places, Buses, Hosts };
inline constexpr std::size_t kBuckets = 4;

/// A place that is to be written if its key has this revision.
struct PlaceWrite {
  UnitName unit;
  Place place;
  std::uint64_t revision = 0;  ///< 0: there is no such key
};

/// A document that is to be put where there is none.
struct DocumentWrite {
  Bucket bucket = Bucket::Units;
  std::string key;
  std::string value;
};

/// A configuration that is to be judged.
struct Check {
  UnitName unit;
  std::string configuration;  ///< JSON, as it is wanted
};

/// A unit that is to be started.
struct UnitStart {
  UnitName unit;
  std::string configuration;  ///< JSON, as it is wanted
  std::uint64_t term = 0;     ///< of its place
  std::string generation;     ///< of the buckets: what was kept in another one is not compared by terms
};

/// A hub that is to be started.
struct HubStart {
  std::string bus;
  std::uint32_t bit_rate = 0;  ///< bit/s; 0: frames take no time
};

/// A line for people.
struct Notice {
  bool is_warning = false;
  std::string text;
};

/// What is to be done, all at once.
struct Orders {
  std::vector<PlaceWrite> places{};
  std::vector<DocumentWrite> documents{};
  std::vector<Check> checks{};
  std::vector<UnitStart> starts{};
  std::vector<UnitName> stops{};
  std::vector<UnitStart> notes{};  ///< units that run already: under which term is to be kept beside their state
  std::vector<HubStart> hub_starts{};
  std::vector<std::string> hub_stops{};
  bool store_again = false;  ///< what units have saved goes to the server once more: it has lost it
  std::vector<Notice> notices{};
};

}  // namespace farm::agent
