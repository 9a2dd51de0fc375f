#include "drive/images/retained_image.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace drive::retained_image {
namespace {

using image_format::Reader;
using image_format::Writer;

constexpr image_format::Kind kKind{{'a', 'x', 'i', 's', 'd', 'r', 'e', 't'}, kFormatVersion};

enum class Section : std::uint16_t { Faults = 1, Energy = 2, UtcTimes = 3 };

constexpr std::size_t kFixedSize = image_format::kHeadSize + 8 + 2 + image_format::kChecksumSize;
constexpr std::size_t kSectionHeadSize = 2 + 2;
constexpr std::size_t kFaultsSize = 2 + 2 + FaultMemory::Kept::kFaults * (2 + 4 + 8 + 8);
constexpr std::size_t kEnergySize = 8 + 8;
constexpr std::size_t kUtcTimesSize = 8 + FaultMemory::Kept::kFaults * (8 + 8);
constexpr UtcTime kNoUtc = std::numeric_limits<UtcTime>::max();

void put_section(Writer& writer, Section section, std::size_t length) noexcept {
  writer.put(section);
  writer.put(static_cast<std::uint16_t>(length));
}

void put_faults(Writer& writer, const FaultMemory::Kept& kept) noexcept {
  put_section(writer, Section::Faults, kFaultsSize);
  writer.put(kept.fault_changes);
  writer.put(kept.fault_cases);
  for (const BufferEntry& entry : kept.faults) {
    writer.put(entry.number);
    writer.put(entry.value);
    writer.put(entry.received.uptime);
    writer.put(entry.removed.uptime);
  }
}

void put_energy(Writer& writer, const PowerUnit& power_unit) noexcept {
  put_section(writer, Section::Energy, kEnergySize);
  writer.put(power_unit.energy_drawn());
  writer.put(power_unit.energy_fed_back());
}

void put_utc_times(Writer& writer, const FaultMemory::Kept& kept, std::optional<UtcTime> now) noexcept {
  put_section(writer, Section::UtcTimes, kUtcTimesSize);
  writer.put(now.value_or(kNoUtc));
  for (const BufferEntry& entry : kept.faults) {
    writer.put(entry.received.utc.value_or(kNoUtc));
    writer.put(entry.removed.utc.value_or(kNoUtc));
  }
}

FaultMemory::Kept take_faults(Reader& reader) noexcept {
  FaultMemory::Kept kept;
  kept.fault_changes = reader.take<std::uint16_t>();
  kept.fault_cases = reader.take<std::uint16_t>();
  for (BufferEntry& entry : kept.faults) {
    entry.number = reader.take<std::uint16_t>();
    entry.value = reader.take<std::uint32_t>();
    entry.received.uptime = reader.take<Uptime>();
    entry.removed.uptime = reader.take<Uptime>();
  }
  return kept;
}

/// The times of faults in UTC, as far as they have one, and that of the image.
struct UtcTimes {
  struct Of {
    std::optional<UtcTime> received{};
    std::optional<UtcTime> removed{};
  };
  std::optional<UtcTime> now{};
  std::array<Of, FaultMemory::Kept::kFaults> faults{};
};

std::optional<UtcTime> take_utc(Reader& reader) noexcept {
  const auto utc = reader.take<UtcTime>();
  return utc != kNoUtc ? std::optional{utc} : std::nullopt;
}

UtcTimes take_utc_times(Reader& reader) noexcept {
  UtcTimes times{.now = take_utc(reader)};
  for (UtcTimes::Of& fault : times.faults) {
    fault.received = take_utc(reader);
    fault.removed = take_utc(reader);
  }
  return times;
}

FaultMemory::Kept with_utc(FaultMemory::Kept kept, const UtcTimes& times) noexcept {
  for (std::size_t i = 0; i < kept.faults.size(); ++i) {
    kept.faults[i].received.utc = times.faults[i].received;
    kept.faults[i].removed.utc = times.faults[i].removed;
  }
  return kept;
}

struct Energy {
  double drawn;
  double fed_back;
};

Energy take_energy(Reader& reader) noexcept {
  const auto drawn = reader.take<double>();
  return {drawn, reader.take<double>()};
}

bool is_amount(double energy) noexcept {
  return std::isfinite(energy) && energy >= 0.0;
}

/// Where a section belongs and what it holds.
struct Place {
  std::uint8_t object;
  Section section;
  Reader content;
};

std::optional<Error> section_error(const DriveUnit& unit, Place place) noexcept {
  if (place.section == Section::Faults) {
    static_cast<void>(take_faults(place.content));
  } else if (place.section == Section::UtcTimes) {
    static_cast<void>(take_utc_times(place.content));
  } else if (place.section == Section::Energy) {
    if (place.object < unit.first_axis()) return Error::NoSuchParameter;
    const Energy energy = take_energy(place.content);
    if (!is_amount(energy.drawn) || !is_amount(energy.fed_back)) return Error::NoSuchParameter;
  } else {
    return std::nullopt;
  }
  return place.content.is_at_end() ? std::nullopt : std::optional{Error::Truncated};
}

/// Calls @p visit for every section; the first error, of the content or of @p visit.
template <class Visit>
std::optional<Error> for_each_section(Reader reader, const DriveUnit& unit, const Visit& visit) {
  for (auto objects = reader.take<std::uint16_t>(); objects > 0; --objects) {
    const auto number = reader.take<std::uint8_t>();
    const auto kind = reader.take<ObjectKind>();
    if (!reader.is_complete()) return Error::Truncated;
    if (const DriveObject* const object = unit.object(number); object == nullptr || object->kind() != kind)
      return Error::NoSuchObject;
    for (auto sections = reader.take<std::uint16_t>(); sections > 0; --sections) {
      const auto section = reader.take<Section>();
      const Reader content{reader.take_bytes(reader.take<std::uint16_t>())};
      if (!reader.is_complete()) return Error::Truncated;
      if (const std::optional<Error> error = visit(Place{number, section, content})) return error;
    }
  }
  return reader.is_at_end() ? std::nullopt : std::optional{Error::Truncated};
}

/// @p times are those of the faults that come next.
void load_section(DriveUnit& unit, Place place, Uptime runtime, UtcTimes& times) noexcept {
  if (place.section == Section::UtcTimes) times = take_utc_times(place.content);
  if (place.section == Section::Faults) {
    const UtcTimes utc = std::exchange(times, UtcTimes{});
    unit.object(place.object)->bring_back(with_utc(take_faults(place.content), utc), {runtime, utc.now});
  }
  if (place.section != Section::Energy) return;
  const Energy energy = take_energy(place.content);
  unit.axes()[place.object - unit.first_axis()].continue_energy(energy.drawn, energy.fed_back);
}

}  // namespace

