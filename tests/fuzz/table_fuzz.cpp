// Claim. Whatever the bytes, opening a table and reading all of it either works or throws
// InvalidInput; nothing else happens. So does the judge of tables, which never throws.
// The digest of the bytes is put right first, so that damage gets past it.
#include <cstdint>
#include <string>
#include <string_view>

#include "enum/core/errors.hpp"
#include "tables/check/table_check.hpp"
#include "tables/format/layout.hpp"
#include "tables/format/sha256.hpp"
#include "tables/format/table.hpp"

namespace {

using namespace hexatlas;

void put_digest_right(std::string& bytes) {
  namespace layout = format::layout;
  if (bytes.size() < layout::kHeaderSize) return;
  for (std::size_t i = layout::kDigest; i < layout::kHeaderSize; ++i) bytes[i] = '\0';
  const std::array<std::string_view, 1> whole{bytes};
  const format::Digest digest = format::sha256(whole);
  for (std::size_t i = 0; i < digest.size(); ++i)
    bytes[layout::kDigest + i] = static_cast<char>(digest[i]);
}

void read_everything(const std::string& bytes) {
  const format::Table table = format::Table::from_bytes(bytes, "fuzz");
  for (std::size_t i = 0; i < table.size() && i < 256; ++i) {
    const auto ordinal = table.find(table.entry(i).code);
    if (ordinal && *ordinal < table.size()) (void)table.mesh(*ordinal);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  put_digest_right(bytes);
  try {
    read_everything(bytes);
  } catch (const core::InvalidInput&) {
    // refused, as it should be
  }
  (void)check::check_table_bytes(bytes);
  return 0;
}
