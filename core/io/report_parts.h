// What the reports of domains and of surfaces have in common: quality, sizes, times, warnings.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "base/option_table.h"
#include "io/json_write.h"
#include "mesh/quality.h"
#include "pipeline/report.h"

namespace lpq {

struct ReportFormat {
  bool times = true;  // off: the same run gives the same bytes
};

/// 16 hexadecimal digits: a 64-bit number does not fit JavaScript's.
std::string hash_text(std::uint64_t hash);

// Members of the JSON report.
void append_quality(JsonWriter& json, const QuadQuality& quality);
void append_size(JsonWriter& json, const SizeFidelity& size);
void append_times(JsonWriter& json, const std::vector<StageTime>& times);  // and a line break
void append_warnings(JsonWriter& json, const std::vector<Warning>& warnings);
template <class Table>
void append_options(JsonWriter& json, const Table& options) {
  json.begin_object("options");
  each_field(options, [&](const char* name, const auto& value, const OptionInfo&) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_enum_v<T>) {
      json.member(name, choice_name(value));
    } else {
      json.member(name, value);
    }
  });
  json.end_object();
}

// Rows of the text.
/// Its part on quality alone: "quads 1600, ...".
std::string quality_text(const QuadQuality& quality);
std::string size_text(const SizeFidelity& size);
/// Times, then warnings.
std::string end_text(const std::vector<StageTime>& times, const std::vector<Warning>& warnings);

/// "name      text\n" with the texts in one column.
void append_row(std::string& out, std::string_view name, std::string_view text);

/// "label value, label value"
class Facts {
 public:
  Facts& add(std::string_view label, double value) {
    next(label);
    append_short_number(value);
    return *this;
  }
  Facts& count(std::string_view label, std::int64_t value) {
    next(label);
    append_integer(text_, value);
    return *this;
  }
  Facts& unit(std::string_view unit) {
    text_ += unit;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  void append_short_number(double value);
  void next(std::string_view label) {
    if (!text_.empty()) text_ += ", ";
    text_ += label;
    if (!label.empty()) text_ += ' ';
  }
  std::string text_;
};

}  // namespace lpq
