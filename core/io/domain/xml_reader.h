// The tags of an XML 1.0 text, one after another (W3C, Extensible Markup Language, 5th edition).
// Prefixes of names count from where they are bound to the end of the text. Comments, CDATA,
// processing instructions and the document type are passed over; entities that a document type
// defines are not expanded, so that no text can grow.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace lpq {

struct XmlAttribute {
  std::string_view name, raw;  // raw: as written between the quotes
  std::size_t byte = 0;        // of raw in the text
};

class XmlReader {
 public:
  /// The text must stay where it is. From a '<' at `start`: that element alone, up to its closing
  /// tag.
  explicit XmlReader(std::string_view text, std::size_t start = 0);
  /// One that reads from that '<' in the same text, and knows the prefixes that this one knows.
  XmlReader at(std::size_t start) const;

  enum class Event { open, close, end, error };
  /// An element without content gives `open` and then `close`. After `end` or `error` no more.
  Event next();

  /// Of the tag read last; without "svg:" and prefixes that the text binds to SVG's namespace.
  std::string_view name() const { return name_; }
  std::size_t byte() const { return tag_; }  // of its '<'
  bool closes_itself() const { return closes_itself_; }
  /// The first byte that is not read yet.
  std::size_t position() const { return at_; }
  /// The attribute of that full name, or null.
  const XmlAttribute* find(std::string_view name) const;
  /// The attribute of that name, else one with a prefix before it, or null.
  const XmlAttribute* find_prefixed(std::string_view name) const;
  const Error& error() const { return error_; }

 private:
  Event fail(std::size_t byte, std::string message);
  bool skip_markup();
  bool skip_past(std::string_view end, std::string_view what);
  bool skip_document_type();
  Event read_close();
  Event read_open();
  bool read_attributes();
  void skip_blanks();
  std::string_view read_name();
  void note_prefixes();
  std::string_view without_prefix(std::string_view name) const;

  std::string_view text_;
  std::size_t at_ = 0, tag_ = 0;
  std::string_view name_;
  std::vector<XmlAttribute> attributes_;
  std::vector<std::string_view> open_;  // names of the elements around, as written
  std::vector<std::string_view> prefixes_{"svg"};
  bool closes_itself_ = false, seen_root_ = false;
  Error error_;
};

/// The value of an attribute: &amp; &lt; &gt; &quot; &apos; and character numbers replaced, white
/// space as blanks. Other entities stay as they are written.
std::string xml_value(std::string_view raw);

}  // namespace lpq
