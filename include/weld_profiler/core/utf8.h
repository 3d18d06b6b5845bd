#pragma once

#include <cstddef>
#include <string>

namespace weld_profiler
{
/// Bytes of the character that begins at `at`: 1..4; 0 = what stands there is no UTF-8 (RFC 3629, section 4).
inline std::size_t utf8Length(const std::string& text, std::size_t at)
{
  const auto byte = [&text, at](std::size_t i)
  { return at + i < text.size() ? static_cast<unsigned char>(text[at + i]) : static_cast<unsigned char>(0); };
  const unsigned char first = byte(0);
  if (first < 0x80)
    return 1;
  if (first < 0xC2 || first > 0xF4)
    return 0;
  const std::size_t length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  // no longer forms than needed, no surrogates, nothing above U+10FFFF
  const unsigned char least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned char most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (byte(1) < least || byte(1) > most)
    return 0;
  for (std::size_t i = 2; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80)
      return 0;
  return length;
}

inline bool isUtf8(const std::string& text)
{
  for (std::size_t at = 0; at < text.size();)
  {
    const std::size_t length = utf8Length(text, at);
    if (length == 0)
      return false;
    at += length;
  }
  return true;
}
}  // namespace weld_profiler
