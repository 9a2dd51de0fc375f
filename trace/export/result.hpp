#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace trace {

/// A result of a trace as it is exported. Times are seconds since the start of the unit.
struct Result {
  struct Signal {
    std::string name{};  ///< "1/speed"
    std::string unit{};  ///< "rpm", empty: none
    std::string text{};  ///< what it is
  };
  struct Sample {
    double t = 0.0;
    std::vector<double> values{};  ///< one a signal; not a number: there was none
  };
  struct Frame {
    double t = 0.0;
    std::uint32_t id = 0;
    bool sent = false;  ///< by the unit
    bool extended = false;
    bool remote = false;
    std::string data{};  ///< hexadecimal digits
  };
  struct Event {
    double t = 0.0;
    std::string kind{};   ///< "fault", "drive-state", "nmt", "parameter", ...
    std::string place{};  ///< "0" = control unit, "1".. = axis, "infeed"
    std::string text{};
    bool active = true;  ///< it has come; false: it has gone
    std::optional<int> number{};
    std::optional<int> index{};
    std::optional<double> value{};
  };

  std::vector<Signal> signals{};
  std::vector<Sample> samples{};
  std::vector<Frame> frames{};
  std::vector<Event> events{};
  std::optional<double> trigger{};  ///< when it began
  std::size_t lost_frames = 0;
};

}  // namespace trace
