// Many parameters: lists, search, differences, all in pages.
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "daemon/control/handlers.hpp"
#include "daemon/control/parameters/parameter_sequence.hpp"
#include "daemon/control/parameters/parameter_view.hpp"
#include "daemon/control/parameters/search_text.hpp"
#include "daemon/control/place.hpp"

namespace axisd {
namespace {

using nlohmann::json;

/// Entries of a page: what a line has room for.
constexpr std::int64_t kMostEntries = 32;
constexpr std::int64_t kMostDifferences = 200;
/// Values that are looked at for one page, so that it takes a fraction of a cycle.
constexpr std::size_t kMostLookedAt = 2000;
constexpr std::int64_t kLastPlace = 1'000'000;

Taken<Page> page_of(const json& params, std::int64_t most) {
  return Arguments{params}.page({.last = kLastPlace, .most = most, .usual = most});
}

/// The entries of @p page of @p sequence that @p chosen chooses, as @p told; with "next" if there may be more.
template <class Chosen, class Told>
json paged(const ParameterSequence& sequence, const Page& page, const Chosen& chosen, const Told& told) {
  json entries = json::array();
  std::optional<std::size_t> next;
  std::size_t looked_at = 0;
  sequence.visit(page.from, [&](const ParameterSequence::Item& item, std::size_t place) {
    if (entries.size() == page.count || looked_at == kMostLookedAt) {
      next = place;
      return false;
    }
    ++looked_at;
    if (chosen(item)) entries.push_back(told(item));
    return true;
  });
  json result{{"parameters", std::move(entries)}, {"total", sequence.size()}};
  if (next) result["next"] = *next;
  return result;
}

using Chosen = bool (*)(const ParameterView& view, const ParameterSequence::Item& item) noexcept;

bool all(const ParameterView&, const ParameterSequence::Item&) noexcept {
  return true;
}
template <Reference To>
bool differs(const ParameterView& view, const ParameterSequence::Item& item) noexcept {
  return view.differs(item.object, item.placed, item.index, To);
}
bool can_be_written(const ParameterView&, const ParameterSequence::Item& item) noexcept {
  return !item.object.state_refusal(*item.placed.row);
}
bool is_input(const ParameterView&, const ParameterSequence::Item& item) noexcept {
  return drive::is_bico_input(item.placed.row->type);
}
bool is_output(const ParameterView&, const ParameterSequence::Item& item) noexcept {
  return item.placed.row->output != drive::Output::No;
}

constexpr std::array<std::string_view, 6> kFilters{"all", "changed", "unsaved", "writable", "inputs", "outputs"};
constexpr std::array<Chosen, 6> kChosen{
    &all, &differs<Reference::Factory>, &differs<Reference::Stored>, &can_be_written, &is_input, &is_output};

Outcome list_parameters(const Call& call, const json& params) {
  const auto object = required_place(unit_of(call), params);
  if (!object) return tl::unexpected{object.error()};
  const auto filter = Arguments{params}.choice("filter", kFilters, 0);
  if (!filter) return tl::unexpected{filter.error()};
  const auto page = page_of(params, kMostEntries);
  if (!page) return tl::unexpected{page.error()};
  call.instance.device().tell_time(call.now);
  const ParameterView view{call.instance};
  return paged(
      {unit_of(call), *object}, *page,
      [&](const ParameterSequence::Item& item) { return kChosen[*filter](view, item); },
      [&](const ParameterSequence::Item& item) { return view.entry(item.object, item.placed, item.index); });
}

/// The parameters of one drive object that @p text finds, index 0 of each.
json search_object(const Call& call, const drive::DriveObject& object, const SearchText& text, const Page& page) {
  call.instance.device().tell_time(call.now);
  const ParameterView view{call.instance};
  return paged(
      {unit_of(call), &object}, page,
      [&](const ParameterSequence::Item& item) { return item.index == 0 && text.finds(*item.placed.row); },
      [&](const ParameterSequence::Item& item) { return view.entry(item.object, item.placed, item.index); });
}

/// The drive objects of @p unit that have @p row.
json owners_of(const drive::DriveUnit& unit, const drive::ParameterRow& row) {
  json places = json::array();
  unit.for_each_object([&](const drive::DriveObject& object) {
    const auto found = object.parameter(row.number);
    if (found && (*found)->row == &row) places.push_back(place_of(object));
  });
  return places;
}

/// The parameters of all drive objects that @p text finds, each once.
json search_unit(const drive::DriveUnit& unit, const SearchText& text, const Page& page) {
  const auto rows = drive::parameter_rows();
  json entries = json::array();
  std::size_t at = std::min(page.from, rows.size());
  for (; at < rows.size() && entries.size() < page.count; ++at) {
    const drive::ParameterRow& row = *rows[at];
    if (!text.finds(row)) continue;
    json places = owners_of(unit, row);
    if (places.empty()) continue;
    entries.push_back(ParameterView::definition(row));
    entries.back()["parameter"] = drive::parameter_text(row);
    entries.back()["axes"] = std::move(places);
  }
  json result{{"parameters", std::move(entries)}, {"total", rows.size()}};
  if (at < rows.size()) result["next"] = at;
  return result;
}

Outcome search_parameters(const Call& call, const json& params) {
  const auto text = Arguments{params}.text("text");
  if (!text) return tl::unexpected{text.error()};
  const auto object = optional_place(unit_of(call), params);
  if (!object) return tl::unexpected{object.error()};
  const auto page = page_of(params, kMostEntries);
  if (!page) return tl::unexpected{page.error()};
  const SearchText wanted{*text};
  return *object != nullptr ? search_object(call, **object, wanted, *page)
                            : search_unit(unit_of(call), wanted, *page);
}

constexpr std::array<std::string_view, 2> kReferences{"factory", "stored"};

Outcome differences(const Call& call, const json& params) {
  const auto against = Arguments{params}.choice("against", kReferences, 0);
  if (!against) return tl::unexpected{against.error()};
  const auto object = optional_place(unit_of(call), params);
  if (!object) return tl::unexpected{object.error()};
  const auto page = page_of(params, kMostDifferences);
  if (!page) return tl::unexpected{page.error()};
  const auto reference = static_cast<Reference>(*against);
  const ParameterView view{call.instance};
  json result = paged(
      {unit_of(call), *object}, *page,
      [&](const ParameterSequence::Item& item) {
        return view.differs(item.object, item.placed, item.index, reference);
      },
      [&](const ParameterSequence::Item& item) {
        return view.difference(item.object, item.placed, item.index, reference);
      });
  result["against"] = kReferences[*against];
  result["is_stored"] = call.instance.device().runner().has_saved_parameters();
  return result;
}

constexpr std::array kParameterListHandlers{
    Handler{"parameter.list", &list_parameters},
    Handler{"parameter.search", &search_parameters},
    Handler{"parameter.diff", &differences},
};

}  // namespace

std::span<const Handler> parameter_list_handlers() noexcept {
  return kParameterListHandlers;
}

}  // namespace axisd
