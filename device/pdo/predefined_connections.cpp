#include "device/pdo/predefined_connections.hpp"

#include <array>

#include "libcanopen/base/cob_id.hpp"
#include "libcanopen/pdo/settings.hpp"

namespace device {
namespace {

using canopen::Entry;
using pdo::Direction;
using pdo::Part;

constexpr std::array kDirections{Direction::Receive, Direction::Transmit};

/// Writes the PDO parameters of one axis and keeps the first refusal.
class Writer {
 public:
  Writer(canopen::Dictionary& dictionary, std::size_t axis) noexcept : dictionary_{dictionary}, axis_{axis} {}

  const canopen::Result<void>& result() const noexcept { return result_; }

  void make_invalid(pdo::Pdo pdo) noexcept {
    write(pdo, Part::Communication, canopen::pdo_sub::kCobId,
          [&](const Entry& e) { return dictionary_.stored(e) | canopen::cob_id::kInvalid; });
  }
  /// From the last entry to the first, so that the count follows them.
  void empty(pdo::Pdo pdo) noexcept {
    for (std::uint8_t sub = pdo::kMostEntries; sub >= 1; --sub)
      write(pdo, Part::Mapping, sub, [](const Entry&) { return std::int64_t{0}; });
  }
  void map_initial(pdo::Pdo pdo) noexcept {
    for (std::uint8_t sub = 1; sub <= pdo::kMostEntries; ++sub) write_initial(pdo, Part::Mapping, sub);
    write_initial(pdo, Part::Mapping, 0);
  }
  void write_initial(pdo::Pdo pdo, Part part, std::uint8_t sub) noexcept {
    write(pdo, part, sub, [&](const Entry& e) { return dictionary_.initial(e); });
  }
  template <class Action>
  void for_each(const Action& action) noexcept {
    for (const Direction direction : kDirections)
      for (std::uint16_t place = 0; place < pdo::kOfAnAxis; ++place) action(pdo::of_axis(direction, axis_, place));
  }

 private:
  template <class Value>
  void write(pdo::Pdo pdo, Part part, std::uint8_t sub, const Value& value_of) noexcept {
    const Entry* const entry = dictionary_.lookup(pdo::index_of(pdo, part), sub);
    if (entry == nullptr || !entry->writable) return;
    const auto written = dictionary_.write(*entry, value_of(*entry));
    if (result_) result_ = written;
  }

  canopen::Dictionary& dictionary_;
  std::size_t axis_;
  canopen::Result<void> result_{};
};

constexpr std::array kTimesAndTypes{canopen::pdo_sub::kTransmissionType, canopen::pdo_sub::kInhibitTime,
                                    canopen::pdo_sub::kEventTimer};

}  // namespace

canopen::Result<void> restore_predefined_connections(canopen::Dictionary& dictionary, std::size_t axis) noexcept {
  Writer writer{dictionary, axis};
  writer.for_each([&](pdo::Pdo pdo) { writer.make_invalid(pdo); });
  if (!writer.result()) return writer.result();  // Operational
  writer.for_each([&](pdo::Pdo pdo) { writer.empty(pdo); });
  writer.for_each([&](pdo::Pdo pdo) {
    writer.map_initial(pdo);
    for (const std::uint8_t sub : kTimesAndTypes) writer.write_initial(pdo, Part::Communication, sub);
    writer.write_initial(pdo, Part::Communication, canopen::pdo_sub::kCobId);
  });
  return writer.result();
}

}  // namespace device
