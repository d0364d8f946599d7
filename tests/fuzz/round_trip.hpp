#pragma once
/// \file
/// The law that a reader must obey on arbitrary bytes: it refuses them with InvalidInput, or its
/// mesh, written in the same format and read again, is the same bit for bit. Used by the libFuzzer
/// targets and by the test that replays their corpus and findings.

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "enum/core/errors.hpp"
#include "meshing/io/mesh_files.hpp"
#include "tests/meshing/io/samples.hpp"

namespace hexatlas::fuzz {

struct Outcome {
  bool is_surface = false;
  bool is_hexahedral = false;
};

/// Throws std::logic_error, which nothing catches, if the law is broken.
template <class Parse>
bool obeys_round_trip(std::string_view bytes, io::FileFormat format, const Parse& parse) {
  auto mesh = parse(bytes);
  if (!mesh) return false;
  for (const io::GmshVersion version : {io::GmshVersion::v2_2, io::GmshVersion::v4_1}) {
    std::string text;
    if constexpr (requires { mesh->quads; })
      text = io::to_text(*mesh, format, version);
    else
      text = io::to_text(*mesh, format, io::WriteOptions{version, {}});
    const auto again = parse(text);
    if (!again || !io_tests::same(*again, *mesh)) throw std::logic_error("round trip: " + text);
    if (format != io::FileFormat::gmsh) break;
  }
  return true;
}

inline Outcome check_bytes(std::string_view bytes, io::FileFormat format) {
  const auto refusable = [&](auto&& read) {
    return [read](std::string_view text) -> std::optional<decltype(read(text))> {
      try {
        return read(text);
      } catch (const core::InvalidInput& error) {
        const std::string_view message = error.what();
        if (!message.starts_with("input:") || message.find('\n') != std::string_view::npos)
          throw std::logic_error("message: " + std::string(message));
        return std::nullopt;
      }
    };
  };
  Outcome outcome;
  outcome.is_surface = obeys_round_trip(bytes, format, refusable([&](std::string_view text) {
                                          return io::parse_surface(text, format, "input");
                                        }));
  outcome.is_hexahedral = obeys_round_trip(bytes, format, refusable([&](std::string_view text) {
                                             return io::parse_hexahedra(text, format, "input");
                                           }));
  return outcome;
}

}  // namespace hexatlas::fuzz
