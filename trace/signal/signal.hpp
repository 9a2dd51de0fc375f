#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "drive/drive_unit.hpp"
#include "trace/signal/place.hpp"
#include "trace/signal/problem.hpp"

namespace trace {

/// Brings a number of a drive unit as it is now, in the unit in which it is shown; nothing is searched for. It is
/// a value that holds as long as the drive unit lives.
class Reader {
 public:
  /// Index @p index of @p placed, a parameter of @p object.
  static Reader of_parameter(const drive::DriveObject& object, const drive::PlacedRow& placed,
                             std::size_t index) noexcept {
    Reader reader;
    reader.object_ = &object;
    reader.placed_ = &placed;
    reader.index_ = static_cast<std::uint16_t>(index);
    return reader;
  }
  /// Of a parameter: its bit @p bit, 0 or 1.
  Reader bit(unsigned bit) const noexcept {
    Reader reader = *this;
    reader.bit_ = static_cast<std::int8_t>(bit);
    return reader;
  }
  /// What @p get finds in @p owner, in SI units; @p si is the size of the unit in which it is shown.
  template <class Owner>
  static Reader of_quantity(const Owner& owner, double (*const& get)(const Owner&) noexcept, double si) noexcept {
    Reader reader;
    reader.owner_ = &owner;
    reader.row_ = &get;
    reader.get_ = [](const void* from, const void* row) noexcept {
      const auto getter = *static_cast<double (*const*)(const Owner&) noexcept>(row);
      return getter(*static_cast<const Owner*>(from));
    };
    reader.size_ = si;
    return reader;
  }

  double value() const noexcept {
    if (get_ != nullptr) return get_(owner_, row_) / size_;
    const double number = object_->value(*placed_, index_);
    return bit_ == kNoBit ? number : static_cast<double>(static_cast<std::int64_t>(number) >> bit_ & 1);
  }

 private:
  static constexpr int kNoBit = -1;

  double (*get_)(const void* owner, const void* row) noexcept = nullptr;
  const void* owner_ = nullptr;
  const void* row_ = nullptr;  ///< the function of the quantity
  double size_ = 1.0;          ///< of the unit
  const drive::DriveObject* object_ = nullptr;
  const drive::PlacedRow* placed_ = nullptr;
  std::uint16_t index_ = 0;
  std::int8_t bit_ = kNoBit;
};

/// Something of a drive unit that is a number at any instant: a parameter, a bit of one, a physical quantity.
struct Signal {
  std::string name;       ///< "1/r0063", "1/r0899.2", "0/r0722", "1/p1001[2]", "1/speed": place/what
  std::string_view unit;  ///< in which it is shown, empty: none
  std::string_view text;  ///< what it is
  Reader reader;
};

/// The signal of @p unit that is called @p name. The place may be left out where one drive object alone has what
/// is named; index 0 of a parameter may be, too. The key of a problem is empty.
tl::expected<Signal, Problem> find_signal(const drive::DriveUnit& unit, std::string_view name);

}  // namespace trace
