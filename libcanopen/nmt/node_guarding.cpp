#include "libcanopen/nmt/node_guarding.hpp"

namespace canopen {

NodeGuarding::NodeGuarding(Context& context, std::size_t timer) : context_{context}, timer_{timer} {}

void NodeGuarding::reload() noexcept {
  (void)context_, (void)timer_;
}

void NodeGuarding::on_request() noexcept {}

void NodeGuarding::on_timer() noexcept {}

Result<void> NodeGuarding::write(const Entry&, std::int64_t) {
  return {};
}

}  // namespace canopen
