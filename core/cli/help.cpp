// See help.h.
#include "cli/help.h"

#include <map>
#include <string>
#include <string_view>

#include "cli/args.h"
#include "io/describe.h"
#include "io/number.h"

namespace lpq {
namespace {

/// Breaks the text at blanks into lines that start at `column`.
void append_wrapped(std::string& out, std::string_view text, std::size_t column) {
  constexpr std::size_t page = 96;
  std::size_t at = column;
  while (!text.empty()) {
    const std::size_t blank = text.find(' ');
    const std::string_view word = text.substr(0, blank);
    if (at > column && at + 1 + word.size() > page) {
      out += '\n';
      out.append(column, ' ');
      at = column;
    } else if (at > column) {
      out += ' ';
      ++at;
    }
    out += word;
    at += word.size();
    text.remove_prefix(blank == std::string_view::npos ? text.size() : blank + 1);
  }
  out += '\n';
}

/// What stands after the option: "H", "4.1|2.2", nothing for a flag.
template <class T>
std::string value_name(const T&, const OptionInfo& info) {
  if constexpr (std::is_same_v<T, bool>) {
    return {};
  } else if constexpr (std::is_enum_v<T>) {
    std::string text;
    for (const char* name : ChoiceNames<T>::names) {
      if (!text.empty()) text += '|';
      text += name;
    }
    return text;
  } else {
    const std::string_view unit = info.unit;
    return unit.empty() ? "N" : std::string(unit);
  }
}

template <class T>
std::string default_text(const T& value) {
  std::string text;
  if constexpr (std::is_enum_v<T>) {
    text = choice_name(value);
  } else if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    append_number(text, static_cast<double>(value));
  }
  return text.empty() ? text : " (" + text + ")";
}

/// "-o, --output", "--[no-]keep-groups" for what is on by itself
template <class T>
std::string flag_text(const std::string& flag, const T& value) {
  if constexpr (std::is_same_v<T, bool>)
    if (value) return "--[no-]" + flag.substr(2);
  return flag == "--output" ? "-o, " + flag : flag;
}

bool every_option(const std::string&) { return true; }

template <class Table, class Wanted>
void append_options(std::string& out, const Table& table, Wanted&& wanted) {
  constexpr std::size_t column = 34;
  each_field(table, [&](const char* name, const auto& value, const OptionInfo& info) {
    const std::string flag = option_flag(name);
    if (!wanted(flag)) return;
    std::string head = "  " + flag_text(flag, value);
    const std::string argument = value_name(value, info);
    if (!argument.empty()) head += " " + argument;
    out += head;
    if (head.size() + 2 > column) {
      out += '\n';
      out.append(column, ' ');
    } else {
      out.append(column - head.size(), ' ');
    }
    append_wrapped(out, info.help + default_text(value), column);
  });
}

/// What every option of a table is and by itself, by flag.
template <class Table>
std::map<std::string, std::string> texts_of(const Table& table) {
  std::map<std::string, std::string> texts;
  each_field(table, [&](const char* name, const auto& value, const OptionInfo& info) {
    texts[option_flag(name)] = info.help + default_text(value);
  });
  return texts;
}

/// Options that are the same for both are described once, with the domains.
void append_surface_options(std::string& out) {
  const auto planar = texts_of(Options{}), surface = texts_of(SurfaceOptions{});
  const auto is_shared = [&](const std::string& flag) {
    const auto at = planar.find(flag);
    return at != planar.end() && at->second == surface.at(flag);
  };
  std::string shared;
  for (const auto& [flag, text] : surface)
    if (is_shared(flag)) shared += (shared.empty() ? "" : ", ") + flag;
  out += "\nSurfaces\n  ";
  append_wrapped(out, "Of the method, surfaces know " + shared + " as above; and for them:", 2);
  append_options(out, SurfaceOptions{}, [&](const std::string& flag) { return !is_shared(flag); });
}

}  // namespace

std::string general_help() {
  return "lpquad - quadrilateral meshes of plane domains and of surfaces\n"
         "\n"
         "  lpquad mesh DOMAIN... -o MESH         mesh domains and surfaces\n"
         "  lpquad check MESH [--domain DOMAIN]   judge a mesh; --surface SURFACE in space\n"
         "  lpquad convert SURFACE -o X.obj       triangles of a surface, repaired\n"
         "  lpquad COMMAND --help                 all options of a command\n"
         "  lpquad --version\n"
         "\n"
         "Exit codes: 0 done, 1 the checked mesh is invalid, 2 wrong command line, 3 bad input,\n"
         "4 could not (no valid mesh found, out of memory, cannot write).\n";
}

std::string mesh_help() {
  std::string out =
      "lpquad mesh DOMAIN... -o MESH [options]\n"
      "\n"
      "Meshes each domain: .json, .geojson, .svg, .poly (Triangle), .msh (Gmsh) or .dxf; and each\n"
      "surface: .stl, .obj, .off, .ply, or .msh with triangles in space; with Node and the "
      "package\n"
      "occt-import-js also .step, .iges and .brep. '-' reads from standard input. With several\n"
      "inputs the names of output files contain {}, which stands for the input's name, or -o is a\n"
      "folder.\n"
      "\nFiles\n";
  append_options(out, MeshFiles{}, every_option);
  out += "\nMethod\n";
  append_options(out, Options{}, every_option);
  append_surface_options(out);
  return out;
}

std::string check_help() {
  std::string out =
      "lpquad check MESH.obj|MESH.msh... [options]\n"
      "\n"
      "Proves with exact arithmetic that every face is strictly convex, that faces meet edge to\n"
      "edge, and prints the quality. Of a mesh in space it looks at topology, orientation, "
      "doubles\n"
      "and convex corners. Exit code 0: valid, 1: invalid, 3: cannot be read.\n"
      "\n";
  append_options(out, CheckFiles{}, every_option);
  return out;
}

std::string convert_help() {
  std::string out =
      "lpquad convert SURFACE -o TRIANGLES.obj [options]\n"
      "\n"
      "Reads a surface as `lpquad mesh` does, repairs it as that does, and writes its triangles.\n"
      "With Node and the package occt-import-js it reads .step, .iges and .brep too.\n"
      "\n";
  append_options(out, ConvertFiles{}, every_option);
  return out;
}

std::string version_text() { return std::string("lpquad ") + version() + "\n"; }

}  // namespace lpq
