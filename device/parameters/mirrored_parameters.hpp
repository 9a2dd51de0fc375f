#pragma once

#include <cstdint>

#include "drive/drive_unit.hpp"
#include "libcanopen/od/dictionary.hpp"
#include "unit/parameter_owner.hpp"
#include "unit/unit_parameters.hpp"

namespace device {

/// The parameters that are communication objects under another number: p8602 is 1005h, p8700[0] of the second axis
/// 1440h:01. The dictionary is their only home, so that its rules judge a value whichever way it comes.
class MirroredParameters final : public unit::ParameterOwner {
 public:
  /// Answers in @p parameters for what is mirrored; all arguments must outlive this.
  MirroredParameters(canopen::Dictionary& dictionary, drive::DriveUnit& unit, unit::UnitParameters& parameters);

  /// Whether parameter @p number of a drive object of @p kind is mirrored.
  static bool contains(drive::ObjectKind kind, std::uint16_t number) noexcept;
  /// The entry that @p place shows; nullptr if it is none that the dictionary has.
  const canopen::Entry* entry_of(const unit::ParameterPlace& place) const noexcept;
  /// Puts what was loaded or restored into the objects @p first to @p last, without asking anybody: the services
  /// of the node take it over with their next start.
  void bring_out(std::uint16_t first, std::uint16_t last) noexcept;
  /// The same for all objects that show parameters of drive object @p object.
  void bring_out(std::uint8_t object) noexcept;

  bool is_home_of(const unit::ParameterPlace& place) const noexcept override {
    return contains(place.object.kind(), place.row.number);
  }
  std::optional<double> value_of(const unit::ParameterPlace& place) const noexcept override;
  /// Writes the object; AboveMaximum for what it cannot hold, and what the dictionary refuses.
  std::optional<drive::Refusal> take(const unit::ParameterPlace& place, double value) noexcept override;

 private:
  /// Some of the parameters: those of a drive object, or of all if it is 0, which are objects from `first` to
  /// `last`.
  struct Selection {
    std::uint8_t object = 0;
    std::uint16_t first = 0, last = 0xFFFF;
  };
  template <class Visit>
  void for_each_kept(const Selection& selection, const Visit& visit);
  void bring_out(const Selection& selection) noexcept;
  std::int64_t mapped(const canopen::Entry& entry) const noexcept;
  void count_mapped(const canopen::Entry& entry) noexcept;
  void write_count(const canopen::Entry& entry) noexcept;

  canopen::Dictionary& dictionary_;
  drive::DriveUnit& unit_;
};

}  // namespace device
