#include "farm/storage/digest.hpp"

#include <algorithm>
#include <array>
#include <new>

#include <openssl/evp.h>

namespace farm {

std::string base64url(std::string_view bytes) {
  constexpr std::size_t kGroup = 3;
  constexpr std::size_t kLetters = 4;
  std::string text((bytes.size() + kGroup - 1) / kGroup * kLetters + 1, '\0');  // one more, which is written, too
  const auto size =
      EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()),
                      reinterpret_cast<const unsigned char*>(bytes.data()), static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(size));
  std::ranges::replace(text, '+', '-');
  std::ranges::replace(text, '/', '_');
  return text;
}

std::string digest_of(std::string_view content) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned size = 0;
  // It fails for want of memory alone; an object under a wrong digest would be taken for a damaged one.
  if (EVP_Digest(content.data(), content.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1)
    throw std::bad_alloc{};
  return "SHA-256=" + base64url({reinterpret_cast<const char*>(digest.data()), size});
}

}  // namespace farm
