#include "drive/catalogue/table.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "drive/base/function_modules.hpp"
#include "drive/brake/holding_brake_rows.hpp"
#include "drive/catalogue/axis_blocks.hpp"
#include "drive/catalogue/rows/absent/data_sets.hpp"
#include "drive/catalogue/rows/absent/networks.hpp"
#include "drive/catalogue/rows/absent/telegram_words.hpp"
#include "drive/catalogue/rows/can.hpp"
#include "drive/catalogue/rows/control.hpp"
#include "drive/catalogue/rows/display.hpp"
#include "drive/catalogue/rows/if1.hpp"
#include "drive/catalogue/rows/infeed.hpp"
#include "drive/catalogue/rows/messages.hpp"
#include "drive/catalogue/rows/pdo.hpp"
#include "drive/catalogue/rows/process_data.hpp"
#include "drive/catalogue/rows/profile.hpp"
#include "drive/catalogue/rows/technology.hpp"
#include "drive/catalogue/rows/terminals.hpp"
#include "drive/catalogue/rows/unit.hpp"
#include "drive/clock/unit_clock_rows.hpp"
#include "drive/external_messages/external_messages_rows.hpp"
#include "drive/identification/identification_rows.hpp"
#include "drive/jog/jog_rows.hpp"
#include "drive/measurement/encoder_interface_rows.hpp"
#include "drive/measurement/measurement_rows.hpp"
#include "drive/motor_model/motor_model_rows.hpp"
#include "drive/motor_monitoring/motor_monitoring_rows.hpp"
#include "drive/operator_panel/operator_panel_rows.hpp"
#include "drive/positioning/actual_position/actual_position_rows.hpp"
#include "drive/positioning/control/position_control_rows.hpp"
#include "drive/positioning/positioner/positioner_rows.hpp"
#include "drive/power_unit/power_unit_rows.hpp"
#include "drive/sequence_control/sequence_control_rows.hpp"
#include "drive/sequence_control/statusword_rows.hpp"
#include "drive/setpoint_channel/setpoint_channel_rows.hpp"
#include "drive/speed_control/speed_control_rows.hpp"
#include "drive/speed_messages/speed_messages_rows.hpp"
#include "drive/torque/torque_setpoint_rows.hpp"
#include "text/number.hpp"

