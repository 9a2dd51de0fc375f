#pragma once

#include <string>
#include <string_view>

namespace trace {

/// Where a text is put, relative to its place.
enum class Anchor { Start, Middle, End };

/// Writes the elements of an SVG picture, one after the other; lengths in pixels.
class SvgWriter {
 public:
  SvgWriter(double width, double height);

  void rectangle(double x, double y, double width, double height, std::string_view style);
  void line(double x1, double y1, double x2, double y2, std::string_view style);
  /// @p data as the path element has it.
  void path(std::string_view data, std::string_view style);
  void text(double x, double y, std::string_view text, Anchor anchor = Anchor::Start, std::string_view style = {});
  /// The picture; nothing is to be written after that.
  std::string picture() &&;

 private:
  std::string text_;
};

/// @p value as a coordinate, to a tenth of a pixel.
std::string coordinate(double value);

}  // namespace trace
