// See xml_reader.h.
#include "io/domain/xml_reader.h"

#include <algorithm>
#include <cstdint>

#include "io/escape.h"
#include "io/plain_text.h"
#include "io/text_place.h"

namespace lpq {
namespace {

constexpr std::size_t deepest = 256;       // elements within elements
constexpr std::size_t most_prefixes = 32;  // of SVG: every name is compared with them
constexpr std::string_view svg_namespace = "http://www.w3.org/2000/svg";
constexpr std::string_view blanks = " \t\r\n";

/// The character of "#65" or "#x41", 0 if it is none.
std::uint32_t character_of(std::string_view digits) {
  const bool hexadecimal = digits.size() > 1 && digits[1] == 'x';
  const std::uint32_t base = hexadecimal ? 16 : 10;
  std::uint32_t code = 0;
  for (const char c : digits.substr(hexadecimal ? 2 : 1)) {
    std::uint32_t digit = 99;
    if (c >= '0' && c <= '9') digit = static_cast<std::uint32_t>(c - '0');
    if (c >= 'a' && c <= 'f') digit = static_cast<std::uint32_t>(c - 'a') + 10;
    if (c >= 'A' && c <= 'F') digit = static_cast<std::uint32_t>(c - 'A') + 10;
    if (digit >= base) return 0;
    code = code * base + digit;
    if (code > 0x10FFFF) return 0;
  }
  return code >= 0xD800 && code < 0xE000 ? 0 : code;
}

bool append_entity(std::string& out, std::string_view name) {
  struct Named {
    std::string_view name;
    char character;
  };
  constexpr Named known[] = {{"amp", '&'}, {"lt", '<'}, {"gt", '>'}, {"quot", '"'}, {"apos", '\''}};
  for (const Named& entity : known) {
    if (entity.name != name) continue;
    out += entity.character;
    return true;
  }
  const std::uint32_t code = !name.empty() && name[0] == '#' ? character_of(name) : 0;
  if (code != 0) append_character(out, code);
  return code != 0;
}

}  // namespace

XmlReader::XmlReader(std::string_view text, std::size_t start) : text_(text), at_(start) {
  if (start == 0) at_ = byte_order_mark_size(text_);
}

XmlReader XmlReader::at(std::size_t start) const {
  XmlReader reader(text_, start);
  reader.prefixes_ = prefixes_;
  return reader;
}

void XmlReader::note_prefixes() {
  constexpr std::string_view binds = "xmlns:";
  for (const XmlAttribute& attribute : attributes_) {
    if (attribute.name.substr(0, binds.size()) != binds || attribute.raw != svg_namespace) continue;
    const std::string_view prefix = attribute.name.substr(binds.size());
    const bool is_known = std::find(prefixes_.begin(), prefixes_.end(), prefix) != prefixes_.end();
    if (!is_known && prefixes_.size() < most_prefixes) prefixes_.push_back(prefix);
  }
}

std::string_view XmlReader::without_prefix(std::string_view name) const {
  const std::size_t colon = name.find(':');
  if (colon == std::string_view::npos) return name;
  const bool is_svg =
      std::find(prefixes_.begin(), prefixes_.end(), name.substr(0, colon)) != prefixes_.end();
  return is_svg ? name.substr(colon + 1) : name;
}

XmlReader::Event XmlReader::fail(std::size_t byte, std::string message) {
  error_ = error_at(text_, byte, std::move(message));
  return Event::error;
}

XmlReader::Event XmlReader::next() {
  if (closes_itself_) {
    closes_itself_ = false;
    open_.pop_back();
    return Event::close;
  }
  while (true) {
    const std::size_t start = text_.find('<', at_);
    if (start == std::string_view::npos) {
      if (!open_.empty())
        return fail(text_.size(), "The file ends within <" + std::string(open_.back()) + ">.");
      if (!seen_root_) return fail(text_.size(), "This is not XML: it has no element.");
      return Event::end;
    }
    tag_ = start;
    at_ = start + 1;
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (c == '/') return read_close();
    if (c != '!' && c != '?') return read_open();
    if (!skip_markup()) return Event::error;
  }
}

bool XmlReader::skip_past(std::string_view end, std::string_view what) {
  const std::size_t found = text_.find(end, at_);
  if (found == std::string_view::npos) {
    fail(tag_, "The file ends within " + std::string(what) + ".");
    return false;
  }
  at_ = found + end.size();
  return true;
}

bool XmlReader::skip_markup() {
  const auto starts_with = [&](std::string_view start) {
    if (text_.substr(at_, start.size()) != start) return false;
    at_ += start.size();
    return true;
  };
  if (starts_with("?")) return skip_past("?>", "a processing instruction");
  if (starts_with("!--")) return skip_past("-->", "a comment");
  if (starts_with("![CDATA[")) return skip_past("]]>", "a CDATA section");
  if (starts_with("!DOCTYPE")) return skip_document_type();
  fail(tag_, "'<!' starts neither a comment nor a document type here.");
  return false;
}

/// To the '>' outside quotes, comments and the square brackets of the internal subset.
bool XmlReader::skip_document_type() {
  bool in_brackets = false;
  while (at_ < text_.size()) {
    const char c = text_[at_];
    if (c == '"' || c == '\'') {
      ++at_;
      if (!skip_past(std::string_view(&c, 1), "the document type")) return false;
      continue;
    }
    if (text_.substr(at_, 4) == "<!--") {
      if (!skip_past("-->", "a comment")) return false;
      continue;
    }
    ++at_;
    if (c == '[') in_brackets = true;
    if (c == ']') in_brackets = false;
    if (c == '>' && !in_brackets) return true;
  }
  fail(tag_, "The file ends within the document type.");
  return false;
}

void XmlReader::skip_blanks() {
  at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
}

std::string_view XmlReader::read_name() {
  const std::size_t end = std::min(text_.find_first_of(" \t\r\n=/><\"'", at_), text_.size());
  const std::string_view name = text_.substr(at_, end - at_);
  at_ = end;
  return name;
}

XmlReader::Event XmlReader::read_close() {
  ++at_;
  const std::string_view name = read_name();
  skip_blanks();
  if (at_ >= text_.size() || text_[at_] != '>')
    return fail(tag_, "The closing tag </" + std::string(name.substr(0, 40)) + " has no '>'.");
  ++at_;
  if (open_.empty() || open_.back() != name)
    return fail(tag_, "</" + std::string(name.substr(0, 40)) + "> closes nothing that is open.");
  open_.pop_back();
  name_ = without_prefix(name);
  attributes_.clear();
  return Event::close;
}

XmlReader::Event XmlReader::read_open() {
  const std::string_view name = read_name();
  if (name.empty()) return fail(tag_, "'<' should be followed by the name of an element.");
  if (open_.empty() && seen_root_) return fail(tag_, "There is a second outermost element.");
  if (open_.size() >= deepest) return fail(tag_, "Elements are nested too deeply.");
  seen_root_ = true;
  name_ = name;
  attributes_.clear();
  if (!read_attributes()) return Event::error;
  note_prefixes();
  name_ = without_prefix(name);
  open_.push_back(name);
  return Event::open;
}

bool XmlReader::read_attributes() {
  while (true) {
    skip_blanks();
    if (text_.substr(at_, 1) == ">") {
      ++at_;
      return true;
    }
    if (text_.substr(at_, 2) == "/>") {
      at_ += 2;
      return closes_itself_ = true;
    }
    const std::size_t start = at_;
    XmlAttribute attribute{read_name(), {}, 0};
    skip_blanks();
    const bool equals = at_ < text_.size() && text_[at_] == '=';
    if (equals) ++at_;
    skip_blanks();
    const char quote = at_ < text_.size() ? text_[at_] : '\0';
    const std::size_t end = text_.find(quote, at_ + 1);
    if (attribute.name.empty() || !equals || (quote != '"' && quote != '\'') ||
        end == std::string_view::npos) {
      fail(start, "An attribute of <" + std::string(name_.substr(0, 40)) +
                      "> is not of the form name=\"value\".");
      return false;
    }
    attribute.byte = at_ + 1;
    attribute.raw = text_.substr(at_ + 1, end - at_ - 1);
    attributes_.push_back(attribute);
    at_ = end + 1;
  }
}

const XmlAttribute* XmlReader::find(std::string_view name) const {
  for (const XmlAttribute& attribute : attributes_)
    if (attribute.name == name) return &attribute;
  return nullptr;
}

const XmlAttribute* XmlReader::find_prefixed(std::string_view name) const {
  const XmlAttribute* found = find(name);
  for (const XmlAttribute& attribute : attributes_) {
    if (found != nullptr) break;
    const std::size_t colon = attribute.name.find(':');
    if (colon != std::string_view::npos && attribute.name.substr(colon + 1) == name)
      found = &attribute;
  }
  return found;
}

std::string xml_value(std::string_view raw) {
  constexpr std::size_t longest_entity = 12;
  std::string value;
  value.reserve(raw.size());
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const char c = raw[i];
    if (c == '&') {
      const std::size_t end = raw.substr(i, longest_entity).find(';');
      if (end != std::string_view::npos && append_entity(value, raw.substr(i + 1, end - 1))) {
        i += end;
        continue;
      }
    }
    value += c == '\t' || c == '\n' || c == '\r' ? ' ' : c;
  }
  return value;
}

}  // namespace lpq