namespace drive {
namespace {

template <class... Tables>
constexpr auto joined(const Tables&... tables) {
  std::array<const ParameterRow*, (std::tuple_size_v<Tables> + ...)> all{};
  std::size_t count = 0;
  const auto append = [&](const auto& table) {
    for (const ParameterRow& row : table) all[count++] = &row;
  };
  (append(tables), ...);
  std::sort(all.begin(), all.end(), [](const ParameterRow* a, const ParameterRow* b) {
    return a->number != b->number ? a->number < b->number : a->kinds < b->kinds;
  });
  return all;
}

/// The rows of all blocks of an axis, and those that belong to none.
template <class... Block>
constexpr auto joined_with(const std::tuple<Block...>*) {
  return joined(rows::rows_of<Block>..., rows::rows_of<UnitClock>, rows::kUnitRows, rows::kTerminalRows,
                rows::kInfeedRows, rows::kCanRows, rows::kPdoRows, rows::kIf1Rows, rows::kProcessDataRows,
                rows::kMessagesRows, rows::kDisplayRows, rows::kControlRows, rows::kTechnologyRows,
                rows::kDataSetRows, rows::kTelegramWordRows, rows::kNetworkRows, rows::kProfileRows);
}
constexpr auto kRows = joined_with(static_cast<const AxisBlocks*>(nullptr));

/// The table of one kind; Count is the number of its rows.
template <ObjectKind Kind, std::size_t Count>
constexpr auto placed() {
  std::array<PlacedRow, Count> table{};
  std::size_t filled = 0;
  std::uint16_t slot = 0;
  for (const ParameterRow* row : kRows) {
    if (!contains(row->kinds, Kind)) continue;
    table[filled++] = {row, is_in_a_slot(row->home) ? slot : kNoSlot};
    if (is_in_a_slot(row->home)) slot = static_cast<std::uint16_t>(slot + row->count);
  }
  return table;
}

template <ObjectKind Kind>
constexpr std::size_t kRowsOf = static_cast<std::size_t>(
    std::count_if(kRows.begin(), kRows.end(), [](const ParameterRow* row) { return contains(row->kinds, Kind); }));

template <ObjectKind Kind>
constexpr auto kPlaced = placed<Kind, kRowsOf<Kind>>();

template <ObjectKind Kind>
constexpr bool kNumbersAreUnique = [] {
  for (std::size_t i = 1; i < kPlaced<Kind>.size(); ++i)
    if (kPlaced<Kind>[i - 1].row->number >= kPlaced<Kind>[i].row->number) return false;
  return true;
}();
static_assert(std::max({kRowsOf<ObjectKind::ControlUnit>, kRowsOf<ObjectKind::Servo>, kRowsOf<ObjectKind::Vector>,
                        kRowsOf<ObjectKind::Infeed>}) <= profile_value::room_of(profile_value::kExisting),
              "the lists of existing parameters name them all");
static_assert(kNumbersAreUnique<ObjectKind::ControlUnit> && kNumbersAreUnique<ObjectKind::Servo> &&
                  kNumbersAreUnique<ObjectKind::Vector> && kNumbersAreUnique<ObjectKind::Infeed>,
              "lookup is a binary search, and no drive object has a parameter twice");

/// An input has a source, and nothing else has one but what the layer that owns the bus or nobody follows.
constexpr bool has_the_type_of_its_home(const ParameterRow& row) {
  if (std::holds_alternative<BitInput>(row.home)) return row.type == DataType::BinectorInput;
  if (std::holds_alternative<ValueInput>(row.home)) return row.type == DataType::ConnectorInput;
  if (std::holds_alternative<ImageInput>(row.home)) {
    const bool is_bit = std::get<ImageInput>(row.home).sink == ImageSink::BitOfWord;
    return row.type == (is_bit ? DataType::BinectorInput : DataType::ConnectorInput);
  }
  return !(is_bico_input(row.type) && std::holds_alternative<Setting>(row.home));
}

constexpr bool consistent(const ParameterRow* row) {
  const Range limits = limits_of(*row);
  const bool number = std::holds_alternative<double>(row->factory);
  const bool within =
      !number || !row->is_writable() ||
      (limits.minimum <= std::get<double>(row->factory) && std::get<double>(row->factory) <= limits.maximum);
  const std::size_t elements = elements_of(row->home);
  const bool display = std::holds_alternative<Fixed>(row->home);
  return row->count > 0 && row->kinds != 0 && within && !(display && row->is_writable()) &&
         (elements == 0 || row->count == elements) && has_the_type_of_its_home(*row);
}
/// What does nothing yet says what would make it act: itself, or by the module that it belongs to.
constexpr bool says_until_when(const ParameterRow* row) {
  const bool stored = std::holds_alternative<Stored>(row->home);
  if (!stored && !std::holds_alternative<Fixed>(row->home)) return true;
  const bool itself = !(stored ? std::get<Stored>(row->home).until : std::get<Fixed>(row->home).until).empty();
  return itself != function_module::belongs_to_missing(row->number);
}
static_assert(std::all_of(kRows.begin(), kRows.end(), says_until_when),
              "a parameter that is stored only or fixed says what would make it act");

static_assert(
    std::all_of(kRows.begin(), kRows.end(), consistent),
    "a factory value lies within the limits, a fixed value cannot be written, a setting has the indices of "
    "its member and an input a source");

constexpr std::array<std::span<const PlacedRow>, kObjectKindCount> kTables{
    kPlaced<ObjectKind::ControlUnit>, kPlaced<ObjectKind::Servo>, kPlaced<ObjectKind::Vector>,
    kPlaced<ObjectKind::Infeed>};

constexpr std::size_t slots(std::span<const PlacedRow> table) {
  std::size_t count = 0;
  for (const PlacedRow& placed : table) count += placed.slot != kNoSlot ? placed.row->count : 0U;
  return count;
}
constexpr std::array kSlotCounts{slots(kTables[0]), slots(kTables[1]), slots(kTables[2]), slots(kTables[3])};
static_assert(kSlotCounts.size() == kObjectKindCount);

}  // namespace

std::span<const ParameterRow* const> parameter_rows() noexcept {
  return kRows;
}

std::span<const PlacedRow> parameters_of(ObjectKind kind) noexcept {
  return kTables[static_cast<std::size_t>(kind)];
}

std::size_t slot_count(ObjectKind kind) noexcept {
  return kSlotCounts[static_cast<std::size_t>(kind)];
}

const PlacedRow* find_parameter(ObjectKind kind, std::uint16_t number) noexcept {
  const std::span<const PlacedRow> table = parameters_of(kind);
  const auto found = std::lower_bound(table.begin(), table.end(), number,
                                      [](const PlacedRow& p, std::uint16_t n) { return p.row->number < n; });
  return found != table.end() && found->row->number == number ? &*found : nullptr;
}

const ParameterRow* find_parameter(ObjectKind kind, std::string_view text) noexcept {
  constexpr std::size_t kLength = 5;
  constexpr std::size_t kLongest = 6;  // numbers from 10000 on
  if (text.size() != kLength && (text.size() != kLongest || text[1] == '0')) return nullptr;
  const auto number = text::integer<std::uint16_t>(text.substr(1));
  const PlacedRow* const placed = number ? find_parameter(kind, *number) : nullptr;
  if (placed == nullptr || text.front() != (placed->row->is_writable() ? 'p' : 'r')) return nullptr;
  return placed->row;
}

std::string parameter_text(const ParameterRow& row) {
  return fmt::format("{}{:04}", row.is_writable() ? 'p' : 'r', row.number);
}

}  // namespace drive
