// Parameters by records (DS47) and parameter channels (PKW), for programs that speak a protocol which has them.
#include <array>

#include <fmt/format.h>

#include "daemon/control/handlers.hpp"
#include "daemon/control/profidrive/hexadecimal.hpp"
#include "daemon/instance/instance.hpp"
#include "profidrive/parameter/big_endian.hpp"
#include "profidrive/record/record.hpp"

namespace axisd {
namespace {

using nlohmann::json;
using profidrive::ParameterChannel;

constexpr std::string_view kRequest = "request";

json response_json(std::span<const std::uint8_t> bytes) {
  return {{"response", hexadecimal(bytes)}};
}

Outcome exchange_record(const Call& call, const json& params) {
  const auto request = required_bytes(params, kRequest, {1, profidrive::record::kMostBytes});
  if (!request) return tl::unexpected{request.error()};
  device::Device& device = call.instance.device();
  if (!device.is_on()) return tl::unexpected{unit_is_off()};
  std::array<std::uint8_t, profidrive::record::kMostBytes> response{};
  const std::size_t size = device.access_parameters(call.now, [&](drive::ParameterAccess& access) {
    return profidrive::record::answer(*request, response, access);
  });
  return response_json(std::span{response}.first(size));
}

constexpr std::size_t kWord = sizeof(ParameterChannel::Words::value_type);
constexpr std::size_t kChannelBytes = kWord * std::tuple_size_v<ParameterChannel::Words>;

/// The channel of the drive object that the parameters name.
Taken<ParameterChannel*> required_channel(const Call& call, const json& params) {
  const auto number = Arguments{params}.integer("do", drive::kControlUnitNumber, drive::kMostObjects);
  if (!number) return tl::unexpected{number.error()};
  ParameterChannel* const channel = call.instance.parameter_channel(static_cast<std::uint8_t>(*number));
  if (channel != nullptr) return channel;
  return refuse(control::ErrorCode::BadParameter, fmt::format("do: the unit has no drive object {}", *number));
}

Outcome exchange_channel(const Call& call, const json& params) {
  const auto channel = required_channel(call, params);
  if (!channel) return tl::unexpected{channel.error()};
  const auto bytes = required_bytes(params, kRequest, {kChannelBytes, kChannelBytes});
  if (!bytes) return tl::unexpected{bytes.error()};
  device::Device& device = call.instance.device();
  if (!device.is_on()) return tl::unexpected{unit_is_off()};
  ParameterChannel::Words request{};
  for (std::size_t i = 0; i < request.size(); ++i)
    request[i] = static_cast<std::uint16_t>(profidrive::number_in(std::span{*bytes}.subspan(i * kWord, kWord)));
  const ParameterChannel::Words answer = device.access_parameters(
      call.now, [&](drive::ParameterAccess& access) { return (*channel)->exchange(request, access); });
  std::array<std::uint8_t, kChannelBytes> response{};
  for (std::size_t i = 0; i < answer.size(); ++i)
    profidrive::put_number(std::span{response}.subspan(i * kWord, kWord), answer[i]);
  return response_json(response);
}

constexpr std::array kAcyclicHandlers{
    Handler{"parameter.record", &exchange_record},
    Handler{"pkw.exchange", &exchange_channel},
};

}  // namespace

std::span<const Handler> acyclic_handlers() noexcept {
  return kAcyclicHandlers;
}

}  // namespace axisd
