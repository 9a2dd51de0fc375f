#include "device/process_data/process_data_parameters.hpp"

#include <array>

#include "device/objects/abort_codes.hpp"
#include "device/objects/object_index.hpp"

namespace device {
namespace {

constexpr std::uint16_t kTakeOver = 8741;
constexpr std::uint16_t kRemaining = 8742;
constexpr std::uint16_t kConnectControlword = 8790;

struct Numbers {
  std::uint16_t first, last;
};
constexpr std::array kAnswered{
    Numbers{kTakeOver, kRemaining},
    Numbers{8750, 8751},
    Numbers{8760, 8761},
    Numbers{8790, 8790},
    Numbers{8867, 8867},
};

constexpr std::array kRemainingOf{pdo::Direction::Receive, pdo::Direction::Transmit};

}  // namespace

ProcessDataParameters::ProcessDataParameters(const std::deque<ProcessDataBuffers>& buffers,
                                             std::deque<StandardWiring>& wiring, PdoRules& rules,
                                             unit::UnitParameters& parameters)
    : buffers_{buffers}, wiring_{wiring}, rules_{rules} {
  for (const Numbers& numbers : kAnswered) parameters.answer(numbers.first, numbers.last, *this);
}

std::optional<double> ProcessDataParameters::value_of(const unit::ParameterPlace& place) const noexcept {
  if (place.row.number == kRemaining) return static_cast<double>(rules_.remaining(kRemainingOf[place.index]));
  const std::size_t module = place.object.context().module;
  const bool of_axis = place.object.kind() != drive::ObjectKind::ControlUnit && module < buffers_.size();
  return of_axis ? buffers_[module].value_of(place.row.number, place.index) : std::nullopt;
}

std::optional<drive::Refusal> ProcessDataParameters::take(const unit::ParameterPlace& place,
                                                          double value) noexcept {
  const std::size_t module = place.object.context().module;
  if (!(value > 0.0)) return {};
  if (place.row.number == kTakeOver) return refusal(rules_.take_over(module + 1));
  return place.row.number == kConnectControlword ? connect_controlword(module) : std::nullopt;
}

std::optional<drive::Refusal> ProcessDataParameters::connect_controlword(std::size_t module) noexcept {
  constexpr std::size_t kMostPlaces = 4;
  const ProcessDataLayout::Item* const place =
      buffers_[module].received().find(object::on_axis(object::kControlword, module + 1));
  const bool reachable = place != nullptr && place->first < kMostPlaces;
  if (!reachable) return drive::Refusal::NotNow;
  wiring_[module].connect_controlword();
  return {};
}

}  // namespace device
