#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace gateway {

/// A file of the page, in memory.
struct PageFile {
  using Text = std::shared_ptr<const std::string>;

  std::string_view type;  ///< its content type
  Text plain;
  Text gzip{};        ///< the same, compressed; nullptr: there is none
  std::string tag{};  ///< its ETag, quotes included
  std::string gzip_tag{};
};

/// The web page as it was built: `index.html`, and below `assets` what that loads, whose names change with what is
/// in it. NAME.gz beside NAME is the same, compressed. All is read at once; what is asked for is looked up in
/// memory, so that no request leads to a file.
class PageFiles {
 public:
  /// Largest file that is read (bytes), and most of them.
  static constexpr std::size_t kLargest = 16UL * 1024 * 1024;
  static constexpr std::size_t kMost = 1000;

  /// No page.
  PageFiles() = default;
  /// What there is in @p folder; no page if that has no `index.html` that can be read.
  explicit PageFiles(const std::filesystem::path& folder);

  /// `index.html`; nullptr: there is no page.
  [[nodiscard]] const PageFile* start() const noexcept { return start_.plain ? &start_ : nullptr; }
  /// The file @p name of `assets`; nullptr if there is none.
  [[nodiscard]] const PageFile* asset(std::string_view name) const noexcept;

 private:
  PageFile start_{};
  std::map<std::string, PageFile, std::less<>> assets_;
};

}  // namespace gateway
