// See dxf_groups.h.
#include "io/domain/dxf_groups.h"

#include <cmath>

#include "io/number.h"
#include "io/plain_text.h"

namespace lpq {
namespace {

constexpr std::string_view blanks = " \t";

Error error_at_line(std::string message, std::int64_t line, std::int64_t byte) {
  Error error{ErrorCode::parse_error, std::move(message), {}};
  error.where.set_line(line, byte);
  return error;
}

}  // namespace

bool DxfGroups::next(DxfGroup& group) {
  if (lines_.at_end()) return false;
  if (!parse_integer(trimmed(lines_.next(), blanks), group.code)) {
    malformed_ = true;
    return false;
  }
  if (lines_.at_end()) return false;
  group.value = trimmed(lines_.next(), blanks);
  group.line = lines_.line();
  group.byte = lines_.byte();
  return true;
}

void DxfFields::fail(const Error& error) {
  if (!failed_) error_ = error;
  failed_ = true;
}

void DxfFields::fail(const std::string& clause) {
  fail(error_at_line("The " + std::string(entity_.type.substr(0, 40)) + " " + clause + ".",
                     entity_.line, entity_.byte));
}

const DxfGroup* DxfFields::find(std::int64_t code) const {
  for (const DxfGroup& group : entity_.groups)
    if (group.code == code) return &group;
  return nullptr;
}

std::string_view DxfFields::text(std::int64_t code) const {
  const DxfGroup* group = find(code);
  return group == nullptr ? std::string_view() : group->value;
}

double DxfFields::number(const DxfGroup& group) {
  double value = 0;
  if (!parse_number(group.value, value))
    fail(error_at_line(std::string(group.value.substr(0, 40)).append(" is not a number."),
                       group.line, group.byte));
  return value;
}

double DxfFields::number(std::int64_t code) {
  const DxfGroup* group = find(code);
  if (group == nullptr) fail("has no group " + std::to_string(code));
  return group == nullptr ? 0 : number(*group);
}

double DxfFields::optional_number(std::int64_t code, double otherwise) {
  const DxfGroup* group = find(code);
  return group == nullptr ? otherwise : number(*group);
}

unsigned DxfFields::flags() {
  const double value = optional_number(70, 0);
  return value >= 0 && value < 65536 ? static_cast<unsigned>(value) : 0;
}

bool DxfFields::is_mirrored() {
  const double x = optional_number(210, 0), y = optional_number(220, 0),
               z = optional_number(230, 1);
  constexpr double negligible = 1e-9;
  if (!(std::abs(x) <= negligible * std::abs(z) && std::abs(y) <= negligible * std::abs(z)))
    fail("does not lie in the xy plane");
  return z < 0;
}

}  // namespace lpq
