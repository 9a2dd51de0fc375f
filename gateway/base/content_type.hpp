#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace gateway {

/// What a file is, by the end of its name.
struct ContentType {
  std::string_view extension;
  std::string_view type;
};
/// All that a page is made of.
inline constexpr std::array kContentTypes{ContentType{".html", "text/html; charset=utf-8"},
                                          ContentType{".js", "text/javascript; charset=utf-8"},
                                          ContentType{".css", "text/css; charset=utf-8"},
                                          ContentType{".svg", "image/svg+xml"},
                                          ContentType{".png", "image/png"},
                                          ContentType{".json", "application/json"},
                                          ContentType{".map", "application/json"},
                                          ContentType{".woff2", "font/woff2"},
                                          ContentType{".txt", "text/plain; charset=utf-8"}};

/// The type of a file called @p name; empty if it is none of a page.
[[nodiscard]] constexpr std::string_view content_type_of(std::string_view name) noexcept {
  const auto* const row = std::ranges::find_if(
      kContentTypes, [name](const ContentType& known) { return name.ends_with(known.extension); });
  return row == kContentTypes.end() ? std::string_view{} : row->type;
}

}  // namespace gateway
