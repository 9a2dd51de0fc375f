#include "gateway/page/page_files.hpp"

#include <span>

#include <fmt/format.h>

#include "checksum/crc32.hpp"
#include "gateway/base/content_type.hpp"
#include "os/folder.hpp"
#include "os/regular_file.hpp"

namespace gateway {
namespace {

namespace fs = std::filesystem;

PageFile::Text text_of(const fs::path& path) {
  auto text = os::read_regular_file(path.string(), PageFiles::kLargest);
  return text ? std::make_shared<const std::string>(*std::move(text)) : nullptr;
}

std::string tag_of(const PageFile::Text& text, std::string_view coding) {
  if (!text) return {};
  const std::uint32_t sum = checksum::crc32(std::as_bytes(std::span{*text}));
  return fmt::format("\"{:08x}-{:x}{}\"", sum, text->size(), coding);
}

PageFile file_at(const fs::path& path, std::string_view type) {
  PageFile file{.type = type, .plain = text_of(path)};
  if (!file.plain) return {};
  file.gzip = text_of(path.string() + ".gz");
  file.tag = tag_of(file.plain, "");
  file.gzip_tag = tag_of(file.gzip, "-gzip");
  return file;
}

}  // namespace

PageFiles::PageFiles(const fs::path& folder) : start_{file_at(folder / "index.html", content_type_of(".html"))} {
  if (!start_.plain) return;
  const fs::path assets = folder / "assets";
  for (const std::string& name : os::names_in(assets.string())) {
    const std::string_view type = content_type_of(name);
    if (type.empty() || assets_.size() >= kMost) continue;
    if (PageFile file = file_at(assets / name, type); file.plain) assets_.emplace(name, std::move(file));
  }
}

const PageFile* PageFiles::asset(std::string_view name) const noexcept {
  const auto found = assets_.find(name);
  return found == assets_.end() ? nullptr : &found->second;
}

}  // namespace gateway
