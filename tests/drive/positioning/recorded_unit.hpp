#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/drive/positioning/positioning_unit.hpp"
#include "tests/motor/reference/reference_file.hpp"

namespace drive {

/// A unit that is led by orders at whole milliseconds; its setpoint (r2665, r2666) is written down where a
/// reference has rows.
class RecordedUnit {
 public:
  RecordedUnit(std::string_view name, PositioningUnit& unit) : file{name}, unit_{unit} {}

  /// Writes the parameters of the reference to the axis.
  void set_parameters() {
    for (const auto& [name, value] : file.about.at("parameters").items())
      unit_.set(static_cast<std::uint16_t>(std::stoi(name.substr(1))), value.get<double>());
  }
  double stimulus(const std::string& name) const { return file.number("/stimulus/" + name); }
  /// At @p time (s, whole milliseconds) do @p order.
  void at(double time, std::function<void()> order) { orders_.emplace_back(milliseconds(time), std::move(order)); }
  /// Input @p input becomes @p value at @p time (s).
  void set_at(double time, std::uint16_t input, double value) {
    at(time, [this, input, value] { unit_.set(input, value); });
  }
  /// To the last row of the reference.
  void run() {
    const std::vector<double>& times = file.table.abscissa();
    std::size_t row = 0;
    for (std::int64_t now = 0; now <= milliseconds(times.back()); ++now) {
      if (milliseconds(times[row]) == now) append(times[row++]);
      for (const auto& [instant, order] : orders_)
        if (instant == now) order();
      unit_.run(1);
    }
  }
  void expect_agreement() const { reference::expect_agreement(file, ours, reference::Band::Must); }

  reference::File file;
  reference::Table ours{{"t_s", "pos"}};
  double turned = 0.0;  ///< whole turns that the setpoint has left behind (LU)

 private:
  static std::int64_t milliseconds(double time) { return std::lround(time / PositioningUnit::kMillisecond); }
  void append(double time) { ours.append({time, unit_.read(2665) + turned}); }

  PositioningUnit& unit_;
  std::vector<std::pair<std::int64_t, std::function<void()>>> orders_;
};

}  // namespace drive
