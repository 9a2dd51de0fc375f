#include "farm/agent/host/state_transfer.hpp"

#include <span>

#include <fmt/format.h>

#include "checksum/crc32.hpp"
#include "farm/documents/place.hpp"
#include "farm/naming/subjects.hpp"

namespace farm::agent {
namespace {

constexpr std::string_view kParameters = "parameters.bin";

std::uint32_t checksum_of(std::string_view content) noexcept {
  return checksum::crc32(std::as_bytes(std::span{content}));
}

}  // namespace

tl::expected<std::optional<std::uint32_t>, std::string> StateTransfer::fetch(Storage& storage,
                                                                             const UnitName& unit) const {
  const auto content = storage.objects.get(state_bucket(farm_), state_object(unit, kParameters));
  if (!content) return tl::unexpected{content.error()};
  if (!*content) return std::nullopt;
  if (auto written = replace_file(folders_.parameters(unit), **content, Write::ToDisk); !written)
    return tl::unexpected{std::move(written.error())};
  return checksum_of(**content);
}

tl::expected<StateTransfer::Upload, std::string> StateTransfer::upload(Storage& storage, const UnitName& unit,
                                                                       std::uint64_t term) const {
  const auto content = read_parameters(folders_, unit);
  if (!content) return tl::unexpected{content.error()};
  if (!*content) return Upload{};
  const auto entry = storage.keys.get(places_bucket(farm_), unit.key());
  if (!entry) return tl::unexpected{entry.error()};
  const std::string text = *entry ? (*entry)->value : "";
  const auto place = parse_place(unit.key(), text);
  if (!place) return tl::unexpected{fmt::format("place of {} is not known", unit.text())};
  if (place->term > term) return Upload{.is_others = true, .checksum = std::nullopt};
  if (auto put = storage.objects.put(state_bucket(farm_), state_object(unit, kParameters), **content); !put)
    return tl::unexpected{std::move(put.error())};
  return Upload{.is_others = false, .checksum = checksum_of(**content)};
}

}  // namespace farm::agent
