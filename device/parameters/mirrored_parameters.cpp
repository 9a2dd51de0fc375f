#include "device/parameters/mirrored_parameters.hpp"

#include <algorithm>

#include "device/objects/abort_codes.hpp"
#include "device/objects/object_rows.hpp"
#include "device/parameters/object_parameters.hpp"

namespace device {
namespace {

constexpr std::uint8_t kMostMapped = 4;

/// The row of parameter @p number of a drive object of @p kind, or nullptr.
const Mirror* mirror_of(drive::ObjectKind kind, std::uint16_t number) noexcept {
  const auto* const row = std::ranges::find_if(kMirrors, [=](const Mirror& mirror) {
    return number >= mirror.first && number <= mirror.last && drive::contains(mirror.kinds, kind);
  });
  return row != kMirrors.end() ? row : nullptr;
}

constexpr bool is_mapping(std::uint16_t index) noexcept {
  return (index >= 0x1600 && index < 0x1800) || (index >= 0x1A00 && index < 0x1C00);
}

}  // namespace

MirroredParameters::MirroredParameters(canopen::Dictionary& dictionary, drive::DriveUnit& unit,
                                       unit::UnitParameters& parameters)
    : dictionary_{dictionary}, unit_{unit} {
  for (const Mirror& mirror : kMirrors) parameters.answer(mirror.first, mirror.last, *this);
}

bool MirroredParameters::contains(drive::ObjectKind kind, std::uint16_t number) noexcept {
  return mirror_of(kind, number) != nullptr;
}

const canopen::Entry* MirroredParameters::entry_of(const unit::ParameterPlace& place) const noexcept {
  const Mirror* const mirror = mirror_of(place.object.kind(), place.row.number);
  if (mirror == nullptr) return nullptr;
  const auto of_object = mirror->indexed == Indexed::Object ? place.index : 0U;
  const auto of_sub_index = mirror->indexed == Indexed::SubIndex ? place.index : 0U;
  std::size_t index = mirror->index + of_object + place.row.number - mirror->first;
  if (drive::contains(drive::kAxes, place.object.kind()))
    index += axis_offset(mirror->index, std::size_t{place.object.context().module} + 1);
  return dictionary_.lookup(static_cast<std::uint16_t>(index),
                            static_cast<std::uint8_t>(mirror->sub_index + of_sub_index));
}

std::optional<double> MirroredParameters::value_of(const unit::ParameterPlace& place) const noexcept {
  const canopen::Entry* const entry = entry_of(place);
  if (entry == nullptr) return std::nullopt;
  const auto value = dictionary_.read(*entry);
  return value ? std::optional{static_cast<double>(*value)} : std::nullopt;
}

std::optional<drive::Refusal> MirroredParameters::take(const unit::ParameterPlace& place, double value) noexcept {
  const canopen::Entry* const entry = entry_of(place);
  if (entry == nullptr) return drive::Refusal::NoParameter;
  const auto number = static_cast<std::int64_t>(value);
  if (number >> entry->bits != 0) return drive::Refusal::AboveMaximum;
  const auto written = dictionary_.write(*entry, number);
  if (written && is_mapping(entry->index)) write_count(*entry);
  return refusal(written);
}

/// Calls @p visit with drive object, number, index and entry for every index of the mirrored parameters that
/// @p selection means and that are kept.
template <class Visit>
void MirroredParameters::for_each_kept(const Selection& selection, const Visit& visit) {
  const auto visit_index = [&](drive::DriveObject& object, const drive::ParameterRow& row, std::size_t index) {
    const canopen::Entry* const entry = entry_of({object, row, index});
    if (entry != nullptr && entry->index >= selection.first && entry->index <= selection.last)
      visit(object, row.number, index, *entry);
  };
  const auto visit_object = [&](drive::DriveObject& object) {
    if (selection.object != 0 && selection.object != object.number()) return;
    for (const drive::PlacedRow& placed : drive::parameters_of(object.kind())) {
      const bool is_kept = placed.row->is_writable() && placed.row->keep != drive::Keep::No;
      for (std::size_t i = 0; is_kept && i < placed.row->count; ++i) visit_index(object, *placed.row, i);
    }
  };
  visit_object(*unit_.object(drive::kControlUnitNumber));
  for (drive::Axis& axis : unit_.axes()) visit_object(axis);
}

void MirroredParameters::bring_out(const Selection& selection) noexcept {
  for_each_kept(selection, [this](const drive::DriveObject& object, std::uint16_t number, std::size_t index,
                                  const canopen::Entry& entry) {
    const double value = object.kept_value(number, index).value_or(0.0);
    dictionary_.set(entry, static_cast<std::int64_t>(value));
    if (is_mapping(entry.index)) count_mapped(entry);
  });
}

void MirroredParameters::bring_out(std::uint16_t first, std::uint16_t last) noexcept {
  bring_out({.first = first, .last = last});
}

void MirroredParameters::bring_out(std::uint8_t object) noexcept {
  bring_out({.object = object});
}

/// The entries before the first empty one of the mapping that @p entry belongs to: no parameter holds their count.
std::int64_t MirroredParameters::mapped(const canopen::Entry& entry) const noexcept {
  std::int64_t count = 0;
  while (count < kMostMapped &&
         dictionary_.stored(entry.index, static_cast<std::uint8_t>(count + 1)).value_or(0) != 0)
    ++count;
  return count;
}

void MirroredParameters::count_mapped(const canopen::Entry& entry) noexcept {
  if (const canopen::Entry* const counter = dictionary_.lookup(entry.index, 0))
    dictionary_.set(*counter, mapped(entry));
}

/// The count after a master has written @p entry as a parameter: also after 0 was written to it as an object. What
/// does not fit yet is judged once more when the PDO becomes valid.
void MirroredParameters::write_count(const canopen::Entry& entry) noexcept {
  const canopen::Entry* const counter = dictionary_.lookup(entry.index, 0);
  const std::int64_t count = mapped(entry);
  if (counter != nullptr && dictionary_.stored(*counter) != count)
    static_cast<void>(dictionary_.write(*counter, count));
}

}  // namespace device
