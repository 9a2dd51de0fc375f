#include "daemon/instance/memory/unit_memory.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "drive/images/retained_image.hpp"
#include "drive/images/storage_image.hpp"
#include "service/clock.hpp"

namespace axisd {
namespace {

constexpr std::uint16_t kMemoryFault = 1002;
constexpr std::uint32_t kParametersValue = 100, kRetainedValue = 200;
constexpr std::size_t kControlUnit = 0;
constexpr const char* kParametersName = "parameters.bin";

std::size_t longest_image(const drive::DriveUnit& unit) noexcept {
  return std::max(drive::storage_image::size(unit), drive::retained_image::size(unit));
}

}  // namespace

UnitMemory::UnitMemory(const std::filesystem::path& folder, device::Device& device, const Log& log)
    : log_{log},
      device_{device},
      parameters_{.file = {folder, kParametersName, log}, .number = kParametersValue},
      retained_{.file = {folder, "retained.bin", log}, .number = kRetainedValue},
      writer_{longest_image(device.unit())} {}

std::vector<std::byte> UnitMemory::saved_parameters(const std::filesystem::path& folder, const Log& log) {
  auto content = StateFile{folder, kParametersName, log}.read();
  return content && *content ? *std::move(*content) : std::vector<std::byte>{};
}

void UnitMemory::load() {
  load(parameters_, [this](std::span<const std::byte> image) { return device_.load_parameters(image); });
  load(retained_, [this](std::span<const std::byte> image) { return device_.load_retained(image); });
}

template <class Take>
void UnitMemory::load(Part& part, const Take& take) {
  const auto content = part.file.read();
  if (!content) {
    withhold(part, Misfit::Unreadable, fmt::format("cannot be read: {}", content.error()));
  } else if (*content) {
    const auto loaded = take(**content);
    part.in_use = loaded.has_value();
    if (!loaded)
      withhold(part, misfit_of(loaded.error()), std::string{drive::image_format::text_of(loaded.error())});
  }
  if (part.misfit != Misfit::None) tell(part);
}

void UnitMemory::withhold(Part& part, Misfit misfit, std::string reason) {
  part.misfit = misfit;
  part.reason = std::move(reason);
  part.stays = misfit != Misfit::Damaged;
}

/// What is damaged makes room at once: nothing could ever be read from it.
void UnitMemory::tell(Part& part) const {
  const std::string& path = part.file.path();
  if (part.stays) {
    log_.warning("{}: {}; it stays as it is, the unit starts without it and does not replace it", path,
                 part.reason);
    return;
  }
  const auto aside = part.file.set_aside(".bad");
  part.stays = !aside;
  log_.warning("{}: {}; {}, the unit starts without it", path, part.reason,
               aside ? "kept as " + *aside : "cannot be set aside: " + aside.error());
}

/// Of another version may also be one that was damaged there: better kept than lost.
UnitMemory::Misfit UnitMemory::misfit_of(drive::image_format::Error error) noexcept {
  using drive::image_format::Error;
  switch (error) {
    case Error::NotAnImage:
    case Error::Truncated:
    case Error::WrongChecksum:
      return Misfit::Damaged;
    case Error::OtherVersion:
      return Misfit::OtherVersion;
    case Error::NoRoom:
    case Error::OtherUnit:
    case Error::NoSuchObject:
    case Error::NoSuchParameter:
      break;
  }
  return Misfit::OtherUnit;
}

std::string UnitMemory::usage_of(const Part& part) {
  if (part.in_use) return "in use";
  if (part.misfit == Misfit::None) return "none";
  return fmt::format("{}: {}", part.stays || part.makes_room ? "not in use" : "set aside", part.reason);
}

void UnitMemory::raise_faults() noexcept {
  if (std::exchange(faults_raised_, true)) return;
  for (const Part* part : {&parameters_, &retained_}) {
    if (part->misfit == Misfit::None) continue;
    const std::uint32_t value = part->number + static_cast<std::uint32_t>(part->misfit);
    static_cast<void>(device_.raise(kControlUnit, kMemoryFault, value, read_clock()));
  }
}

device::Keeping UnitMemory::store(std::span<const std::byte> image) noexcept {
  if (parameters_.stays) return device::Keeping::Refused;
  writer_.begin(StateWriter::Place::Parameters, parameters_.file, image, Durability::OnDisk,
                parameters_.makes_room);
  return device::Keeping::Begun;
}

void UnitMemory::on_restore() noexcept {
  for (Part* part : {&parameters_, &retained_}) {
    if (std::exchange(part->stays, false)) part->makes_room = true;
  }
  if (retained_.makes_room) schedule_.on_faults(read_clock());
}

void UnitMemory::on_time(canopen::TimePoint now) noexcept {
  if (now < due()) return;
  if (retained_.stays) return schedule_.on_write(true, now);
  is_retaining_ = true;
  changes_kept_ = device_.message_changes();
  writer_.begin(StateWriter::Place::Retained, retained_.file, device_.retained(now), Durability::InTheCache,
                retained_.makes_room);
}

void UnitMemory::look_at_unit() noexcept {
  const bool changed = device_.message_changes() != changes_seen_;
  const bool planned = schedule_.due() != canopen::kNever;
  if (!changed && (planned || !device_.is_moving())) return;
  const canopen::TimePoint now = read_clock();
  if (changed) schedule_.on_faults(now);
  if (device_.is_moving()) schedule_.on_motion(now);
  changes_seen_ = device_.message_changes();
}

void UnitMemory::take_ended() noexcept {
  while (const auto ended = writer_.take_ended()) {
    if (ended->place == StateWriter::Place::Parameters) {
      on_parameters_written(ended->outcome);
    } else {
      on_retained_written(ended->outcome);
    }
  }
}

void UnitMemory::Part::on_written(const tl::expected<void, WriteFailure>& outcome) noexcept {
  if (!outcome) return file.report(outcome.error());
  in_use = true;
  makes_room = false;
}

void UnitMemory::on_parameters_written(const tl::expected<void, WriteFailure>& outcome) noexcept {
  parameters_.on_written(outcome);
  device_.on_stored(outcome.has_value(), read_clock());
}

void UnitMemory::on_retained_written(const tl::expected<void, WriteFailure>& outcome) noexcept {
  const canopen::TimePoint now = read_clock();
  is_retaining_ = false;
  retained_.on_written(outcome);
  schedule_.on_write(outcome.has_value(), now);
  if (device_.message_changes() != changes_kept_) schedule_.on_faults(now);
}

void UnitMemory::begin_power_off() noexcept {
  is_powering_off_ = true;
  writer_.finish();
  take_ended();
  if (retained_.stays) return;
  writer_.begin(StateWriter::Place::Retained, retained_.file, device_.retained(read_clock()), Durability::OnDisk,
                retained_.makes_room);
}

void UnitMemory::power_off() noexcept {
  if (!is_powering_off_) begin_power_off();
  writer_.finish();
  take_ended();
}

}  // namespace axisd
