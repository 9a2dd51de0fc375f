#include "gateway/page/page_answer.hpp"

#include <algorithm>
#include <array>

#include "gateway/base/percent.hpp"

namespace gateway {
namespace {

using HeaderRow = std::array<const char*, 2>;
/// What the page may do: load what is of this server, and ask this server. It is shown in no frame, and no page of
/// another origin gets hold of its window or its files.
constexpr std::array kHeaders{
    HeaderRow{"Content-Security-Policy",
              "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
              "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"},
    HeaderRow{"Cross-Origin-Opener-Policy", "same-origin"},
    HeaderRow{"Cross-Origin-Resource-Policy", "same-origin"},
    HeaderRow{"Vary", "Accept-Encoding"},
};

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

/// Whether @p parameter of a coding is a weight of nothing: "q=0", "q=0.0".
bool is_no_weight(std::string_view parameter) noexcept {
  const std::string_view text = trimmed(parameter);
  return (text.starts_with("q=0") || text.starts_with("Q=0")) &&
         text.find_first_not_of("0.", 2) == std::string_view::npos;
}

bool is_named(const std::vector<std::string>& headers, std::string_view tag) {
  return std::ranges::any_of(headers, [tag](const std::string& header) {
    return std::ranges::any_of(list_of(header), [tag](std::string_view each) {
      const std::string_view named = trimmed(each);
      return named == "*" || (named.starts_with("W/") ? named.substr(2) : named) == tag;
    });
  });
}

}  // namespace

bool takes_gzip(std::string_view accept_encoding) noexcept {
  while (!accept_encoding.empty()) {
    const std::size_t end = std::min(accept_encoding.find(','), accept_encoding.size());
    const std::string_view item = accept_encoding.substr(0, end);
    accept_encoding.remove_prefix(std::min(end + 1, accept_encoding.size()));
    const std::size_t name_end = std::min(item.find(';'), item.size());
    const std::string_view name = trimmed(item.substr(0, name_end));
    const auto is_same = [](char left, char right) { return (left | ' ') == right; };
    if (!std::ranges::equal(name, std::string_view{"gzip"}, is_same)) continue;
    return name_end == item.size() || !is_no_weight(item.substr(name_end + 1));
  }
  return false;
}

Response page_answer(const Request& request, const PageFile& file, Keep keep) {
  const bool is_compressed =
      file.gzip && std::ranges::any_of(request.header("accept-encoding"),
                                       [](const std::string& accepted) { return takes_gzip(accepted); });
  const std::string& tag = is_compressed ? file.gzip_tag : file.tag;
  Response response{.content_type = std::string{file.type}};
  for (const HeaderRow& row : kHeaders) response.headers.emplace_back(row[0], row[1]);
  response.headers.emplace_back("ETag", tag);
  response.headers.emplace_back("Cache-Control",
                                keep == Keep::ForEver ? "public, max-age=31536000, immutable" : "no-cache");
  if (is_named(request.header("if-none-match"), tag)) {
    response.status = Status::NotModified;
    response.content_type.clear();
    return response;
  }
  if (is_compressed) response.headers.emplace_back("Content-Encoding", "gzip");
  response.shared_body = is_compressed ? file.gzip : file.plain;
  return response;
}

}  // namespace gateway
