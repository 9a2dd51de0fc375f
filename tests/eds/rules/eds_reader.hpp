#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace eds_test {

/// The keys and values of one section.
using Section = std::map<std::string, std::string, std::less<>>;

/// Sections by name. Written without the code under test, so that a common mistake cannot hide.
using EdsFile = std::map<std::string, Section, std::less<>>;

/// Reads an EDS strictly; throws std::runtime_error that names the line for anything but section, key=value and
/// empty lines, for trailing space, and for what stands twice.
EdsFile read_eds(std::string_view text);

/// A number of an EDS on node @p node_id; nothing where @p text is none.
std::optional<std::int64_t> number(std::string_view text, std::int64_t node_id = 0);

/// The number behind @p key of @p section; throws where there is none.
std::int64_t number_at(const Section& section, std::string_view key);

/// The section of an entry: that of the object where it is a variable, else that of the sub-index; null if absent.
const Section* find_entry(const EdsFile& file, std::uint16_t index, std::uint8_t sub_index);

/// The whole file at @p path; throws where it cannot be read.
std::string read_file(const std::string& path);

/// The EDS @p name that the build made; by default the plain one of one axis.
const EdsFile& generated_eds(const std::string& name = "axisd.eds");

}  // namespace eds_test
