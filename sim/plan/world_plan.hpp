#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>
#include <tl/expected.hpp>

#include "libcanopen/base/time.hpp"

namespace sim {

/// A unit of a world with the master that leads it.
struct UnitPlan {
  nlohmann::json configuration = nlohmann::json::object();  ///< as axisd reads it
  bool is_watched = false;         ///< judges see each of its cycles, and it does not rest
  std::uint16_t heartbeat_ms = 0;  ///< 1017h, 0: none
  std::uint16_t inhibit_100us = 0;
  std::uint8_t transmission = 254;
  bool by_rpdo = false;
  bool stores = false;
  bool restarts = false;
  bool is_guarded = false;   ///< by remote frames, every 300 ms
  bool is_intruded = false;  ///< somebody sends nonsense to it
  std::uint64_t seed = 0;    ///< of all that chance decides about it
};

/// Something that goes wrong, of a kind of fault_kinds().
struct FaultPlan {
  std::string kind;
  canopen::Duration at{};       ///< from the beginning
  canopen::Duration lasting{};  ///< until it is mended; 0: it is over at once
  std::size_t unit = 0;         ///< number of the unit, from 0
  std::int64_t number = 0;      ///< what it is to the kind
  std::string words{};          ///< of a fault on the wire, as `axisctl inject add` takes them
};

/// All that decides how a world goes: two runs of one plan are alike, bit for bit.
struct WorldPlan {
  std::uint64_t seed = 0;
  std::uint32_t bit_rate = 500'000;                     ///< bit/s
  canopen::Duration length = std::chrono::seconds{20};  ///< of the whole
  canopen::Duration calm = std::chrono::seconds{12};    ///< all faults are mended then
  canopen::Duration sync{};                             ///< period of SYNC, 0: none
  std::vector<UnitPlan> units{};                        ///< node-ID 1 is the first
  std::vector<FaultPlan> faults{};
};

/// The plan that @p seed stands for: 1 to 20 units of 1 to 8 axes, one fault at least.
WorldPlan draw_plan(std::uint64_t seed);

/// @p plan as read_plan() takes it.
nlohmann::json json_of(const WorldPlan& plan);
/// The plan that @p text says, or why it is none.
tl::expected<WorldPlan, std::string> read_plan(std::string_view text);

/// In one line: "3 units, 7 axes, 500 kbit/s, 20 s, 4 faults".
std::string summary_of(const WorldPlan& plan);

}  // namespace sim
