// A push reader (SAX) over nlohmann-json: every JSON value gets a role from its parent's role and
// its key, and a role accepts certain kinds of value only. So a wrong kind anywhere is one error in
// one place, with the path of the value, and nothing is stored that is not part of the domain.
#include "io/domain/json_domain.h"

#include <utility>

#include "io/domain/json_lists.h"
#include "io/domain/json_members.h"
#include "io/domain/json_roles.h"
#include "io/json_text.h"

namespace lpq {
namespace {

using json_domain::child_role;
using json_domain::expected;
using json_domain::Kind;
using json_domain::Role;

class Reader final : public JsonReader {
 public:
  explicit Reader(JsonText& text) : text_(text) {}

  bool run() { return text_.parse(*this); }
  Result<DomainFile> take() {
    if (failed_) return error_;
    if (!has_loops_ && !has_regions_)
      return fail_value(ErrorCode::parse_error,
                        "The document has neither \"loops\" nor \"regions\".");
    if (has_loops_ && has_regions_)
      return fail_value(ErrorCode::parse_error,
                        "The document has both \"loops\" and \"regions\"; give one of them.");
    return DomainFile{std::move(input_), members_.take_warnings()};
  }
  void fail(ErrorCode code, std::string message) { fail_value(code, std::move(message)); }
  bool failed() const { return failed_; }

  bool null() override { return scalar(Kind::other, "null"); }
  bool boolean(bool) override { return scalar(Kind::other, "a boolean"); }
  bool binary(binary_t&) override { return scalar(Kind::other, "binary data"); }
  bool string(string_t& value) override;
  bool start_object(std::size_t) override { return open(Kind::object); }
  bool start_array(std::size_t) override { return open(Kind::array); }
  bool end_object() override { return close(); }
  bool end_array() override { return close(); }
  bool key(string_t& value) override;
  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& problem) override;

 private:
  struct Frame {
    Role role;
    bool is_array;
    std::string key;        // of the member being read
    std::size_t count = 0;  // elements begun
  };

  Role next_role() const;
  bool begin_value(Kind kind, const char* found);
  bool scalar(Kind kind, const char* found) { return begin_value(kind, found); }
  bool number(double value) override;
  bool open(Kind kind);
  bool close();
  void store_point(Vec2 point, Role role);
  bool add_size(std::size_t count);
  void in_document_region();
  void create(Role role);
  std::string path() const;
  Error fail_value(ErrorCode code, std::string message);

