#include "eds/sheet/section_name.hpp"

#include <array>
#include <optional>

#include <fmt/format.h>

#include "eds/document/encoding.hpp"
#include "text/number.hpp"

namespace eds {
namespace {

struct KnownName {
  std::string_view name;
  SectionKind kind;
};

constexpr std::array kSections{
    KnownName{"FileInfo", SectionKind::FileInfo},
    KnownName{"DeviceInfo", SectionKind::DeviceInfo},
    KnownName{"DummyUsage", SectionKind::DummyUsage},
    KnownName{"Comments", SectionKind::Comments},
    KnownName{"MandatoryObjects", SectionKind::MandatoryObjects},
    KnownName{"OptionalObjects", SectionKind::OptionalObjects},
    KnownName{"ManufacturerObjects", SectionKind::ManufacturerObjects},
    KnownName{"DynamicChannels", SectionKind::DynamicChannels},
    KnownName{"Tools", SectionKind::Tools},
    KnownName{"SupportedModules", SectionKind::SupportedModules},
    KnownName{"ConnectedModules", SectionKind::ConnectedModules},
    KnownName{"DeviceComissioning", SectionKind::DeviceCommissioning},
    KnownName{"DeviceCommissioning", SectionKind::DeviceCommissioning},
};
constexpr std::array kModuleSections{
    KnownName{"ModuleInfo", SectionKind::ModuleInfo},
    KnownName{"Comments", SectionKind::Comments},
    KnownName{"FixedObjects", SectionKind::FixedObjects},
    KnownName{"SubExtends", SectionKind::SubExtends},
};
constexpr std::array kObjectSections{
    KnownName{"", SectionKind::Object},
    KnownName{"Name", SectionKind::Names},
    KnownName{"Value", SectionKind::Values},
    KnownName{"Denotation", SectionKind::Denotations},
    KnownName{"ObjectLinks", SectionKind::ObjectLinks},
};

template <std::size_t N>
SectionKind known(const std::array<KnownName, N>& names, std::string_view name) noexcept {
  for (const KnownName& row : names)
    if (equal_in_any_case(row.name, name)) return row.kind;
  return SectionKind::Unknown;
}

/// Takes a number of @p least to @p most digits off @p text.
std::optional<std::uint16_t> take_digits(std::string_view& text, int base, std::size_t least, std::size_t most) {
  std::string_view digits = text.substr(0, most);
  const std::size_t offered = digits.size();
  const auto value = text::take_integer<std::uint16_t>(digits, base);
  const std::size_t length = offered - digits.size();
  if (!value || length < least) return std::nullopt;
  text.remove_prefix(length);
  return value;
}

SectionName parse_object(std::string_view name, unsigned module) noexcept {
  const auto index = take_digits(name, 16, 4, 4);
  if (!index) return {};
  SectionName result{.kind = known(kObjectSections, name), .module = module, .index = *index};
  if (!take_in_any_case(name, "sub")) return result.kind == SectionKind::Unknown ? SectionName{} : result;
  const auto sub_index = take_digits(name, 16, 1, 4);
  if (!sub_index || !name.empty() || *sub_index > 0xFF) return {};
  result.kind = SectionKind::SubObject;
  result.sub_index = static_cast<std::uint8_t>(*sub_index);
  return result;
}

SectionName parse_module(std::string_view name) noexcept {
  const auto module = take_digits(name, 10, 1, 4);
  if (!module || *module == 0) return {};
  const SectionKind kind = known(kModuleSections, name);
  if (kind != SectionKind::Unknown) return {.kind = kind, .module = *module};
  if (take_in_any_case(name, "Fixed")) return parse_object(name, *module);
  if (!take_in_any_case(name, "SubExt")) return {};
  SectionName result = parse_object(name, *module);
  if (result.kind != SectionKind::Object) return {};
  result.kind = SectionKind::SubExtension;
  return result;
}

}  // namespace

SectionName parse_section_name(std::string_view name) noexcept {
  if (const SectionKind kind = known(kSections, name); kind != SectionKind::Unknown) return {.kind = kind};
  std::string_view rest = name;
  if (take_in_any_case(rest, "Tool"))
    return {.kind = take_digits(rest, 10, 1, 4) && rest.empty() ? SectionKind::Tool : SectionKind::Unknown};
  if (take_in_any_case(rest, "M")) return parse_module(rest);
  return parse_object(name, 0);
}

std::string object_section(unsigned module, std::uint16_t index) {
  return module == 0 ? fmt::format("{:04X}", index) : fmt::format("M{}Fixed{:04X}", module, index);
}

std::string entry_section(unsigned module, std::uint16_t index, std::uint8_t sub_index) {
  return fmt::format("{}sub{:X}", object_section(module, index), sub_index);
}

}  // namespace eds
