// See escape.h.
#include "io/escape.h"

#include <cstddef>

namespace lpq {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }
bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

/// Length of the well-formed UTF-8 sequence at `i` (Unicode 15, table 3-7), 0 if malformed.
std::size_t utf8_length(std::string_view text, std::size_t i) {
  const auto byte = [&](std::size_t k) -> unsigned {
    return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0;
  };
  const unsigned lead = byte(0), second = byte(1);
  if (lead < 0x80) return 1;
  const auto tail = [&](std::size_t n) {
    for (std::size_t k = 1; k <= n; ++k)
      if ((byte(k) & 0xC0) != 0x80) return false;
    return true;
  };
  if (lead >= 0xC2 && lead <= 0xDF) return tail(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F)) return 0;
    return tail(2) ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    if ((lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F)) return 0;
    return tail(3) ? 4 : 0;
  }
  return 0;
}

/// Calls `ascii(c)` for plain characters, copies longer sequences, writes `bad` for broken bytes.
template <class Ascii>
void append_utf8(std::string& out, std::string_view text, std::string_view bad, Ascii&& ascii) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) {
      out += bad;
      ++i;
    } else if (length == 1) {
      ascii(text[i]);
      ++i;
    } else {
      out += text.substr(i, length);
      i += length;
    }
  }
}

}  // namespace

bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 0) return false;
    i += length;
  }
  return true;
}

void append_character(std::string& out, std::uint32_t code) {
  const auto byte = [&out](std::uint32_t value) { out += static_cast<char>(value); };
  if (code < 0x80) return byte(code);
  if (code < 0x800) {
    byte(0xC0 | code >> 6);
  } else {
    if (code < 0x10000) {
      byte(0xE0 | code >> 12);
    } else {
      byte(0xF0 | code >> 18);
      byte(0x80 | (code >> 12 & 63));
    }
    byte(0x80 | (code >> 6 & 63));
  }
  byte(0x80 | (code & 63));
}

void append_xml(std::string& out, std::string_view text) {
  append_utf8(out, text, "?", [&](char c) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      case '\'': out += "&#39;"; break;
      case '\t':
      case '\n':
      case '\r': out += ' '; break;
      default: out += is_control(c) ? '?' : c;
    }
  });
}

void append_json_string(std::string& out, std::string_view text) {
  constexpr char hex[] = "0123456789abcdef";
  out += '"';
  append_utf8(out, text, "\xEF\xBF\xBD", [&](char c) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (c == '\n') {
      out += "\\n";
    } else if (is_control(c)) {
      out += "\\u00";
      out += hex[static_cast<unsigned char>(c) >> 4];
      out += hex[static_cast<unsigned char>(c) & 15];
    } else {
      out += c;
    }
  });
  out += '"';
}

void append_msh_name(std::string& out, std::string_view text) {
  append_utf8(out, utf8_start(text, longest_msh_name), "?", [&](char c) {
    out += c == '"' ? '\'' : c == '\\' ? '/' : is_control(c) ? ' ' : c;
  });
}

void append_obj_name(std::string& out, std::string_view text) {
  const bool hash = !text.empty() && text[0] == '#';
  if (hash) out += '_';
  append_utf8(out, text.substr(hash ? 1 : 0), "?",
              [&](char c) { out += c == ' ' || c == '\\' || is_control(c) ? '_' : c; });
}

std::string_view utf8_start(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return text;
  std::size_t length = longest;
  while (length > 0 && is_continuation(text[length])) --length;
  return text.substr(0, length);
}

void append_ascii(std::string& out, std::string_view text, std::string_view other) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    if (length == 1) {
      out += is_control(text[i]) ? ' ' : text[i];
    } else {
      out += other;
    }
    i += length == 0 ? 1 : length;
  }
}

void append_quoted_ascii(std::string& out, std::string_view text, std::size_t longest) {
  std::string plain;
  append_ascii(plain, text);
  out += '"';
  for (const char c : std::string_view(plain).substr(0, longest)) out += c == '"' ? '\'' : c;
  out += '"';
}

}  // namespace lpq
