#include "drive/reference/parameter_reference.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "drive/catalogue/effect_text.hpp"
#include "drive/catalogue/table.hpp"

namespace drive {
namespace {

constexpr std::string_view kIntroduction = R"(# Parameters

Generated from the rows that drive/catalogue lists by the target `update_parameter_reference`; a test compares it with them.

The drive objects of the unit are the control unit (number 1) and the axes (from 2), each of them servo or vector; where
the configuration makes the infeed a drive object, it has the number 2 and the axes begin at 3. A parameter is read and written at an index, from 0. "Factory" is the value of a new unit, which is commissioned for the
machine of its configuration and connected by the predefined connection set; *computed* depends on machine, address or
drive object. "Change" says when it can be written: U while the motor runs, T with the pulses off, C(n) in
commissioning with p0010 (axis) or p0009 (control unit) at n; nothing = read only. "Source" tells what it can be wired to:
CO connector inputs, CO/BO also, bit by bit, binector inputs. The last column is what the parameter does in the simulation:

- *true value*: it shows what the simulated axis does;
- *stored only*: it can be written, read and saved, and nothing acts on it yet; what would make it act stands behind it;
- *wiring stored*: a BICO input, whose source is checked and kept but not followed yet;
- *fixed*: the quantity is not in the model yet, the parameter shows this value;
- *bus*: it is kept here and belongs to the layer that owns the bus: that agrees to a change, acts on it and brings in its own values;
- *command*: carried out by the layer that owns bus and files, not kept.

Saved are all writable parameters except commands, counters and the commissioning filters. A factory reset changes all
saved ones but p8620, p8622 and p8623.

)";

std::string kinds(const ParameterRow& row) {
  struct Name {
    ObjectKinds kinds;
    std::string_view text;
  };
  constexpr std::array kNames{Name{kAll, "all"},
                              Name{kWithProcessData, "control unit, axes"},
                              Name{kAxes | kInfeed, "axes, infeed"},
                              Name{kControlUnit | kInfeed, "control unit, infeed"},
                              Name{kAxes, "axes"},
                              Name{kControlUnit, "control unit"},
                              Name{kServo, "servo"},
                              Name{kVector, "vector"},
                              Name{kInfeed, "infeed"}};
  for (const Name& name : kNames)
    if (name.kinds == row.kinds) return std::string{name.text};
  return {};
}

/// The source of a BICO input as "r8890.0" or "r8860[1]".
std::string source(const ParameterRow& row, std::uint32_t packed) {
  if (packed <= kHighestConstant) return fmt::format("{}", packed);
  const BicoSource from = unpack(packed);
  const PlacedRow* const placed = find_parameter(ObjectKind::Servo, from.number);
  const bool bit = row.type == DataType::BinectorInput;
  const std::string name = placed != nullptr ? parameter_text(*placed->row) : fmt::format("{}", from.number);
  return bit ? fmt::format("{}.{}", name, from.position) : fmt::format("{}[{}]", name, from.position);
}

std::string factory(const ParameterRow& row) {
  const auto* const value = std::get_if<double>(&row.factory);
  const bool shown = row.is_writable() || std::holds_alternative<Agreed>(row.home);
  if (!shown) return "";
  if (value == nullptr) return "computed";
  return is_bico_input(row.type) ? source(row, static_cast<std::uint32_t>(*value)) : number_text(*value);
}

std::string range(const ParameterRow& row) {
  if (!row.is_writable() || is_bico_input(row.type)) return "";
  const Range limits = limits_of(row);
  return fmt::format("{} … {}", number_text(limits.minimum), number_text(limits.maximum));
}

std::string_view output(const ParameterRow& row) {
  constexpr std::array<std::string_view, 4> kTexts{"", "CO", "CO/BO", "CO/BO"};
  return kTexts[static_cast<std::size_t>(row.output)];
}

void write_row(std::string& page, const ParameterRow& row) {
  fmt::format_to(std::back_inserter(page), "| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                 parameter_text(row), row.name, kinds(row), static_cast<int>(row.count), row_of(row.type).text,
                 row_of(row.unit).text, range(row), factory(row), row_of(row.when).text, output(row),
                 effect_text(row));
}

/// How many parameters there are, that there are no others, and which of them no server of SDOs shows.
void write_counts(std::string& page) {
  constexpr std::uint16_t kHighestObject = 9999;
  std::string beyond;
  std::uint16_t highest = 0;
  for (const ParameterRow* row : parameter_rows()) {
    if (row->number <= kHighestObject)
      highest = std::max(highest, row->number);
    else
      beyond += (beyond.empty() ? "" : ", ") + parameter_text(*row);
  }
  fmt::format_to(
      std::back_inserter(page),
      "The control unit has {} parameters, a servo axis {}, a vector axis {}. Every one that is not "
      "listed here does\n"
      "not exist (06020000h). The highest number that an SDO reaches is {}, so p8630[2] above 0 shows none; "
      "only other\n"
      "doors than CANopen read {}.\n\n",
      parameters_of(ObjectKind::ControlUnit).size(), parameters_of(ObjectKind::Servo).size(),
      parameters_of(ObjectKind::Vector).size(), highest, beyond);
}

/// A line with the parameters that @p begin begins the role of.
void write_list(std::string& page, std::string_view title, std::string_view begin) {
  std::vector<std::string> names;
  for (const ParameterRow* row : parameter_rows()) {
    if (role_text(*row).rfind(begin, 0) != 0) continue;
    const std::string name = parameter_text(*row);
    if (names.empty() || names.back() != name) names.push_back(name);
  }
  fmt::format_to(std::back_inserter(page), "## {}\n\n{} parameters:", title, names.size());
  constexpr std::size_t kLineLength = 110;
  std::size_t length = kLineLength;
  for (const std::string& name : names) {
    length += name.size() + 1;
    const bool wraps = length > kLineLength;
    if (wraps) length = name.size();
    page += wraps ? '\n' : ' ';
    page += name;
  }
  page += "\n\n";
}

}  // namespace

std::string parameter_reference() {
  std::string page{kIntroduction};
  write_counts(page);
  page +=
      "## All parameters\n\n"
      "| Number | Name | Drive objects | Indices | Type | Unit | Range | Factory | Change | Source | In the "
      "simulation |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const ParameterRow* row : parameter_rows()) write_row(page, *row);
  page += '\n';
  write_list(page, "Stored only", "stored only");
  write_list(page, "Wiring that is stored", "wiring stored");
  write_list(page, "Fixed until the model has the quantity", "fixed");
  page.pop_back();
  return page;
}

}  // namespace drive
