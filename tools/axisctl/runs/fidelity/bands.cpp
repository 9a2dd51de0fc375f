#include "tools/axisctl/runs/fidelity/bands.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "text/number.hpp"

namespace runs {
namespace {

constexpr std::array kBandRows{
    BandRow{"6044h", {1, 0.02}, "velocity actual value (rpm)"},
    BandRow{"6043h", {1, 0.02}, "velocity demand (rpm)"},
    BandRow{"6063h, 6064h", {1, 0.02}, "position actual value"},
    BandRow{"6062h, 60FCh", {1, 0.02}, "position demand value"},
    BandRow{"6069h, 606Bh, 606Ch", {1, 0.02}, "velocity sensor, demand and actual value"},
    BandRow{"6074h, 6077h", {20, 0.1}, "torque demand and actual value (0.1 %)"},
    BandRow{"6078h", {20, 0.1}, "current actual value (0.1 %)"},
    BandRow{"6079h", {0, 0.05}, "DC link voltage (mV)"},
    BandRow{"60F4h", {1, 0.2}, "following error"},
    BandRow{"2015h, 203Fh", {1, 0.02}, "r0021, r0063: speed (rpm)"},
    BandRow{"2019h, 201Ah, 2046h, 2048h", {1, 0.05}, "r0025, r0026, r0070, r0072: voltages (V)"},
    BandRow{"201Bh, 2044h, 2045h, 204Ch-204Eh", {0.1, 0.1}, "r0027, r0068, r0069, r0076 to r0078: currents (A)"},
    BandRow{"201Eh-2020h, 204Fh-2052h", {0.1, 0.1}, "r0030 to r0032, r0079 to r0082: torque, power"},
    BandRow{"2023h, 2025h", {3, 0}, "r0035, r0037: temperatures (°C)"},
};

std::uint32_t key_of(const canopen::sdo::Address& object) noexcept {
  return std::uint32_t{object.index} << 8U | object.sub_index;
}

}  // namespace

std::span<const BandRow> band_rows() noexcept {
  return kBandRows;
}

Bands::Bands() {
  for (const BandRow& row : kBandRows)
    rows_.push_back(
        {conformance::parse_objects(row.objects).value_or(std::vector<conformance::ObjectRange>{}), row.band});
}

bool Bands::add(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return false;
  auto objects = conformance::parse_objects(text.substr(0, equals));
  std::string_view number = text.substr(equals + 1);
  const bool is_share = number.ends_with('%');
  if (is_share) number.remove_suffix(1);
  const auto value = text::real(number);
  if (!objects || !value || !(*value >= 0)) return false;
  constexpr double kPercent = 100;
  rows_.insert(rows_.begin(),
               Row{*std::move(objects), is_share ? Band{.share = *value / kPercent} : Band{.absolute = *value}});
  return true;
}

std::optional<Band> Bands::of(const canopen::sdo::Address& object) const {
  const conformance::Subject subject{object.index, object.sub_index};
  for (const Row& row : rows_)
    if (std::ranges::any_of(row.objects, [&](const auto& range) { return range.contains(subject); }))
      return row.band;
  return std::nullopt;
}

void Extents::note(const canopen::sdo::Address& object, double value) {
  double& largest = largest_[key_of(object)];
  if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
}

double Extents::tolerance(const canopen::sdo::Address& object, const Band& band) const {
  const auto known = largest_.find(key_of(object));
  return band.absolute + band.share * (known == largest_.end() ? 0.0 : known->second);
}

}  // namespace runs
