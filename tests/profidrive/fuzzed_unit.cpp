#include "tests/profidrive/fuzzed_unit.hpp"

#include <algorithm>
#include <array>
#include <chrono>

#include "profidrive/record/record.hpp"
#include "tests/profidrive/well_formed.hpp"

namespace profidrive {
namespace {

using Bytes = std::span<const std::uint8_t>;

unit::Configuration servo_and_vector() {
  return {.drive = {.axes = {{}, {.kind = drive::ObjectKind::Vector}}, .node_id = 5}};
}

/// The first @p count bytes of @p rest, which loses them; fewer where it ends.
Bytes take(Bytes& rest, std::size_t count) {
  const Bytes taken = rest.first(std::min(count, rest.size()));
  rest = rest.subspan(taken.size());
  return taken;
}

}  // namespace

FuzzedUnit::FuzzedUnit() : runner_{servo_and_vector(), *this} {
  runner_.start(unit::TimePoint{std::chrono::hours{1}});
}

unit::Keeping FuzzedUnit::on_store(std::span<const std::byte>) noexcept {
  return unit::Keeping::Kept;
}

std::string FuzzedUnit::play(Bytes input) {
  channel_ = ParameterChannel{2};
  runner_.unit().restore_parameters();
  while (input.size() > 1) {
    const Bytes head = take(input, 2);
    const Bytes request = take(input, head[1]);
    const std::string broken = head[0] % 2 != 0 ? exchange(request) : record(request);
    if (!broken.empty()) return broken;
    runner_.follow_up();
  }
  return {};
}

std::string FuzzedUnit::record(Bytes request) {
  std::array<std::uint8_t, record::kMostBytes> response{};
  const std::size_t size = record::answer(request, response, runner_.parameter_access());
  if (size > response.size()) return "more than 240 bytes";
  return broken_rule(request, Bytes{response}.first(size));
}

std::string FuzzedUnit::exchange(Bytes request) {
  ParameterChannel::Words words{};
  for (std::size_t i = 0; i < request.size() && i < 2 * words.size(); ++i)
    words[i / 2] = static_cast<std::uint16_t>(words[i / 2] | request[i] << (i % 2 == 0 ? 8 : 0));
  return broken_rule(words, channel_.exchange(words, runner_.parameter_access()));
}

}  // namespace profidrive
