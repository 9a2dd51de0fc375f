#include "tools/canopen-check/core/run/protected_entries.hpp"

#include <algorithm>
#include <array>

#include "tools/canopen-check/core/standard_numbers.hpp"

namespace conformance {
namespace {

/// Objects of CiA 402 that make a drive move, for the first axis; the others are 800h apart.
constexpr std::array<std::uint16_t, 10> kMotion{0x6040, 0x6042, 0x6060, 0x6071, 0x6074,
                                                0x607A, 0x60B0, 0x60B1, 0x60B2, 0x60FF};

/// The object of the first axis for one of any axis; 0 for others.
std::uint16_t of_first_axis(std::uint16_t index) noexcept {
  if (index < kFirstAxis || index >= kEndOfAxes) return 0;
  return static_cast<std::uint16_t>(kFirstAxis + (index - kFirstAxis) % kAxisDistance);
}

bool moves(std::uint16_t index) noexcept {
  return std::ranges::find(kMotion, of_first_axis(index)) != kMotion.end();
}

constexpr std::uint16_t kControlword = 0x6040;

/// Objects whose writing is an order, not a value.
struct Order {
  std::uint16_t first, last;
  const char* refusal;
};
constexpr std::array kOrders{
    Order{0x1003, 0x1003, "writing it deletes the error history"},
    Order{0x1F50, 0x1F5F, "it belongs to the download of programs"},
};

}  // namespace

const char* write_refusal(const eds::EntryFacts& entry, const Settings& settings) noexcept {
  if (entry.no_write) return "ObjFlags asks not to write it";
  if (!settings.allow_store &&
      (entry.index == object::kStoreParameters || entry.index == object::kRestoreParameters))
    return "it needs --allow-store";
  if (!settings.allow_motion && moves(entry.index)) return "it needs --allow-motion";
  if (of_first_axis(entry.index) == kControlword) return "it is a command to the drive";
  const auto order = std::ranges::find_if(
      kOrders, [&](const Order& row) { return entry.index >= row.first && entry.index <= row.last; });
  return order == kOrders.end() ? nullptr : order->refusal;
}

}  // namespace conformance
