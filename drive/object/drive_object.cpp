#include "drive/object/drive_object.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "drive/parameter/rounding.hpp"
#include "drive/parameter/transfer.hpp"

namespace drive {
namespace {

/// A reason why @p value is none of the type of @p row or beyond its limits; REAL32 limits are compared as such.
std::optional<Refusal> limit_refusal(const ParameterRow& row, double value) noexcept {
  const Range limits = limits_of(row);
  const auto represented = [&](double number) {
    return row.type == DataType::F32 ? static_cast<double>(static_cast<float>(number)) : number;
  };
  if (!(represented(value) >= represented(limits.minimum))) return Refusal::BelowMinimum;  // nor is it a number
  if (represented(value) > represented(limits.maximum)) return Refusal::AboveMaximum;
  const bool integer = row.type != DataType::F32;
  if (integer && std::abs(value - std::trunc(value)) > 0.0) return Refusal::WrongType;
  return std::nullopt;
}

/// What a parameter of whole numbers shows of @p value.
double represented(const ParameterRow& row, double value) noexcept {
  return row.type == DataType::F32 ? value : std::round(value);
}

/// Why @p value cannot be taken over as a saved one of @p row.
std::optional<Refusal> load_refusal(const ParameterRow& row, double value) noexcept {
  return is_saved(row) ? limit_refusal(row, value) : std::optional{Refusal::ReadOnly};
}

/// What converters invert is settled with their sources.
constexpr std::array<std::uint16_t, 4> kInversions{2088, 2098, 8888, 8898};

/// Inputs, and what the values of sources are settled with: references, inversions.
bool concerns_wiring(const ParameterRow& row) noexcept {
  return is_bico_input(row.type) || is_reference(row.number) ||
         std::ranges::find(kInversions, row.number) != kInversions.end();
}

/// What of the messages of an axis the infeed has too: it is not ready, the DC link is lost.
constexpr std::array<std::uint16_t, 2> kAlsoOfTheInfeed{7802, 30003};

bool can_appear(const FaultRow& row, ObjectKind kind) noexcept {
  if (row.scope == Scope::Both) return true;
  if (kind == ObjectKind::Infeed) return std::ranges::find(kAlsoOfTheInfeed, row.number) != kAlsoOfTheInfeed.end();
  return row.scope == (kind == ObjectKind::ControlUnit ? Scope::ControlUnit : Scope::Axis);
}

bool is_agreed(const ParameterRow& row) noexcept {
  return std::holds_alternative<Agreed>(row.home) || std::holds_alternative<HostCommand>(row.home);
}

}  // namespace

DriveObject::DriveObject(const ObjectContext& context) : context_{context}, slots_(slot_count(context.kind)) {
  for (const PlacedRow& placed : parameters_of(context.kind)) {
    if (placed.slot == kNoSlot) continue;
    for (std::size_t i = 0; i < placed.row->count; ++i)
      slots_[placed.slot + i] = encode(placed.row->type, factory_value(*placed.row, context_, i)).bits;
  }
}

std::uint8_t DriveObject::number() const noexcept {
  if (kind() == ObjectKind::ControlUnit) return kControlUnitNumber;
  if (kind() == ObjectKind::Infeed) return kInfeedNumber;
  return static_cast<std::uint8_t>(first_axis_number(context_.has_infeed) + context_.module);
}

std::size_t DriveObject::objects_of_unit() const noexcept {
  if (surroundings_ == nullptr) return 1;
  std::size_t count = 0;
  while (surroundings_->kind_of(static_cast<std::uint8_t>(kControlUnitNumber + count))) ++count;
  return count;
}

tl::expected<const PlacedRow*, ParameterError> DriveObject::find(std::uint16_t number,
                                                                 std::size_t index) const noexcept {
  const PlacedRow* const placed = find_parameter(kind(), number);
  if (placed == nullptr) return tl::unexpected{ParameterError{Refusal::NoParameter, number, nullptr}};
  const ParameterRow& row = *placed->row;
  if (index < row.count) return placed;
  return tl::unexpected{ParameterError{row.count == 1 ? Refusal::NotIndexed : Refusal::NoIndex, number, &row}};
}

tl::expected<const PlacedRow*, ParameterError> DriveObject::parameter(std::uint16_t number,
                                                                      std::size_t index) const noexcept {
  auto found = find(number, index);
  const ParameterRow* const row = found ? (*found)->row : found.error().row;
  if (row != nullptr && !provides(*row)) return tl::unexpected{ParameterError{Refusal::NoParameter, number, row}};
  return found;
}

tl::expected<double, ParameterError> DriveObject::read(std::uint16_t number, std::size_t index) const noexcept {
  return parameter(number, index).map([&](const PlacedRow* placed) { return value(*placed, index); });
}

tl::expected<double, ParameterError> DriveObject::kept_value(std::uint16_t number,
                                                             std::size_t index) const noexcept {
  return find(number, index).map([&](const PlacedRow* placed) { return kept_value_of(*placed, index); });
}

tl::expected<void, ParameterError> DriveObject::write(std::uint16_t number, std::size_t index,
                                                      double value) noexcept {
  return parameter(number, index).and_then([&](const PlacedRow* placed) { return write(*placed, index, value); });
}

tl::expected<void, ParameterError> DriveObject::write(const PlacedRow& placed, std::size_t index,
                                                      double value) noexcept {
  const ParameterRow& row = *placed.row;
  const auto refused = [&](Refusal reason) { return tl::unexpected{ParameterError{reason, row.number, &row}}; };
  if (const auto reason = state_refusal(row)) return refused(*reason);
  if (surroundings_ != nullptr)
    if (const auto reason = surroundings_->lock_on(*this, row, index)) return refused(*reason);
  if (const auto reason = value_refusal(row, index, value)) return refused(*reason);
  if (is_agreed(row) && surroundings_ != nullptr)
    if (const auto reason = surroundings_->agree(*this, row, index, value)) return refused(*reason);
  if (!std::holds_alternative<HostCommand>(row.home)) assign(placed, index, value);
  tell(row);
  return {};
}

std::optional<Refusal> DriveObject::state_refusal(const ParameterRow& row) const noexcept {
  const WriteState state = write_state();
  return allows(row.when, state) ? std::nullopt : std::optional{refusal(row.when, state)};
}

/// Only what @p row concerns is to be computed anew.
void DriveObject::tell(const ParameterRow& row) noexcept {
  if (const BlockId block = concerned(row.home)) on_settings_changed(block);
  on_parameter_written();
}

std::optional<ParameterError> DriveObject::load_error(std::uint16_t number, std::size_t index,
                                                      double value) const noexcept {
  const auto found = find(number, index);
  if (!found) return found.error();
  const auto reason = load_refusal(*(*found)->row, value);
  return reason ? std::optional{ParameterError{*reason, number, (*found)->row}} : std::nullopt;
}

tl::expected<void, ParameterError> DriveObject::load(std::uint16_t number, std::size_t index,
                                                     double value) noexcept {
  const auto found = find(number, index);
  if (!found) return tl::unexpected{found.error()};
  const ParameterRow& row = *(*found)->row;
  if (const auto reason = load_refusal(row, value)) return tl::unexpected{ParameterError{*reason, number, &row}};
  assign(**found, index, value);
  tell(row);
  return {};
}

void DriveObject::bring_in(std::uint16_t number, std::size_t index, double value) noexcept {
  const auto found = find(number, index);
  if (found && is_agreed(*(*found)->row)) assign(**found, index, value);
}

void DriveObject::restore_parameters(RowFilter which) noexcept {
  for (const PlacedRow& placed : parameters_of(kind())) {
    const ParameterRow& row = *placed.row;
    if (!is_saved(row) || !which(row)) continue;
    for (std::size_t i = 0; i < row.count; ++i) assign(placed, i, factory_value(row, context_, i));
  }
  on_settings_changed(nullptr);
  on_parameter_written();
}

/// BICO: what the input is connected to has to exist and to be something that it can take.
std::optional<Refusal> DriveObject::source_refusal(const ParameterRow& row, double value) const noexcept {
  const auto packed = static_cast<std::uint32_t>(value);
  if (packed <= kHighestConstant) return std::nullopt;
  const BicoSource source = unpack(packed);
  const bool own = source.object == kOwnObject || source.object == number();
  const std::optional<ObjectKind> owner = own                        ? std::optional{kind()}
                                          : surroundings_ != nullptr ? surroundings_->kind_of(source.object)
                                                                     : std::nullopt;
  const PlacedRow* const placed = owner ? find_parameter(*owner, source.number) : nullptr;
  if (placed == nullptr || placed->row->output == Output::No) return Refusal::IllegalSource;
  const bool bit = row.type == DataType::BinectorInput;
  if (bit && !has_bits(*placed->row)) return Refusal::IllegalSource;
  const bool bits_of_word = bit && placed->row->output != Output::Bits;
  const std::size_t positions = bits_of_word ? 8U * row_of(placed->row->type).size : placed->row->count;
  return source.position < positions ? std::nullopt : std::optional{Refusal::IllegalSource};
}

std::optional<Refusal> DriveObject::value_refusal(const ParameterRow& row, std::size_t index,
                                                  double value) const noexcept {
  if (const auto reason = limit_refusal(row, value)) return reason;
  if (is_bico_input(row.type)) return source_refusal(row, value);
  return row.check != nullptr ? row.check(*this, index, value) : std::nullopt;
}

double DriveObject::value(const PlacedRow& placed, std::size_t index) const noexcept {
  const ParameterRow& row = *placed.row;
  if (is_agreed(row) && surroundings_ != nullptr)
    if (const auto value = surroundings_->agreed_value(*this, row, index)) return *value;
  return kept_value_of(placed, index);
}

double DriveObject::kept_value_of(const PlacedRow& placed, std::size_t index) const noexcept {
  const ParameterRow& row = *placed.row;
  if (placed.slot != kNoSlot) return decode({row.type, slots_[placed.slot + index]});
  if (const auto* const fixed = std::get_if<Fixed>(&row.home)) return fixed->value;
  if (const auto* const home = std::get_if<Setting>(&row.home))
    return rounded(home->get(block(home->block), index) / row_of(row.unit).si);
  if (const auto* const shown = std::get_if<BlockOutput>(&row.home))
    return represented(row, shown->get(block(shown->block), index) / row_of(row.unit).si);
  if (const auto* const shown = std::get_if<Computed>(&row.home)) return shown->get(block(shown->block), index);
  return 0.0;
}

bool DriveObject::is_as_delivered(const PlacedRow& placed) const noexcept {
  const ParameterRow& row = *placed.row;
  for (std::size_t i = 0; i < row.count; ++i)
    if (!is_same(transferred(row.type, value(placed, i)), transferred(row.type, factory_value(row, context_, i))))
      return false;
  return true;
}

void DriveObject::set_setting(const ParameterRow& row, std::size_t index, double value) noexcept {
  const auto& home = std::get<Setting>(row.home);
  before_setting(row);
  home.set(block(home.block), index, value * row_of(row.unit).si);
  after_setting(row);
}

void* DriveObject::block(BlockId id) noexcept {
  void* const found = find_block(id, *this, memory_, process_data_, converters_, if1_converters_);
  return found != nullptr ? found : own_block(id);
}

const void* DriveObject::block(BlockId id) const noexcept {
  const void* const found = find_block(id, *this, memory_, process_data_, converters_, if1_converters_);
  return found != nullptr ? found : own_block(id);
}

void DriveObject::scale_process_data(const ProcessDataImage::Scales& scales) noexcept {
  if (scales == process_data_.scales) return;
  process_data_.scales = scales;
  if (surroundings_ != nullptr) surroundings_->on_wiring_changed();
}

void DriveObject::assign(const PlacedRow& placed, std::size_t index, double value) noexcept {
  const ParameterRow& row = *placed.row;
  if (surroundings_ != nullptr && concerns_wiring(row)) surroundings_->on_wiring_changed();
  if (placed.slot != kNoSlot) {
    slots_[placed.slot + index] = encode(row.type, value).bits;
    const auto* const home = std::get_if<Slot>(&row.home);
    if (home != nullptr && home->give != nullptr)
      home->give(block(home->reader), index, kept_value_of(placed, index) * row_of(row.unit).si);
  } else if (std::holds_alternative<Setting>(row.home)) {
    set_setting(row, index, value);
  } else if (const auto* const computed = std::get_if<Computed>(&row.home)) {
    computed->set(block(computed->block), index, value);
  }
}

tl::expected<void, FaultError> DriveObject::raise(std::uint16_t number, std::uint32_t value,
                                                  Cause cause) noexcept {
  const FaultRow* const row = find_fault(number);
  if (row == nullptr) return tl::unexpected{FaultError::Unknown};
  if (!can_appear(*row, kind())) return tl::unexpected{FaultError::NotOnThisAxis};
  enter(*row, value, cause);
  on_messages_changed();
  return {};
}

void DriveObject::enter(const FaultRow& row, std::uint32_t value, Cause cause) noexcept {
  memory_.enter(row, value, cause);
  if (memory_.settings.kind_of(row) == Kind::Fault) react(row);
}

void DriveObject::withdraw(std::uint16_t number) noexcept {
  const FaultRow* const row = find_fault(number);
  if (row == nullptr) return;
  if (memory_.withdraw(*row)) on_acknowledged_fault_left();
  on_messages_changed();
}

}  // namespace drive
