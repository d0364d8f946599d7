// libFuzzer target of one format, HEXATLAS_FUZZ_FORMAT: the law is in round_trip.hpp.
#include <cstddef>
#include <cstdint>

#include "tests/fuzz/round_trip.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  static_cast<void>(
      hexatlas::fuzz::check_bytes(bytes, hexatlas::io::FileFormat::HEXATLAS_FUZZ_FORMAT));
  return 0;
}
