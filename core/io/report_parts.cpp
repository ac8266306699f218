// See report_parts.h.
#include "io/report_parts.h"

#include <cmath>

#include "io/error_text.h"

namespace lpq {

std::string hash_text(std::uint64_t hash) {
  constexpr char hex[] = "0123456789abcdef";
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += hex[(hash >> shift) & 15];
  return text;
}

void append_quality(JsonWriter& json, const QuadQuality& quality) {
  json.begin_object("quality");
  json.member("etaMean", quality.eta_mean);
  json.member("etaMin", quality.eta_min);
  json.member("etaP5", quality.eta_p5);
  json.member("interiorVertices", quality.interior_vertices);
  json.member("fourValentPercent", quality.four_valent_percent);
  json.member("inverted", quality.inverted);
  json.member("nonconvex", quality.nonconvex);
  json.array("valenceHistogram", quality.valence_histogram);
  json.array("etaHistogram", quality.eta_histogram);
  json.end_object();
}

void append_size(JsonWriter& json, const SizeFidelity& size) {
  json.begin_object("size");
  json.member("p10", size.p10);
  json.member("p50", size.p50);
  json.member("p90", size.p90);
  json.member("min", size.min);
  json.member("max", size.max);
  json.end_object();
}

void append_times(JsonWriter& json, const std::vector<StageTime>& times) {
  json.begin_object("cpuSeconds");
  for (const StageTime& time : times) json.member(time.stage, time.cpu_seconds);
  json.end_object();
  json.new_line();
}

void append_warnings(JsonWriter& json, const std::vector<Warning>& warnings) {
  json.begin_array("warnings");
  for (const Warning& warning : warnings) append_error(json, warning);
  json.end_array();
}

std::string quality_text(const QuadQuality& quality) {
  std::string out;
  append_row(out, "faces",
             Facts().count("quads", quality.quads).count("triangles", quality.triangles).text());
  append_row(out, "shape eta",
             Facts()
                 .add("mean", quality.eta_mean)
                 .add("5th percentile", quality.eta_p5)
                 .add("least", quality.eta_min)
                 .text());
  append_row(out, "interior",
             Facts()
                 .count("vertices", quality.interior_vertices)
                 .add("four-valent", quality.four_valent_percent)
                 .unit(" %")
                 .text());
  if (quality.inverted + quality.nonconvex > 0) {
    append_row(
        out, "invalid",
        Facts().count("inverted", quality.inverted).count("nonconvex", quality.nonconvex).text());
  }
  return out;
}

std::string size_text(const SizeFidelity& size) {
  std::string out;
  append_row(out, "size / target",
             Facts()
                 .add("p10", size.p10)
                 .add("p50", size.p50)
                 .add("p90", size.p90)
                 .add("least", size.min)
                 .add("largest", size.max)
                 .text());
  return out;
}

std::string end_text(const std::vector<StageTime>& times, const std::vector<Warning>& warnings) {
  std::string out;
  Facts facts;
  double total = 0;
  for (const StageTime& time : times) {
    facts.add(time.stage, time.cpu_seconds).unit(" s");
    total += time.cpu_seconds;
  }
  append_row(out, "CPU time", facts.add("total", total).unit(" s").text());
  for (const Warning& warning : warnings) append_row(out, "warning", error_text(warning));
  return out;
}

void Facts::append_short_number(double value) {
  const double magnitude = std::fabs(value);
  const int decimals = magnitude >= 100 ? 1 : magnitude >= 10 ? 2 : 3;
  append_fixed(text_, value, decimals);
}

void append_row(std::string& out, std::string_view name, std::string_view text) {
  constexpr std::size_t column = 14;
  out += name;
  out.append(name.size() < column ? column - name.size() : 1, ' ');
  out += text;
  out += '\n';
}

}  // namespace lpq
