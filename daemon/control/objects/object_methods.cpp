// Objects of the dictionary, as the default SDO server shows them.
#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "daemon/control/handlers.hpp"
#include "daemon/control/objects/object_address.hpp"
#include "daemon/control/objects/object_value.hpp"
#include "daemon/control/parameters/parameter_value.hpp"
#include "daemon/control/parameters/parameter_write.hpp"
#include "daemon/control/place.hpp"
#include "daemon/instance/instance.hpp"
#include "device/objects/abort_codes.hpp"

namespace axisd {
namespace {

using canopen::AbortCode;
using control::ErrorCode;
using nlohmann::json;

constexpr std::uint8_t kDefaultServer = 0;
constexpr std::int64_t kMostEntries = 200;
constexpr std::int64_t kLastPlace = 1'000'000;

tl::unexpected<control::Error> refused(AbortCode code, const ObjectAddress& address) {
  return tl::unexpected{refusal_of(code, address)};
}

/// What an address means: an entry of the dictionary or a parameter of the window 2000h to 470Fh.
struct Meaning {
  ObjectAddress address;
  const canopen::Entry* entry = nullptr;
  std::optional<ParameterTarget> parameter{};
};

Taken<ParameterTarget> target_of(drive::DriveUnit& unit, const device::ParameterWindow::Target& wanted,
                                 const ObjectAddress& address) {
  drive::DriveObject* const object = unit.object(wanted.object);
  if (object == nullptr) return refused(AbortCode::NoObject, address);
  const auto placed = object->parameter(wanted.number, wanted.index);
  if (!placed) return refused(device::abort_code(placed.error().reason), address);
  return ParameterTarget{object, *placed, wanted.index, {}};
}

Taken<Meaning> meaning_of(const Call& call, const json& params) {
  const auto address = object_address(params);
  if (!address) return tl::unexpected{address.error()};
  device::Device& device = call.instance.device();
  Meaning meaning{.address = *address};
  if (const auto wanted = device.parameter_at(kDefaultServer, address->index, address->sub_index)) {
    const auto target = target_of(device.runner().unit(), *wanted, *address);
    if (!target) return tl::unexpected{target.error()};
    meaning.parameter = *target;
    return meaning;
  }
  const auto found = device.dictionary().find(address->index, address->sub_index);
  if (!found) return refused(found.error(), *address);
  meaning.entry = *found;
  return meaning;
}

/// The type in which a parameter travels.
canopen::DataType type_of(drive::DataType type) noexcept {
  using canopen::DataType;
  constexpr std::array kTypes{DataType::Integer8,   DataType::Unsigned8,  DataType::Integer16,
                              DataType::Unsigned16, DataType::Integer32,  DataType::Unsigned32,
                              DataType::Real32,     DataType::Unsigned32, DataType::Unsigned32};
  static_assert(kTypes.size() == drive::kDataTypes.size());
  return kTypes[static_cast<std::size_t>(type)];
}

json identity(const ObjectAddress& address, std::string_view name, canopen::DataType type,
              std::string_view access) {
  return {{"object", address_text(address)}, {"index", address.index},
          {"sub_index", address.sub_index},  {"name", name},
          {"type", type_text(type)},         {"access", access}};
}

/// What is known of @p entry without its value.
json entry_json(const canopen::Entry& entry) {
  const canopen::EntryDescription& row = *entry.description;
  json told = identity({entry.index, entry.sub_index}, row.name, row.type, access_text(row.access));
  told["mappable"] = entry.receive_mappable || entry.transmit_mappable;
  return told;
}

Outcome value_of(const Call& call, const Meaning& meaning) {
  const canopen::Entry& entry = *meaning.entry;
  const canopen::EntryDescription& row = *entry.description;
  const canopen::Dictionary& dictionary = call.instance.device().dictionary();
  json told = entry_json(entry);
  if (row.low) told["minimum"] = number_json(row.type, *row.low);
  if (row.high) told["maximum"] = number_json(row.type, *row.high);
  if (entry.size != 0) {
    const auto number = dictionary.read(entry);
    if (!number) return refused(number.error(), meaning.address);
    told["value"] = number_json(row.type, *number);
    return told;
  }
  if (entry.domain != nullptr) return refused(AbortCode::UnsupportedAccess, meaning.address);
  const auto text = dictionary.read_text(entry);
  if (!text) return refused(text.error(), meaning.address);
  told["value"] = text_json(row.type, *text);
  return told;
}

/// A parameter as it travels: of a BICO input its number.
json parameter_json(const drive::DriveUnit& unit, const Meaning& meaning) {
  const ParameterTarget& target = *meaning.parameter;
  const drive::ParameterRow& row = target.row();
  const canopen::DataType type = type_of(row.type);
  json told = identity(meaning.address, row.name, type, row.is_writable() ? "rw" : "ro");
  told["mappable"] = false;
  told["axis"] = place_of(*target.object);
  told["parameter"] = parameter_text(target);
  const auto value = unit.read(target.object->number(), row.number, target.index);
  if (!value) return told;
  told["value"] = drive::is_bico_input(row.type) ? json(value->bits) : value_json(row, *value, *target.object);
  return told;
}

Outcome told_of(const Call& call, const Meaning& meaning) {
  call.instance.device().tell_time(call.now);
  if (meaning.parameter) return parameter_json(call.instance.device().unit(), meaning);
  return value_of(call, meaning);
}

Outcome read_object(const Call& call, const json& params) {
  const auto meaning = meaning_of(call, params);
  if (!meaning) return tl::unexpected{meaning.error()};
  return told_of(call, *meaning);
}

void tell_write(const Call& call, const ObjectAddress& address, double value, std::optional<double> before) {
  EventWatch& events = call.instance.events();
  if (events.is_watched()) events.on_object_written(address.index, address.sub_index, value, before, call.now);
}

Taken<void> write_entry(const Call& call, const Meaning& meaning, const json& value) {
  const canopen::Entry& entry = *meaning.entry;
  device::Device& device = call.instance.device();
  if (!device.is_on()) return tl::unexpected{unit_is_off()};
  if (!entry.writable) return refused(AbortCode::ReadOnly, meaning.address);
  if (entry.domain != nullptr) return refused(AbortCode::UnsupportedAccess, meaning.address);
  const canopen::DataType type = entry.description->type;
  if (entry.size == 0) {
    const auto text = text_from(type, value);
    if (!text) return tl::unexpected{text.error()};
    const auto written = device.write_object(entry, std::span<const std::uint8_t>{*text}, call.now);
    return written ? Taken<void>{} : refused(written.error(), meaning.address);
  }
  const auto number = number_from(type, value);
  if (!number) return tl::unexpected{number.error()};
  const auto before = device.dictionary().stored(entry);
  const auto written = device.write_object(entry, *number, call.now);
  if (written) {
    tell_write(call, meaning.address, number_json(type, *number), number_json(type, before));
    return {};
  }
  control::Error error = refusal_of(written.error(), meaning.address);
  const auto& row = *entry.description;
  if (error.code == ErrorCode::OutOfRange && row.low && row.high)
    error.details["limits"] = {{"minimum", number_json(type, *row.low)},
                               {"maximum", number_json(type, *row.high)}};
  return tl::unexpected{std::move(error)};
}

Taken<void> write_parameter_object(const Call& call, const Meaning& meaning, const json& value) {
  const ParameterTarget& target = *meaning.parameter;
  if (!target.row().is_writable()) return refused(AbortCode::ReadOnly, meaning.address);
  const auto number = number_of(call.instance.device().unit(), target, value);
  if (!number) return tl::unexpected{number.error()};
  return write_and_tell(call, target, *number);
}

Outcome write_object(const Call& call, const json& params) {
  const auto meaning = meaning_of(call, params);
  if (!meaning) return tl::unexpected{meaning.error()};
  const json* const value = Arguments{params}.find("value");
  if (value == nullptr) return tl::unexpected{unexpected_value("value", "a number or a text", nullptr)};
  const auto written =
      meaning->parameter ? write_parameter_object(call, *meaning, *value) : write_entry(call, *meaning, *value);
  if (!written) return tl::unexpected{written.error()};
  auto told = told_of(call, *meaning);
  return told ? told : Outcome{json::object()};  // what can only be written
}

constexpr char lower(char letter) noexcept {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}
std::string lowered(std::string_view text) {
  std::string result{text};
  std::ranges::transform(result, result.begin(), lower);
  return result;
}

/// Whether @p text, in lower case, is the beginning of the index of @p entry or a part of its name.
bool is_meant(const canopen::Entry& entry, const std::string& text) {
  return lowered(fmt::format("{:04x}", entry.index)).starts_with(text) ||
         lowered(entry.description->name).find(text) != std::string::npos;
}

Outcome list_objects(const Call& call, const json& params) {
  const Arguments arguments{params};
  const auto page = arguments.page({.last = kLastPlace, .most = kMostEntries, .usual = kMostEntries});
  if (!page) return tl::unexpected{page.error()};
  const auto text = arguments.text("text", "");
  if (!text) return tl::unexpected{text.error()};
  const std::string wanted = lowered(*text);
  const auto entries = call.instance.device().dictionary().entries();
  json list = json::array();
  std::size_t at = std::min(page->from, entries.size());
  for (; at < entries.size() && list.size() < page->count; ++at)
    if (is_meant(entries[at], wanted)) list.push_back(entry_json(entries[at]));
  json result{{"objects", std::move(list)}, {"total", entries.size()}};
  if (at < entries.size()) result["next"] = at;
  return result;
}

constexpr std::array kObjectHandlers{
    Handler{"object.read", &read_object},
    Handler{"object.write", &write_object},
    Handler{"object.list", &list_objects},
};

}  // namespace

std::span<const Handler> object_handlers() noexcept {
  return kObjectHandlers;
}

}  // namespace axisd
