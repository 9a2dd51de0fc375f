#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "tools/axisctl/connection/failure.hpp"
#include "tools/axisctl/page/page.hpp"

namespace axisctl {

/// Folder of this program: the others of the installation are there.
[[nodiscard]] std::string program_folder();
/// What the installation has at share/axisd/NAME.
[[nodiscard]] std::filesystem::path installed(std::string_view name);

/// The page without what it shows: that at @p path, the installed one if it is empty.
[[nodiscard]] Expected<std::string> read_template(const std::string& path);
/// The EDS at @p path; if it is empty, the installed one of a unit of @p profile with so many @p axes, or nothing
/// if there is none.
[[nodiscard]] Expected<std::string> read_eds(const std::string& path, std::string_view profile, std::size_t axes);

/// Largest page (bytes): more than browsers like.
inline constexpr std::size_t kLargestPage = 64'000'000;
/// Puts @p page into @p blank and that to @p path, where it is whole or not at all.
[[nodiscard]] Expected<void> write_page(const std::string& path, std::string blank, const Page& page);

/// Whether the folder of @p path is there, asked before work is done for it.
[[nodiscard]] Expected<void> check_folder_of(const std::string& path);
/// Writes @p content to the regular file @p path, made if it is not there: it has all of it or what it had.
[[nodiscard]] Expected<void> write_whole(const std::string& path, std::string_view content);

}  // namespace axisctl
