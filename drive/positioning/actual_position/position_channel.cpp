#include "drive/positioning/actual_position/position_channel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "drive/positioning/actual_position/whole_numbers.hpp"

namespace drive {

void PositionChannel::follow(const ChannelInputs& inputs, std::int64_t sensed) noexcept {
  wired_ = whole_units(inputs.offset);
  const std::int64_t by = whole_units(inputs.correction);
  const bool corrected = std::exchange(corrects_, inputs.correct);
  const bool corrected_negatively = std::exchange(corrects_negatively_, inputs.correct_negatively);
  if (corrects_ && !corrected) shift(by);
  if (corrects_negatively_ && !corrected_negatively) shift(-by);
  held_ = inputs.set_position;
  if (held_) offset_ = whole_units(inputs.setting_value) - sensed - wired_;
}

}  // namespace drive
