#include "libcanopen/service/service.hpp"

#include "libcanopen/service/service_list.hpp"

namespace canopen {

Service::Service(Context& context, const ServiceFacts& facts)
    : context_{context}, first_timer_{context.services.add(*this, facts)} {}

}  // namespace canopen
