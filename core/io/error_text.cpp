// See error_text.h.
#include "io/error_text.h"

#include "io/number.h"

namespace lpq {
namespace {

/// Calls visit(name, value) for every part of `where` that applies.
template <class Visit>
void each_place(const Where& where, Visit&& visit) {
  const auto index = [&](const char* name, std::int64_t value) {
    if (value != none) visit(name, value);
  };
  index("region", where.region);
  index("guide", where.guide);
  index("loop", where.loop);
  index("edge", where.edge);
  index("otherLoop", where.other_loop);
  index("otherEdge", where.other_edge);
  index("line", where.line);
  index("byte", where.byte);
}

/// An edge without a loop in an error about two edges is one of a polyline.
std::string place_text(const Where& where) {
  std::string text;
  const bool on_polyline = where.other_edge != none && where.other_loop == none;
  each_place(where, [&](const char* name, std::int64_t value) {
    const std::string_view key = name;
    const bool is_other = key == "otherEdge";
    const bool goes_on = key == "edge" || (is_other && !on_polyline) || key == "byte";
    if (!text.empty()) text += goes_on ? " " : ", ";
    if (is_other && on_polyline) text += "polyline ";
    text += key == "otherLoop" ? "loop" : is_other ? "edge" : key;
    text += ' ';
    append_integer(text, value);
  });
  if (where.has_point) {
    text += text.empty() ? "at " : ", at ";
    append_numbers(text, {where.x, where.y});
  }
  return text;
}

}  // namespace

std::string error_text(const Error& error) {
  std::string text = code_name(error.code);
  text += ": ";
  text += error.message;
  const std::string place = place_text(error.where);
  if (!place.empty()) text += " (" + place + ")";
  return text;
}

void append_error(JsonWriter& json, const Error& error) {
  json.begin_object();
  json.member("code", code_name(error.code));
  json.member("message", error.message);
  json.begin_object("where");
  each_place(error.where, [&](const char* name, std::int64_t value) { json.member(name, value); });
  if (error.where.has_point) {
    json.member("x", error.where.x);
    json.member("y", error.where.y);
  }
  json.end_object();
  json.end_object();
}

std::string errors_json(const std::vector<Error>& errors) {
  std::string out;
  JsonWriter json(out);
  json.begin_array();
  for (const Error& error : errors) append_error(json, error);
  json.end_array();
  return out;
}

std::string write_error_json(const Error& error) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  json.key("error");
  append_error(json, error);
  json.end_object();
  out += '\n';
  return out;
}

}  // namespace lpq
