// Claim. Whatever the text, it is a canonical code, a word of another walk, or refused; what can
// be decoded is a quadrangulation of the sphere, and its code decodes to something with that code.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "enum/canon/code.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hexatlas;
  const auto code = canon::from_text({reinterpret_cast<const char*>(data), size});
  if (!code) return 0;
  const auto q = canon::decode(*code);
  if (!q) return 0;
  if (q->validate()) std::abort();
  const auto form = canon::canonical_form(*q);
  const auto again = canon::decode(form.code);
  if (!again || canon::canonical_form(*again).code != form.code) std::abort();
  if (form.automorphisms < 1 || form.automorphisms % form.rotations != 0) std::abort();
  return 0;
}
