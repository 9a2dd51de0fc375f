#include "profidrive/channel/parameter_channel.hpp"

#include <algorithm>

#include "profidrive/parameter/big_endian.hpp"
#include "profidrive/parameter/description.hpp"
#include "profidrive/parameter/error_code.hpp"

namespace profidrive {
namespace {

using drive::DataType;
using drive::FoundParameter;
using drive::RefusalReason;
using Words = ParameterChannel::Words;

/// Places of the words.
enum Place : std::size_t { kKey, kIndex, kHigh, kLow };

constexpr unsigned kTaskShift = 12;
constexpr std::uint16_t kNumberBits = 0x07FF;
constexpr std::uint8_t kNotDone = 7;

/// The numbers that a page shows, in kPage steps from `first` on.
struct PageRow {
  std::uint8_t page;
  std::uint16_t first;
};
constexpr std::uint16_t kPage = 2000;
constexpr std::array kPages{PageRow{0x00, 0},     PageRow{0x80, 2000},  PageRow{0x10, 4000},
                            PageRow{0x90, 6000},  PageRow{0x20, 8000},  PageRow{0xA0, 10000},
                            PageRow{0x50, 20000}, PageRow{0xF0, 30000}, PageRow{0x74, 60000}};

enum class Task : std::uint8_t { None, Read, WriteWord, WriteDoubleWord, Describe, Count, Unknown };
/// What a request identifier asks for, and the identifiers of an answer with a word and with a double word.
struct TaskRow {
  Task task = Task::None;
  std::uint8_t word = 0;
  std::uint8_t double_word = 0;
};
constexpr std::array kTasks{
    TaskRow{Task::None},
    TaskRow{Task::Read, 1, 2},
    TaskRow{Task::WriteWord, 1, 1},
    TaskRow{Task::WriteDoubleWord, 2, 2},
    TaskRow{Task::Describe, 3, 3},
    TaskRow{Task::Unknown},
    TaskRow{Task::Read, 4, 5},
    TaskRow{Task::WriteWord, 4, 4},
    TaskRow{Task::WriteDoubleWord, 5, 5},
    TaskRow{Task::Count, 6, 6},
};

const TaskRow& task_of(const Words& request) noexcept {
  static constexpr TaskRow kUnknown{Task::Unknown};
  const std::size_t identifier = request[kKey] >> kTaskShift;
  return identifier < kTasks.size() ? kTasks[identifier] : kUnknown;
}

constexpr bool writes(Task task) noexcept {
  return task == Task::WriteWord || task == Task::WriteDoubleWord;
}

constexpr bool is_double_word(DataType type) noexcept {
  return drive::row_of(type).size > sizeof(std::uint16_t);
}

/// What is done with a value, or why it is not.
using Done = tl::expected<std::uint32_t, RefusalReason>;

tl::unexpected<RefusalReason> refused(RefusalReason reason) noexcept {
  return tl::unexpected{reason};
}

std::uint16_t number_of(const Words& request) noexcept {
  const auto page = static_cast<std::uint8_t>(request[kIndex]);
  const auto* const row = std::ranges::find(kPages, page, &PageRow::page);
  const auto offset = static_cast<std::uint16_t>(request[kKey] & kNumberBits);
  // No parameter has the number 0.
  return row != kPages.end() && offset < kPage ? static_cast<std::uint16_t>(row->first + offset)
                                               : std::uint16_t{0};
}

std::size_t sub_index_of(const Words& request) noexcept {
  return std::size_t{request[kIndex]} >> 8;
}

/// Inputs are arrays over the command data sets, of which there is one.
RefusalReason find_refusal(const drive::ParameterError& error) noexcept {
  const bool is_input = error.row != nullptr && drive::is_bico_input(error.row->type);
  return is_input && error.reason == RefusalReason::NotIndexed ? RefusalReason::NoIndex : error.reason.why;
}

/// The words of @p request as a value of @p type: a shorter one is extended by its sign or by 0.
std::optional<std::uint32_t> value_in(const Words& request, DataType type) noexcept {
  const std::uint32_t bits = std::uint32_t{request[kHigh]} << 16 | request[kLow];
  if (is_double_word(type)) return bits;
  const unsigned own_bits = 8U * drive::row_of(type).size;
  const std::uint32_t others = bits >> own_bits;
  const bool is_negative = drive::decode({type, bits}) < 0.0;
  return others == 0 || (is_negative && others == UINT32_MAX >> own_bits) ? std::optional{bits} : std::nullopt;
}

Done write(const FoundParameter& parameter, const Words& request, Task task,
           drive::ParameterAccess& access) noexcept {
  const DataType type = parameter.row().type;
  const bool as_word = task == Task::WriteWord;
  if (as_word == is_double_word(type) && !(as_word && drive::is_bico_input(type)))
    return refused(RefusalReason::WrongType);
  if (const auto reason = access.write_refusal(parameter, drive::Door::Channel)) return refused(reason->why);
  const auto bits = value_in(request, type);
  if (!bits) return refused(RefusalReason::OutOfRange);
  const double value = drive::decode({type, *bits});
  const auto written = access.write(parameter, value, drive::Door::Channel);
  if (!written) return refused(told_reason(written.error(), value));
  return std::uint32_t{request[kHigh]} << 16 | request[kLow];
}

/// What a parameter shows, without the sign in front of its own bits.
std::uint32_t read(const FoundParameter& parameter, drive::ParameterAccess& access) noexcept {
  const drive::ParameterValue value = access.read(parameter);
  const unsigned unused = 32U - 8U * drive::row_of(value.type).size;
  return value.bits << unused >> unused;
}

Done describe_element(const FoundParameter& parameter, std::size_t sub_index) noexcept {
  if (sub_index >= kDescriptionElements.size()) return refused(RefusalReason::NoIndex);
  const DescriptionElement& element = kDescriptionElements[sub_index];
  if (element.size > sizeof(std::uint32_t)) return refused(RefusalReason::ChannelTooNarrow);
  return number_in(part_of(describe(parameter), element));
}

/// The index of a description or of the number of indices says nothing about the parameter.
std::size_t index_of(const Words& request, Task task) noexcept {
  return task == Task::Describe || task == Task::Count ? 0 : sub_index_of(request);
}

Done carry_out(const FoundParameter& parameter, const Words& request, Task task,
               drive::ParameterAccess& access) noexcept {
  if (writes(task)) return write(parameter, request, task, access);
  if (task == Task::Describe) return describe_element(parameter, sub_index_of(request));
  return task == Task::Count ? parameter.row().count : read(parameter, access);
}

Words answer_with(const Words& request, std::uint8_t identifier, std::uint32_t value) noexcept {
  const unsigned key = unsigned{identifier} << kTaskShift | (request[kKey] & kNumberBits);
  return {static_cast<std::uint16_t>(key), request[kIndex], static_cast<std::uint16_t>(value >> 16),
          static_cast<std::uint16_t>(value)};
}

Words answer_to(const Words& request, std::uint8_t object, drive::ParameterAccess& access) noexcept {
  const TaskRow& row = task_of(request);
  if (row.task == Task::None) return {};
  const auto refuse = [&](RefusalReason reason) {
    return answer_with(request, kNotDone, static_cast<std::uint32_t>(reason) << 16);
  };
  if (row.task == Task::Unknown) return refuse(RefusalReason::UnknownRequest);
  const auto found = access.find({object, number_of(request), index_of(request, row.task)});
  if (!found) return refuse(find_refusal(found.error()));
  const Done done = carry_out(*found, request, row.task, access);
  if (!done) return refuse(done.error());
  const bool is_double = row.task == Task::Read && is_double_word(found->row().type);
  return answer_with(request, is_double ? row.double_word : row.word, *done);
}

}  // namespace

const Words& ParameterChannel::exchange(const Words& request, drive::ParameterAccess& access) noexcept {
  if (request != request_ || !writes(task_of(request).task)) answer_ = answer_to(request, object_, access);
  request_ = request;
  return answer_;
}

}  // namespace profidrive
