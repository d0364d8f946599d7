#include "tables/format/frame.hpp"

#include <zstd.h>
#include <zstd_errors.h>

#include <memory>
#include <new>

#include "enum/core/errors.hpp"

namespace hexatlas::format {
namespace {

struct FreeContext {
  void operator()(ZSTD_DCtx* context) const noexcept { ZSTD_freeDCtx(context); }
};

/// Of this thread. To make one takes three times as long as to unpack a block of a table.
ZSTD_DCtx& unpacking_context() {
  thread_local std::unique_ptr<ZSTD_DCtx, FreeContext> context;
  if (!context) context.reset(ZSTD_createDCtx());
  if (!context) throw std::bad_alloc();
  return *context;
}

}  // namespace

std::string compressed(std::string_view bytes) {
  constexpr int kLevel = 19;
  std::string frame(ZSTD_compressBound(bytes.size()), '\0');
  const std::size_t size =
      ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0)
    throw core::ResourceFailure(std::string("zstd: ") + ZSTD_getErrorName(size));
  frame.resize(size);
  return frame;
}

bool is_unpacked(std::string_view frame, std::string& bytes) {
  const std::size_t size = ZSTD_decompressDCtx(&unpacking_context(), bytes.data(), bytes.size(),
                                               frame.data(), frame.size());
  if (ZSTD_isError(size) == 0) return size == bytes.size();
  if (ZSTD_getErrorCode(size) == ZSTD_error_memory_allocation) throw std::bad_alloc();
  return false;
}

bool is_compressed(std::string_view bytes) noexcept {
  constexpr std::string_view kMagic("\x28\xb5\x2f\xfd", 4);
  return bytes.substr(0, 4) == kMagic;
}

}  // namespace hexatlas::format
