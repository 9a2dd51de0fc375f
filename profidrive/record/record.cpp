#include "profidrive/record/record.hpp"

#include <algorithm>
#include <optional>

#include "profidrive/parameter/description.hpp"
#include "profidrive/parameter/error_code.hpp"
#include "profidrive/record/answer.hpp"

namespace profidrive::record {
namespace {

using drive::FoundParameter;
using drive::RefusalReason;
using Bytes = std::span<const std::uint8_t>;

/// Serves one request: the parameters in order, each by itself.
class Server {
 public:
  Server(drive::ParameterAccess& access, std::uint8_t object, Answer& answer) noexcept
      : access_{access}, object_{object}, answer_{answer} {}

  void read(const Address& address) noexcept;
  void write(const Address& address, const std::optional<Values>& values) noexcept;

 private:
  tl::expected<FoundParameter, Error> find(const Address& address) const noexcept;
  void read_values(const FoundParameter& parameter, const Address& address) noexcept;
  void read_description(const FoundParameter& parameter, const Address& address) noexcept;
  std::optional<Error> write_values(const FoundParameter& first, const Values& values) noexcept;

  drive::ParameterAccess& access_;
  std::uint8_t object_;
  Answer& answer_;
};

/// Why nothing is done with @p attribute of a parameter, whichever it is.
std::optional<RefusalReason> attribute_refusal(std::uint8_t attribute, Service service) noexcept {
  switch (Attribute{attribute}) {
    case Attribute::Value:
      return std::nullopt;
    case Attribute::Description:
      return service == Service::Write ? std::optional{RefusalReason::DescriptionFixed} : std::nullopt;
    case Attribute::Text:
      return RefusalReason::NoText;
  }
  return RefusalReason::BadAddress;
}

/// The parameter with all elements that are asked for; the error names the first one that is missing.
tl::expected<FoundParameter, Error> Server::find(const Address& address) const noexcept {
  const std::size_t last = address.sub_index + address.count() - 1;
  const auto found = access_.find({object_, address.number, last});
  if (found) return FoundParameter{found->object, found->placed, address.sub_index};
  const drive::ParameterError& error = found.error();
  const std::uint16_t indices = error.row != nullptr ? error.row->count : std::uint16_t{0};
  return tl::unexpected{Error{error.reason.why, std::max(address.sub_index, indices)}};
}

void Server::read(const Address& address) noexcept {
  if (const auto reason = attribute_refusal(address.attribute, Service::Read))
    return answer_.add_error({*reason, address.sub_index});
  const bool is_value = Attribute{address.attribute} == Attribute::Value;
  const auto parameter = find(is_value ? address : Address{.number = address.number});
  if (!parameter) return answer_.add_error(parameter.error());
  if (is_value) return read_values(*parameter, address);
  read_description(*parameter, address);
}

void Server::read_values(const FoundParameter& parameter, const Address& address) noexcept {
  const drive::DataType type = parameter.row().type;
  const std::size_t size = drive::row_of(type).size;
  std::span<std::uint8_t> room = answer_.add_values(format_of(type), address.count(), size);
  for (std::size_t i = 0; !room.empty(); ++i, room = room.subspan(size)) {
    const FoundParameter element{parameter.object, parameter.placed, parameter.index + i};
    put_number(room.first(size), access_.read(element).bits);
  }
}

/// The sub-index says which element of it.
void Server::read_description(const FoundParameter& parameter, const Address& address) noexcept {
  if (address.sub_index >= kDescriptionElements.size()) return answer_.add_error({RefusalReason::NoDescription});
  const DescriptionElement& element = kDescriptionElements[address.sub_index];
  const Description description = describe(parameter);
  const std::size_t size = find_format(static_cast<std::uint8_t>(element.format))->size;
  const std::span<std::uint8_t> room = answer_.add_values(element.format, element.size / size, size);
  if (!room.empty()) std::ranges::copy(part_of(description, element), room.begin());
}

void Server::write(const Address& address, const std::optional<Values>& values) noexcept {
  if (const auto reason = attribute_refusal(address.attribute, Service::Write))
    return answer_.add_error({*reason, address.sub_index});
  const auto parameter = find(address);
  if (!parameter) return answer_.add_error(parameter.error());
  if (!values) return answer_.add_error({RefusalReason::BadAddress});
  if (values->format == nullptr) return answer_.add_error({RefusalReason::BadFormat});
  if (values->count != address.count()) return answer_.add_error({RefusalReason::CountMismatch});
  if (const auto refused = write_values(*parameter, *values)) return answer_.add_error(*refused);
  answer_.add_done();
}

/// Values before one that is refused stay.
std::optional<Error> Server::write_values(const FoundParameter& first, const Values& values) noexcept {
  const FormatRow& format = *values.format;
  drive::TransferredValue value{.size = format.size, .type = format.type};
  if (!has_values(format.format) || !fits(value, first.row())) return Error{RefusalReason::WrongType};
  for (std::size_t i = 0; i < values.count; ++i) {
    value.bits = number_in(values.bytes.subspan(i * format.size, format.size));
    const FoundParameter element{first.object, first.placed, first.index + i};
    const auto written = access_.write(element, value, drive::Door::Record);
    if (written) continue;
    const double number = drive::decode({element.row().type, value.bits});
    return Error{told_reason(written.error(), number), static_cast<std::uint16_t>(element.index)};
  }
  return std::nullopt;
}

/// Why nothing of a request is done.
std::size_t refuse(std::span<std::uint8_t, kMostBytes> response, const Header& header,
                   RefusalReason reason) noexcept {
  Answer answer{response, header, 1};
  answer.add_error({reason});
  return answer.size();
}

}  // namespace

std::size_t answer(Bytes request, std::span<std::uint8_t, kMostBytes> response,
                   drive::ParameterAccess& access) noexcept {
  const Bytes record = request.first(std::min(request.size(), kMostBytes));
  const Header header = header_of(record);
  auto taken = Request::of(record);
  if (!taken && taken.error() == RefusalReason::UnknownService) return refuse(response, header, taken.error());
  if (record.size() > 2 && !access.has_object(header.object))
    return refuse(response, header, RefusalReason::NoDriveObject);
  if (!taken) return refuse(response, header, taken.error());
  Answer answer{response, header, taken->count()};
  Server server{access, header.object, answer};
  const bool writes = taken->service() == Service::Write;
  for (std::size_t i = 0; i < taken->count(); ++i) {
    if (!writes) server.read(taken->address(i));
    if (writes) server.write(taken->address(i), taken->take_values());
  }
  // What has all been written is told in the header alone.
  return writes && !answer.is_negative() ? kHeaderBytes : answer.size();
}

}  // namespace profidrive::record
