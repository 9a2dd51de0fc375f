#pragma once

#include <string>
#include <vector>

namespace trace {

/// A linear scale from values to places in a picture, with ticks at round values.
class Scale {
 public:
  /// Values @p low..@p high (low < high) go to places @p from..@p to.
  Scale(double low, double high, double from, double to) noexcept
      : low_{low}, from_{from}, factor_{(to - from) / (high - low)}, high_{high} {}
  /// The same for what lies between @p low and @p high, of which there may be nothing, with some room and a round
  /// value at either end.
  static Scale around(double low, double high, double from, double to) noexcept;

  double place(double value) const noexcept { return from_ + (value - low_) * factor_; }
  double low() const noexcept { return low_; }
  double high() const noexcept { return high_; }
  /// Round values (1, 2 or 5 times a power of ten apart), about @p count of them.
  std::vector<double> ticks(int count) const;

 private:
  double low_;
  double from_;
  double factor_;
  double high_;
};

/// A distance of 1, 2 or 5 times a power of ten, about the @p count th part of @p span (positive).
double round_step(double span, int count) noexcept;

/// @p value for a tick, without digits that the distance @p step of ticks does not need.
std::string tick_text(double value, double step);

}  // namespace trace
