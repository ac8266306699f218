// See options.h.
#include "options.h"

#include <string>
#include <vector>

#include "base/nearest_name.h"
#include "marshal.h"

namespace lpq {
namespace {

/// Each returns what was expected where the value is something else, "" when it fits.
std::string read(const val& value, bool& member) {
  if (!value.isTrue() && !value.isFalse()) return "true or false";
  member = value.isTrue();
  return {};
}

template <class Number>
requires(std::is_arithmetic_v<Number>) std::string read(const val& value, Number& member) {
  if (!value.isNumber()) return "a number";
  const double number = value.as<double>();
  if constexpr (std::is_integral_v<Number>) {
    constexpr double largest = 9007199254740991.0;  // beyond it doubles skip integers
    if (!(number >= -largest && number <= largest) ||
        number != static_cast<double>(static_cast<std::int64_t>(number)))
      return "a whole number";
    if (std::is_unsigned_v<Number> && number < 0) return "0 or more";
    if constexpr (sizeof(Number) < 8)
      if (number < -2147483648.0 || number > 2147483647.0) return "a smaller number";
  }
  member = static_cast<Number>(number);
  return {};
}

template <class Choice>
requires(std::is_enum_v<Choice>) std::string read(const val& value, Choice& member) {
  std::string expected;
  const auto& names = ChoiceNames<Choice>::names;
  const std::string text = value.isString() ? value.as<std::string>() : std::string();
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (value.isString() && text == names[k]) {
      member = static_cast<Choice>(k);
      return {};
    }
    if (k > 0) expected += k + 1 < names.size() ? ", " : " or ";
    expected += std::string("'") + names[k] + "'";
  }
  return expected;
}

Error bad_option(std::string message) { return {ErrorCode::bad_option, std::move(message), {}}; }

template <class Table>
Result<Table> table_from(const val& object) {
  Table options;
  std::vector<std::string> known;
  std::string fault;
  each_field(options, [&](const char* name, auto& member, const OptionInfo&) {
    known.push_back(name);
    const val value = object[name];
    if (value.isUndefined() || !fault.empty()) return;
    const std::string expected = read(value, member);
    if (!expected.empty()) fault = std::string("Option ") + name + " must be " + expected + ".";
  });
  if (!fault.empty()) return bad_option(fault);
  for (const std::string& key : strings_from(val::global("Object").call<val>("keys", object))) {
    bool found = false;
    for (const std::string& name : known) found = found || name == key;
    if (found) continue;
    const std::string nearest = nearest_name(key, known);
    return bad_option("There is no option '" + key + "'." +
                      (nearest.empty() ? "" : " Did you mean '" + nearest + "'?"));
  }
  return options;
}

}  // namespace

Result<Options> options_from(const val& object) { return table_from<Options>(object); }
Result<SurfaceOptions> surface_options_from(const val& object) {
  return table_from<SurfaceOptions>(object);
}
Result<MeshWriteOptions> write_options_from(const val& object) {
  return table_from<MeshWriteOptions>(object);
}

}  // namespace lpq