std::size_t size(const DriveUnit& unit) noexcept {
  constexpr std::size_t kObjectSize =
      image_format::kObjectHeadSize + kSectionHeadSize + kUtcTimesSize + kSectionHeadSize + kFaultsSize;
  return kFixedSize + image_format::object_count(unit) * kObjectSize +
         unit.axes().size() * (kSectionHeadSize + kEnergySize);
}

tl::expected<std::span<const std::byte>, Error> save(const DriveUnit& unit, std::span<std::byte> buffer) noexcept {
  if (buffer.size() < size(unit)) return tl::unexpected{Error::NoRoom};
  Writer writer{buffer};
  image_format::begin(writer, kKind, unit);
  writer.put(unit.runtime());
  writer.put(image_format::object_count(unit));
  const std::optional<UtcTime> now = unit.control_unit().clock().line().utc();
  const auto put_messages = [&](const DriveObject& object) {
    const FaultMemory::Kept kept = object.messages().kept();
    put_utc_times(writer, kept, now);
    put_faults(writer, kept);
  };
  for (std::uint8_t number = kControlUnitNumber; number < unit.first_axis(); ++number) {
    const DriveObject& object = *unit.object(number);
    image_format::put_object_head(writer, object, 2);
    put_messages(object);
  }
  for (const Axis& axis : unit.axes()) {
    image_format::put_object_head(writer, axis, 3);
    put_messages(axis);
    put_energy(writer, axis.block<PowerUnit>());
  }
  return image_format::seal(writer);
}

tl::expected<void, Error> load(DriveUnit& unit, std::span<const std::byte> image) noexcept {
  auto content = image_format::open(image, kKind, unit);
  if (!content) return tl::unexpected{content.error()};
  const auto runtime = content->take<Uptime>();
  const auto judge = [&](const Place& place) { return section_error(unit, place); };
  if (const auto error = for_each_section(*content, unit, judge)) return tl::unexpected{*error};
  unit.continue_after(runtime);
  UtcTimes times{};
  for_each_section(*content, unit, [&](const Place& place) -> std::optional<Error> {
    load_section(unit, place, runtime, times);
    return std::nullopt;
  });
  return {};
}

}  // namespace drive::retained_image
