#include "trace/export/svg_writer.hpp"

#include <array>

#include <fmt/format.h>

namespace trace {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '&':
        result += "&amp;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += letter;
    }
  }
  return result;
}

}  // namespace

std::string coordinate(double value) {
  return fmt::format("{:.1f}", value);
}

SvgWriter::SvgWriter(double width, double height)
    : text_{fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
                        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\" font-size=\"12\">\n"
                        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
                        width, height)} {}

void SvgWriter::rectangle(double x, double y, double width, double height, std::string_view style) {
  text_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", x, y, width,
                       height, style);
}

void SvgWriter::line(double x1, double y1, double x2, double y2, std::string_view style) {
  text_ +=
      fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" {}/>\n", x1, y1, x2, y2, style);
}

void SvgWriter::path(std::string_view data, std::string_view style) {
  if (data.empty()) return;
  text_ += fmt::format("<path d=\"{}\" {}/>\n", data, style);
}

void SvgWriter::text(double x, double y, std::string_view text, Anchor anchor, std::string_view style) {
  constexpr std::array<std::string_view, 3> kAnchors{"start", "middle", "end"};
  text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y,
                       kAnchors[static_cast<std::size_t>(anchor)], style, escaped(text));
}

std::string SvgWriter::picture() && {
  return std::move(text_) + "</svg>\n";
}

}  // namespace trace
