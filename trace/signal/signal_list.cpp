#include "trace/signal/signal_list.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "trace/signal/quantity_table.hpp"

namespace trace {
namespace {

using drive::DriveObject;
using drive::DriveUnit;

constexpr char lower(char letter) noexcept {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool contains(std::string_view text, std::string_view word) noexcept {
  return std::search(text.begin(), text.end(), word.begin(), word.end(),
                     [](char a, char b) { return lower(a) == lower(b); }) != text.end();
}

/// Whether every word of @p wanted is in @p name or @p text.
bool matches(std::string_view wanted, std::string_view name, std::string_view text) noexcept {
  while (!wanted.empty()) {
    const std::size_t end = std::min(wanted.find(' '), wanted.size());
    const std::string_view word = wanted.substr(0, end);
    if (!word.empty() && !contains(name, word) && !contains(text, word)) return false;
    wanted.remove_prefix(std::min(end + 1, wanted.size()));
  }
  return true;
}

/// Takes those of the signals that are told to it that were asked for.
class Collector {
 public:
  explicit Collector(const SignalSearch& search) : search_{search} {}

  void take(ListedSignal signal) {
    if (!matches(search_.text, signal.name, signal.text)) return;
    const std::size_t number = page_.total++;
    if (number >= search_.from && page_.signals.size() < search_.count) page_.signals.push_back(std::move(signal));
  }
  template <class Owner>
  void take_quantities(std::span<const QuantityRow<Owner>> rows, Place place) {
    for (const QuantityRow<Owner>& row : rows)
      take({.name = fmt::format("{}/{}", place_text(place), row.name),
            .unit = row_of(row.unit).text,
            .text = row.text,
            .is_quantity = true});
  }
  void take_parameters(const DriveObject& object, Place place) {
    for (const drive::PlacedRow& placed : parameters_of(object.kind())) {
      const drive::ParameterRow& row = *placed.row;
      if (!object.provides(row)) continue;
      const bool bits = row.output == drive::Output::Both;
      take({.name = fmt::format("{}/{}", place_text(place), parameter_text(row)),
            .unit = row_of(row.unit).text,
            .text = row.name,
            .indices = row.count,
            .bits = static_cast<std::uint8_t>(bits ? 8U * row_of(row.type).size : 0U)});
    }
  }
  SignalPage page() && { return std::move(page_); }

 private:
  SignalSearch search_;
  SignalPage page_;
};

}  // namespace

SignalPage list_signals(const DriveUnit& unit, const SignalSearch& search) {
  Collector collector{search};
  collector.take_quantities(unit_quantities(), kControlUnitPlace);
  for (const drive::Axis& axis : unit.axes())
    collector.take_quantities(axis_quantities(), static_cast<Place>(axis.axis_number()));
  unit.for_each_object(
      [&](const DriveObject& object) { collector.take_parameters(object, place_of(unit, object)); });
  return std::move(collector).page();
}

}  // namespace trace
