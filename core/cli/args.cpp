// See args.h.
#include "cli/args.h"

#include "base/nearest_name.h"
#include "base/words.h"
#include "io/number.h"

namespace lpq {
namespace {

std::string limits_text(const OptionInfo& info) {
  return "a number between " + short_number(info.min) + " and " + short_number(info.max);
}

/// The text as a value of the member's type; returns what was expected where it is not one.
std::string set_value(std::string& member, std::string_view text, const OptionInfo&) {
  if (text.empty()) return "a file name";
  member = text;
  return {};
}

template <class Number>
requires(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>) std::string
    set_value(Number& member, std::string_view text, const OptionInfo& info) {
  double number = 0;
  if (!parse_number(text, number) || !(number >= info.min && number <= info.max)) {
    return limits_text(info);
  }
  if constexpr (std::is_integral_v<Number>) {
    std::int64_t integer = 0;  // not through the double: seeds have more digits than it keeps
    if (!parse_integer(text, integer)) return "a whole number";
    member = static_cast<Number>(integer);
  } else {
    member = number;
  }
  return {};
}

template <class Choice>
requires std::is_enum_v<Choice> std::string set_value(Choice& member, std::string_view text,
                                                      const OptionInfo&) {
  std::string expected;
  for (std::size_t k = 0; k < ChoiceNames<Choice>::names.size(); ++k) {
    if (text == ChoiceNames<Choice>::names[k]) {
      member = static_cast<Choice>(k);
      return {};
    }
    if (k > 0) expected += k + 1 < ChoiceNames<Choice>::names.size() ? ", " : " or ";
    expected += ChoiceNames<Choice>::names[k];
  }
  return expected;
}

/// What was meant: the one name that begins so (`--h`), or else the nearest.
std::string likely_name(std::string_view flag, std::span<const std::string> names) {
  std::string begun;
  for (const std::string& name : names) {
    if (flag.size() < 3 || name.compare(0, flag.size(), flag) != 0 || name == begun) continue;
    if (!begun.empty()) return nearest_name(flag, names);
    begun = name;
  }
  return begun.empty() ? nearest_name(flag, names) : begun;
}

/// One walk over the arguments; `Tables` are option structs with each_field.
class ArgParser {
 public:
  explicit ArgParser(std::span<const std::string_view> args) : args_(args) {}

  template <class... Tables>
  Problem parse(std::vector<std::string>& inputs, bool& help, Tables&... tables) {
    bool only_inputs = false;
    for (next_ = 0; next_ < args_.size() && error_.empty();) {
      const std::string_view arg = args_[next_++];
      if (only_inputs || arg.size() < 2 || arg[0] != '-') {
        inputs.emplace_back(arg);
      } else if (arg == "--") {
        only_inputs = true;
      } else if (arg == "-h" || arg == "--help") {
        help = true;
      } else {
        parse_option(arg, tables...);
      }
    }
    if (!error_.empty()) return usage(error_);
    return {};
  }
  /// The options that were there, by their flags.
  const std::vector<std::string>& given() const { return given_; }

 private:
  template <class... Tables>
  void parse_option(std::string_view arg, Tables&... tables) {
    const std::size_t equals = arg.find('=');
    std::string_view flag = arg.substr(0, equals);
    if (flag == "-o") flag = "--output";
    has_inline_ = equals != std::string_view::npos;
    inline_ = has_inline_ ? arg.substr(equals + 1) : std::string_view();
    bool found = false;
    std::vector<std::string> names{"--help"};
    // Tables may share an option; all of them get its value.
    const std::size_t value_at = next_;
    const auto try_field = [&](const char* name, auto& member, const OptionInfo& info) {
      names.push_back(option_flag(name));
      const bool is_negated = negates(flag, names.back(), member);
      if (!error_.empty() || (names.back() != flag && !is_negated)) return;
      if (!found) given_.push_back(names.back());
      found = true;
      next_ = value_at;
      set_member(std::string(flag), !is_negated, member, info);
    };
    (..., each_field(tables, try_field));
    if (found) return;
    error_ = "There is no option " + std::string(flag) + ".";
    const std::string nearest = likely_name(flag, names);
    if (!nearest.empty()) error_ += " Did you mean " + nearest + "?";
  }

  /// "--no-quiet" and "--quiet"
  template <class Member>
  static bool negates(std::string_view flag, std::string_view name, const Member&) {
    return std::is_same_v<Member, bool> && flag.substr(0, 5) == "--no-" &&
           flag.substr(5) == name.substr(2);
  }

  template <class Member>
  void set_member(const std::string& flag, bool is_on, Member& member, const OptionInfo& info) {
    if constexpr (std::is_same_v<Member, bool>) {
      member = is_on;
      if (has_inline_) error_ = "Option " + flag + " takes no value.";
    } else {
      if (!has_inline_ && next_ == args_.size()) {
        error_ = "Option " + flag + " needs a value.";
        return;
      }
      const std::string_view text = has_inline_ ? inline_ : args_[next_++];
      // A file may be called like an option, but then it is given as --report=--quiet.
      if (!has_inline_ && text.substr(0, 2) == "--") {
        error_ = "Option " + flag + " needs a value, and '" + std::string(text) +
                 "' looks like an option.";
        return;
      }
      const std::string expected = set_value(member, text, info);
      if (expected.empty()) return;
      error_ = "Option " + flag + " must be " + expected + ", not '" + std::string(text) + "'.";
    }
  }

  std::span<const std::string_view> args_;
  std::size_t next_ = 0;
  std::string_view inline_;  // of --name=value
  bool has_inline_ = false;
  std::vector<std::string> given_;
  std::string error_;
};

}  // namespace

std::string option_flag(std::string_view name) {
  std::string flag = "--";
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z') {
      flag += '-';
      flag += static_cast<char>(c - 'A' + 'a');
    } else {
      flag += c;
    }
  }
  return flag;
}

Result<MeshArgs> parse_mesh_args(std::span<const std::string_view> args) {
  MeshArgs result;
  ArgParser parser(args);
  if (const Problem wrong = parser.parse(result.inputs, result.help, result.files, result.options,
                                         result.surface_options))
    return *wrong;
  // Before anything is read: the size may say how.
  if (const Problem both = judge_size_options(result.options)) return usage(both->message);
  result.given = parser.given();
  return result;
}

namespace {

template <class Args>
Result<Args> parse_plain(std::span<const std::string_view> args) {
  Args result;
  if (const Problem wrong = ArgParser(args).parse(result.inputs, result.help, result.files))
    return *wrong;
  return result;
}

}  // namespace

Result<CheckArgs> parse_check_args(std::span<const std::string_view> args) {
  return parse_plain<CheckArgs>(args);
}

Result<ConvertArgs> parse_convert_args(std::span<const std::string_view> args) {
  return parse_plain<ConvertArgs>(args);
}

}  // namespace lpq
