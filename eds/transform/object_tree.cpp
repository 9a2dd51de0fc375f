#include "eds/transform/object_tree.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include <fmt/format.h>

namespace eds {
namespace {

struct CodeWord {
  ObjectCode code;
  std::string_view word;
};
constexpr std::array kCodes{
    CodeWord{ObjectCode::Null, "NULL"},       CodeWord{ObjectCode::Domain, "DOMAIN"},
    CodeWord{ObjectCode::DefType, "DEFTYPE"}, CodeWord{ObjectCode::DefStruct, "DEFSTRUCT"},
    CodeWord{ObjectCode::Variable, "VAR"},    CodeWord{ObjectCode::Array, "ARRAY"},
    CodeWord{ObjectCode::Record, "RECORD"},
};

class Tree {
 public:
  void device(const DataSheet& sheet) {
    const DeviceInfo& info = sheet.device_info;
    add("{} of {}, vendor {}, product {}, revision {}\n", text(info.product_name), text(info.vendor_name),
        number(info.vendor_number), number(info.product_number), number(info.revision_number));
    std::string rates;
    for (std::size_t n = 0; n < kBitRates.size(); ++n)
      if (info.bit_rates[n].value_or(false)) rates += fmt::format(" {}", kBitRates[n]);
    add("{} RPDOs, {} TPDOs, bit rates{} kbit/s, LSS: {}\n", info.rpdo_count.value_or(0),
        info.tpdo_count.value_or(0), rates.empty() ? " none of" : rates,
        info.lss_supported.value_or(false) ? "yes" : "no");
    if (!sheet.is_configuration()) return;
    add("node {} ({}), {} kbit/s\n", sheet.commissioning.node_id.value_or(0), text(sheet.commissioning.node_name),
        sheet.commissioning.bit_rate.value_or(0));
  }

  void objects(const SheetObjects& objects) {
    for (const auto& [index, object] : objects) {
      if (!object.has_subs && object.entries.size() == 1) {
        entry(fmt::format("{:04X}h", index), object.entries.front());
        continue;
      }
      add("{:04X}h  {:<15} {}\n", index, word_of(object.code()), printable(object.name));
      for (const SheetEntry& each : object.entries) entry(fmt::format("  :{:02X}", each.sub_index), each);
    }
  }

  void modules(const DataSheet& sheet) {
    for (const auto& [number, module] : sheet.modules) {
      add("\nmodule {}: {}\n", number, module.info == nullptr ? "" : printable(module.info->value("ProductName")));
      objects(module.objects);
      for (const auto& [index, extension] : module.extensions)
        add("{:04X}h  + {} {}\n", index, text(extension.count), printable(extension.entry.name));
    }
  }

  std::string take() { return std::move(text_); }

 private:
  template <class... Values>
  void add(fmt::format_string<Values...> form, Values&&... values) {
    fmt::format_to(std::back_inserter(text_), form, std::forward<Values>(values)...);
  }

  template <class T>
  static std::string text(const Stated<T>& stated) {
    return stated.stated() ? printable(stated.text()) : "?";
  }

  static std::string number(const Stated<std::uint64_t>& stated) {
    return stated ? fmt::format("{:08X}h", *stated) : "?";
  }

  void entry(const std::string& place, const SheetEntry& each) {
    add("{:<6} {:<15} {:<5} {} {}", place, each.type != nullptr ? each.type->name : text(each.data_type),
        name_of(kAccesses, each.access_or_default()).text, each.mappable.value_or(false) ? "PDO" : "   ",
        printable(each.name));
    if (each.parameter_value.stated()) {
      add(" = {} (DCF)", text(each.parameter_value));
    } else if (each.default_value) {
      add(" = {}", each.default_value.stated() ? text(each.default_value) : to_text(each.default_value->integer));
    }
    if (each.low.stated() || each.high.stated())
      add(" ({}..{})", each.low.stated() ? text(each.low) : "", each.high.stated() ? text(each.high) : "");
    text_ += '\n';
  }

  std::string text_;
};

}  // namespace

std::string_view word_of(ObjectCode code) noexcept {
  const auto* const row = std::ranges::find(kCodes, code, &CodeWord::code);
  return row == kCodes.end() ? "?" : row->word;
}

std::string write_tree(const DataSheet& sheet) {
  Tree tree;
  tree.device(sheet);
  tree.objects(sheet.objects);
  tree.modules(sheet);
  return tree.take();
}

}  // namespace eds
