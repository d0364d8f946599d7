#include <cstdint>
#include <string>
#include <string_view>

#include "enum/canon/code.hpp"

namespace hexatlas::canon {
namespace {

using complex::kMaxQuads;

constexpr std::string_view kTextPrefix = "q1:";
constexpr std::string_view kDigits = "0123456789abcdef";

std::uint64_t digit_at(const Code& code, int index) noexcept {
  return code.words[static_cast<std::size_t>(index / 16)] >> (60U - 4U * (index % 16U)) & 15U;
}

void set_digit(Code& code, int index, std::uint64_t digit) noexcept {
  code.words[static_cast<std::size_t>(index / 16)] |= digit << (60U - 4U * (index % 16U));
}

}  // namespace

std::string to_binary(const Code& code) {
  std::string result(binary_size(code.quads), '\0');
  for (int i = 0; i < code.quads; ++i) {
    const auto digit = static_cast<unsigned>(digit_at(code, i));
    auto& byte = result[static_cast<std::size_t>(i / 2)];
    byte = static_cast<char>(static_cast<unsigned char>(byte) | (i % 2 == 0 ? digit << 4U : digit));
  }
  return result;
}

std::optional<Code> from_binary(int quads, std::string_view bytes) {
  if (quads < 1 || quads > kMaxQuads || bytes.size() != binary_size(quads)) return std::nullopt;
  Code code{.quads = static_cast<std::uint8_t>(quads)};
  for (int i = 0; i < 2 * static_cast<int>(bytes.size()); ++i) {
    const auto byte = static_cast<unsigned char>(bytes[static_cast<std::size_t>(i / 2)]);
    const std::uint64_t digit = i % 2 == 0 ? byte >> 4U : byte & 15U;
    if (i < quads)
      set_digit(code, i, digit);
    else if (digit != 0)
      return std::nullopt;
  }
  return code;
}

std::string to_text(const Code& code) {
  std::string result(kTextPrefix);
  for (int i = 0; i < code.quads; ++i) result += kDigits[digit_at(code, i)];
  return result;
}

std::optional<Code> from_text(std::string_view text) {
  if (!text.starts_with(kTextPrefix)) return std::nullopt;
  text.remove_prefix(kTextPrefix.size());
  if (text.empty() || text.size() > kMaxQuads) return std::nullopt;
  Code code{.quads = static_cast<std::uint8_t>(text.size())};
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t digit = kDigits.find(text[i]);
    if (digit == std::string_view::npos) return std::nullopt;
    set_digit(code, static_cast<int>(i), digit);
  }
  return code;
}

}  // namespace hexatlas::canon
