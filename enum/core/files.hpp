#pragma once
/// \file
/// Whole files in, whole files out.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace hexatlas::core {

/// The largest file read into memory, but for this program's own states.
inline constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30U;

/// The bytes of a file, or of standard input for "-".
/// Throws InvalidInput (missing, a directory, not readable, larger than kMaxFileBytes).
[[nodiscard]] std::string read_file(const std::string& path);
/// The same of a saved state, which may be as large as memory allows, and of no device, which may
/// have no end. Throws InvalidInput as read_file(), and for a device.
[[nodiscard]] std::string read_state(const std::string& path);

/// Replaces `path` by a file with these bytes, or leaves what was there: the bytes go to
/// a temporary file in the same folder, which is flushed to disk and then renamed; "-" is
/// standard output. An existing device or pipe is written in place, since renaming would
/// replace it; a link is followed.
/// Throws InvalidInput if the file cannot be created (no such folder, no permission, a
/// directory, a link to nothing), ResourceFailure if writing fails later (disk full).
void write_file(const std::string& path, std::string_view bytes);

/// Takes the next bytes of a file.
using Sink = std::function<void(std::string_view)>;

/// As write_file(), with the bytes that `produce` gives to its sink, in order: for files that need
/// not lie in memory as a whole. What `produce` throws is passed on, and what was there is left;
/// only what went to a device, a pipe or standard output by then is gone.
void write_file_in_parts(const std::string& path, const std::function<void(const Sink&)>& produce);

/// A file that is whole on disk, under another name in its folder, but not yet in its place: of
/// files that belong together, none takes its place before all are there.
class PendingFile {
 public:
  /// What write_file() does but for the last step; a device, a pipe and standard output have the
  /// bytes at once. Throws as write_file() does.
  PendingFile(const std::string& path, const std::function<void(const Sink&)>& produce);
  PendingFile(const std::string& path, std::string_view bytes);
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  /// Leaves what was there, unless the file is in its place.
  ~PendingFile();

  /// The last step. Throws InvalidInput if the file cannot be replaced.
  void place();

 private:
  std::string temporary_, target_;  ///< none: nothing is to be placed
};

/// Tells before long work what would make it be in vain: that write_file(path, ...) cannot succeed
/// as the file system stands. Writes nothing. That the file can be written later is not promised.
/// Throws InvalidInput in the cases in which write_file() does.
void expect_writable(const std::string& path);

}  // namespace hexatlas::core
