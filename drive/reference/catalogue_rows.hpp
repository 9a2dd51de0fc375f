#pragma once

#include <string>

namespace drive {

/// Every parameter of every kind of drive object as rows of the object catalogue: JSON, the list "parameters" of
/// eds/catalogue.json. Defaults stand where they do not depend on the machine or the address.
std::string catalogue_rows();

}  // namespace drive
