#include "tables/format/sha256.hpp"

#include <openssl/evp.h>

#include <memory>

#include "enum/core/errors.hpp"

namespace hexatlas::format {

Digest sha256(std::span<const std::string_view> parts) {
  const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(),
                                                                        &EVP_MD_CTX_free);
  Digest digest{};
  bool works = context && EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) == 1;
  for (const std::string_view part : parts)
    works = works && EVP_DigestUpdate(context.get(), part.data(), part.size()) == 1;
  works = works && EVP_DigestFinal_ex(context.get(), digest.data(), nullptr) == 1;
  if (!works) throw core::ResourceFailure("SHA-256 is not available from OpenSSL");
  return digest;
}

std::string to_hex(const Digest& digest) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string result;
  for (const unsigned char byte : digest) {
    result += kDigits[byte >> 4U];
    result += kDigits[byte & 15U];
  }
  return result;
}

}  // namespace hexatlas::format
