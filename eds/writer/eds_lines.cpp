#include "eds/writer/eds_lines.hpp"

namespace eds {

void write_entry(Lines& lines, const Entry& entry) {
  lines.add("ParameterName", entry.name);
  lines.add("ObjectType", "0x7");
  lines.add("DataType", fmt::format("0x{:04X}", static_cast<unsigned>(entry.type)));
  if (entry.low) lines.add("LowLimit", entry.low->text);
  if (entry.high) lines.add("HighLimit", entry.high->text);
  lines.add("AccessType", name_of(kAccesses, entry.access).text);
  if (entry.default_stated) lines.add("DefaultValue", entry.initial.text);
  lines.add("PDOMapping", entry.pdo_mappable ? 1 : 0);
  if (entry.object_flags) lines.add("ObjFlags", fmt::format("0x{:X}", *entry.object_flags));
}

void write_index_list(Lines& lines, std::string_view name, std::string_view count_key,
                      std::span<const Object* const> objects) {
  lines.section(name);
  lines.add(count_key, objects.size());
  for (std::size_t n = 0; n < objects.size(); ++n)
    lines.add(fmt::format("{}", n + 1), fmt::format("0x{:04X}", objects[n]->index));
}

void write_object(Lines& lines, std::string_view prefix, const Object& object) {
  lines.section(fmt::format("{}{:04X}", prefix, object.index));
  if (object.code == ObjectCode::Variable) return write_entry(lines, object.entries.front());
  lines.add("ParameterName", object.name);
  lines.add("ObjectType", fmt::format("0x{:X}", static_cast<unsigned>(object.code)));
  lines.add("SubNumber", fmt::format("0x{:X}", object.entries.size()));
  for (const Entry& entry : object.entries) {
    lines.section(fmt::format("{}{:04X}sub{:X}", prefix, object.index, entry.sub_index));
    write_entry(lines, entry);
  }
}

}  // namespace eds