  JsonText& text_;
  std::vector<Frame> frames_;
  DomainInput input_;
  json_domain::Members members_;
  bool has_loops_ = false, has_regions_ = false, failed_ = false;
  bool has_position_ = false;  // of the point being read
  double xyh_[3] = {0, 0, 0};  // of the point being read, and its size
  Error error_;
};

bool Reader::key(string_t& value) {
  frames_.back().key = std::move(value);
  if (members_.add(frames_.back().key, text_)) return true;
  fail(ErrorCode::parse_error, path() + " is there twice; give it once.");
  return false;
}

Role Reader::next_role() const {
  if (frames_.empty()) return Role::document;
  const Frame& frame = frames_.back();
  // A point of the mesh may be written [x, y] instead of {"position": [x, y]}.
  if (frame.role == Role::point && frame.is_array) return Role::coordinate;
  return child_role(frame.role, frame.key);
}

bool Reader::begin_value(Kind kind, const char* found) {
  const Role role = next_role();
  if (!frames_.empty()) ++frames_.back().count;
  if (const char* wanted = expected(role, kind)) {
    fail(ErrorCode::parse_error,
         path() + " should be " + wanted + ", but it is " + std::string(found) + ".");
    return false;
  }
  if (role == Role::ignored)
    members_.add_unknown(kind, frames_.back().is_array ? frames_.back().count : 0);
  return true;
}

bool Reader::number(double value) {
  const Role role = next_role();
  if (!begin_value(Kind::number, "a number")) return false;
  if (role == Role::size) input_.h = value;
  if (role != Role::coordinate) return true;
  const std::size_t axis = frames_.back().count - 1;
  if (axis >= (frames_.back().role == Role::size_at ? 3 : 2)) {
    fail(ErrorCode::parse_error, path() + " is a third coordinate; a point is [x, y].");
    return false;
  }
  xyh_[axis] = value;
  return true;
}

bool Reader::string(string_t& value) {
  const Role role = next_role();
  const bool bare = value.empty() && text_.is_bare_literal();
  if (bare && expected(role, Kind::number) == nullptr && role != Role::ignored) {
    ++frames_.back().count;
    fail(ErrorCode::non_finite, path() + " is NaN or infinite; coordinates are finite numbers.");
    return false;
  }
  if (!begin_value(bare ? Kind::other : Kind::string, bare ? "NaN or infinite" : "a string"))
    return false;
  if (role != Role::name) return true;
  switch (frames_.back().role) {
    case Role::region: input_.regions.back().name = std::move(value); break;
    case Role::tag_list: input_.regions.back().tags.back().push_back(std::move(value)); break;
    case Role::polyline: input_.polylines.back().tag = std::move(value); break;
    case Role::point: input_.points.back().tag = std::move(value); break;
    default: break;
  }
  return true;
}

bool Reader::open(Kind kind) {
  const Role role = next_role();
  if (!begin_value(kind, kind == Kind::object ? "an object" : "an array")) return false;
  if (frames_.size() >= json_max_depth) {
    fail(ErrorCode::parse_error, path().substr(0, 80) + ".. is nested more than " +
                                     std::to_string(json_max_depth) + " deep.");
    return false;
  }
  create(role);
  frames_.push_back({role, kind == Kind::array, {}, 0});
  members_.open(role);
  return true;
}

/// Loops and tags beside each other in the document itself are those of its one region.
void Reader::in_document_region() {
  if (frames_.back().role != Role::document) return;
  has_loops_ = true;
  if (input_.regions.empty()) input_.regions.emplace_back();
}

void Reader::create(Role role) {
  switch (role) {
    case Role::loop_list:
      in_document_region();
      input_.regions.back().loops.clear();
      break;
    case Role::region_list: has_regions_ = true; break;
    case Role::region: input_.regions.emplace_back(); break;
    case Role::loop:
      if (frames_.back().role == Role::polyline) {
        input_.polylines.back().points.clear();
      } else {
        input_.regions.back().loops.emplace_back();
      }
      break;
    case Role::tag_table:
      in_document_region();
      input_.regions.back().tags.clear();
      break;
    case Role::tag_list: input_.regions.back().tags.emplace_back(); break;
    case Role::polyline: input_.polylines.emplace_back(); break;
    case Role::point:
      input_.points.emplace_back();
      has_position_ = false;
      break;
    case Role::position: has_position_ = true; break;
    case Role::guide: input_.guides.emplace_back(); break;
    default: break;
  }
}

bool Reader::close() {
  const Frame frame = std::move(frames_.back());
  members_.close(text_);
  if (frame.role == Role::point && !frame.is_array && !has_position_) {
    fail(ErrorCode::parse_error, "A point is missing its \"position\": [x, y].");
    return false;
  }
  const bool is_point =
      frame.is_array && (frame.role == Role::coordinates || frame.role == Role::position ||
                         frame.role == Role::point);
  frames_.pop_back();
  if (frame.role == Role::size_at) return add_size(frame.count);
  if (!is_point) return true;
  if (frame.count != 2) {
    fail(ErrorCode::parse_error, path() + " should be a point [x, y], but it has " +
                                     std::to_string(frame.count) + " coordinates.");
    return false;
  }
  store_point({xyh_[0], xyh_[1]}, frame.role);
  return true;
}

void Reader::store_point(Vec2 point, Role role) {
  if (role != Role::coordinates) {
    input_.points.back().position = point;
  } else if (frames_.back().role == Role::guide) {
    input_.guides.back().push_back(point);
  } else if (frames_.back().role == Role::seed_list) {
    input_.seeds.push_back(point);
  } else if (frames_[frames_.size() - 2].role == Role::polyline) {
    input_.polylines.back().points.push_back(point);
  } else {
    input_.regions.back().loops.back().push_back(point);
  }
}

bool Reader::add_size(std::size_t count) {
  if (count == 3) {
    input_.sizes.push_back({{xyh_[0], xyh_[1]}, xyh_[2]});
    return true;
  }
  fail(ErrorCode::parse_error, path() + " should be a point with its size [x, y, h], but it has " +
                                   std::to_string(count) + " numbers.");
  return false;
}

bool Reader::parse_error(std::size_t, const std::string& token,
                         const nlohmann::detail::exception& problem) {
  if (failed_) return false;
  if (!frames_.empty() && frames_.back().is_array) ++frames_.back().count;
  if (problem.id == json_number_overflow) {
    fail(ErrorCode::non_finite,
         path() + " is too large for a double: " + token.substr(0, 40) + ".");
  } else if (text_.is_blank()) {
    fail(ErrorCode::parse_error, "This is not valid JSON: the text is empty.");
  } else if (text_.at_end() && !frames_.empty()) {
    fail(ErrorCode::parse_error, "This is not valid JSON: the text ends within " + path() + ".");
  } else {
    const bool in_value =
        !frames_.empty() && (frames_.back().is_array || !frames_.back().key.empty());
    const std::string where = in_value ? " at " + path() : "";
    fail(ErrorCode::parse_error, "This is not valid JSON: unexpected text" + where + ".");
  }
  return false;
}

std::string Reader::path() const {
  std::string result;
  for (const Frame& frame : frames_) {
    if (frame.is_array) {
      result += '[';
      result += std::to_string(frame.count == 0 ? 0 : frame.count - 1);
      result += ']';
    } else if (!frame.key.empty()) {
      if (!result.empty()) result += '.';
      result += frame.key.substr(0, 40);
    }
  }
  return result.empty() ? "The document" : result;
}

Error Reader::fail_value(ErrorCode code, std::string message) {
  error_ = text_.error(code, std::move(message));
  failed_ = true;
  return error_;
}

Result<DomainFile> parse_file(std::string_view text) {
  if (text.size() > json_max_text)
    return Error{ErrorCode::too_large, "The JSON text is larger than 1 GiB.", {}};
  JsonText json(text);
  Reader reader(json);
  const bool complete = reader.run();
  if (!complete && !reader.failed()) reader.fail(ErrorCode::parse_error, "This is not valid JSON.");
  return reader.take();
}

}  // namespace

Result<DomainFile> read_json_domain(std::string_view text) {
  auto file = parse_file(text);
  if (!file) return file;
  if (auto error = fit_lists(file->domain, file->warnings)) return *std::move(error);
  return file;
}

}  // namespace lpq
