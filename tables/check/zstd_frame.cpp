#include "tables/check/zstd_frame.hpp"

#include <zstd.h>
#include <zstd_errors.h>

#include <memory>
#include <new>
#include <vector>

namespace hexatlas::check {

namespace {

constexpr std::string_view kMagic = "\x28\xB5\x2F\xFD";

struct FreeContext {
  void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

/// Whether the library refused the bytes; memory that is short is no fault of theirs.
bool is_refused(std::size_t result) {
  if (ZSTD_isError(result) == 0) return false;
  if (ZSTD_getErrorCode(result) == ZSTD_error_memory_allocation) throw std::bad_alloc();
  return true;
}

}  // namespace

bool begins_zstd_frame(std::string_view bytes) noexcept { return bytes.starts_with(kMagic); }

bool unpack_frame(std::string_view stored, std::uint64_t most, std::string& bytes) {
  if (!begins_zstd_frame(stored) ||
      ZSTD_findFrameCompressedSize(stored.data(), stored.size()) != stored.size()) {
    return false;
  }
  const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
  if (!context) throw std::bad_alloc();
  std::vector<char> buffer(ZSTD_DStreamOutSize());
  ZSTD_inBuffer in{stored.data(), stored.size(), 0};
  std::uint64_t room = most;
  for (std::size_t left = 1; left != 0;) {
    ZSTD_outBuffer out{buffer.data(), buffer.size(), 0};
    left = ZSTD_decompressStream(context.get(), &out, &in);
    if (is_refused(left) || out.pos > room) return false;
    room -= out.pos;
    bytes.append(buffer.data(), out.pos);
    if (left != 0 && out.pos == 0 && in.pos == in.size) return false;
  }
  return in.pos == in.size;
}

std::string start_of_frame(std::string_view stored, std::size_t most) {
  const std::unique_ptr<ZSTD_DCtx, FreeContext> context(ZSTD_createDCtx());
  if (!context) throw std::bad_alloc();
  std::string bytes(most, '\0');
  ZSTD_inBuffer in{stored.data(), stored.size(), 0};
  ZSTD_outBuffer out{bytes.data(), bytes.size(), 0};
  for (std::size_t left = 1; left != 0 && out.pos < most;) {
    const std::size_t done = in.pos + out.pos;
    left = ZSTD_decompressStream(context.get(), &out, &in);
    if (is_refused(left) || in.pos + out.pos == done) break;
  }
  bytes.resize(out.pos);
  return bytes;
}

}  // namespace hexatlas::check
